"""Stand-in for the package franky-control: what the player uses, with the same signatures. Each look at the state lets
two milliseconds of the simulated robot pass, in which its controller holds its torques; the real one computes them
twice."""

import atexit

import numpy as np

import rotations
from lab.players.impedance_controller import ImpedanceController
from lab.players.simulated_arm import SimulatedArm, Task

PERIOD = 0.002
BIG = 1e3


class Exception(Exception):
    """All of the package's failures."""


class Affine:
    def __init__(self, translation: np.ndarray, quaternion: np.ndarray) -> None:
        self.translation, self.quaternion = np.array(translation), np.array(quaternion)


class Twist:
    def __init__(self, linear_velocity: np.ndarray | None = None, angular_velocity: np.ndarray | None = None) -> None:
        self.linear, self.angular = linear_velocity, angular_velocity


class CartesianReference:
    def __init__(
        self, target: Affine = ..., target_twist: Twist | None = None, target_acceleration: object | None = None
    ) -> None:
        self.target, self.target_twist = target, target_twist


class CartesianImpedanceGains:
    def __init__(self, translational_stiffness: float = 500.0, rotational_stiffness: float = 50.0) -> None:
        self.stiffness = np.diag([translational_stiffness] * 3 + [rotational_stiffness] * 3)
        self.damping = 2 * np.sqrt(self.stiffness)


class CartesianImpedanceTrackingMotion:
    def __init__(
        self,
        translational_stiffness: float = 500,
        rotational_stiffness: float = 50,
        force_constraints: object | None = None,
        posture_task: object | None = None,
        manipulability_task: object | None = None,
        max_delta_tau: float = 1.0,
        lower_joint_limits: np.ndarray | None = None,
        upper_joint_limits: np.ndarray | None = None,
        joint_limit_activation_distance: float = 0.1,
        joint_limit_stiffness: float = 4.0,
        joint_limit_damping: float = 1.0,
        joint_limit_max_torque: float = 5.0,
        translational_error_clip: np.ndarray = np.full(3, BIG),
        rotational_error_clip: np.ndarray = np.full(3, BIG),
        gains_time_constant: float = 0.1,
        friction: object | None = None,
    ) -> None:
        self.gains = CartesianImpedanceGains(translational_stiffness, rotational_stiffness)
        self.reference: CartesianReference | None = None

    def set_gains(self, gains: CartesianImpedanceGains) -> None:
        self.gains = gains

    def get_gains(self) -> CartesianImpedanceGains:
        return self.gains

    def set_reference(self, reference: CartesianReference) -> None:
        before, self.reference = self.reference, reference
        assert before is None or before.target.quaternion @ reference.target.quaternion > 0, (
            "the quaternion changes its sign"
        )


class TorqueStopMotion:
    pass


class Duration:
    def __init__(self, seconds: float) -> None:
        self.seconds = seconds

    def to_sec(self) -> float:
        return self.seconds


class RobotState:
    def __init__(self, arm: SimulatedArm) -> None:
        said = arm.said()
        w, x, y, z = rotations.quaternion(said.rotation)
        self.O_T_EE = Affine(said.pose, np.array([x, y, z, w]))
        self.q, self.dq = said.positions, said.speeds
        # What the robot applies to its environment.
        self.O_F_ext_hat_K = -said.wrench
        self.time = Duration(said.time)


class Robot:
    def __init__(self, fci_hostname: str) -> None:
        self.arm = SimulatedArm(Task.read())
        # The connection ends with the program.
        atexit.register(self.arm.leave)
        self.motion: CartesianImpedanceTrackingMotion | None = None

    def set_collision_behavior(self, torque_thresholds: object, force_thresholds: object) -> None:
        pass

    def move(
        self, motion: object, asynchronous: bool = False, limit_rate: bool = False, cutoff_frequency: float = 100.0
    ) -> None:
        assert asynchronous
        if isinstance(motion, TorqueStopMotion):
            self.motion, self.arm.mode = None, "position"
            return
        self.motion, self.arm.mode = motion, "torque"
        self.controller = ImpedanceController(self.arm, PERIOD)

    def join_motion(self, timeout: float | None = None) -> bool:
        return True

    @property
    def has_errors(self) -> bool:
        return self.arm.fails("protective")

    @property
    def is_in_control(self) -> bool:
        if self.arm.fails("disconnect"):
            self.arm.mode = "position"
            return False
        return self.motion is not None

    @property
    def state(self) -> RobotState:
        if not self.arm.fails("hang"):
            self.step()
        if self.arm.fails("gap"):
            self.arm.time += 0.2
        return RobotState(self.arm)

    def step(self) -> None:
        """One period of the controller."""
        if self.motion is None:
            self.arm.rest(PERIOD)
            return
        controller, reference = self.controller, self.motion.reference
        controller.stiffness, controller.damping = self.motion.gains.stiffness, self.motion.gains.damping
        x, y, z, w = reference.target.quaternion
        controller.position, controller.rotation = (
            reference.target.translation,
            rotations.matrix(np.array([w, x, y, z])),
        )
        twist = reference.target_twist
        self.arm.obey(np.array([*reference.target.translation, *reference.target.quaternion]))
        controller.twist = np.zeros(6) if twist is None else np.concatenate([twist.linear, twist.angular])
        controller.step()
