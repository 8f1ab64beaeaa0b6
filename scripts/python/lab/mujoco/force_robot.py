"""A robot in the force mode of its maker, in MuJoCo: it is commanded a wrench, and moves at a speed in proportion to
the difference between that wrench and the one that it measures."""

import dataclasses

import mujoco
import numpy as np

from lab.mujoco import arm_world
from lab.mujoco.arm import ArmPlayer, start_configuration
from lab.mujoco.control import GraspError, State
from lab.mujoco.plans import Plan
from lab.mujoco.position_robot import PositionPlayer, rotation_of
from lab.mujoco.rotations import rotation_matrix
from lab.mujoco.world import Contact

# Bounds the motion of joints where an arm is singular.
LEAST_DAMPING = 1e-8


@dataclasses.dataclass(frozen=True)
class ForceMode:
    """Mass, damping and deadband of the measured wrench along six axes."""

    mass: np.ndarray
    damping: np.ndarray
    deadband: np.ndarray

    def twist(
        self, twist: np.ndarray, wrench: np.ndarray, measured: np.ndarray, limits: np.ndarray, seconds: float
    ) -> np.ndarray:
        """The twist after a period in which the tool is told to apply a wrench and measures another one, each
        component within its limit."""
        measured = measured - np.clip(measured, -self.deadband, self.deadband)
        # The speed follows within the time in which the damping stops the mass.
        after = (self.mass * twist + seconds * (wrench + measured)) / (self.mass + seconds * self.damping)
        return np.clip(after, -limits, limits)


class ForcePlayer(PositionPlayer):
    """The flange in force mode. It is commanded the spring of the impedance law, and the force that moves it with its
    reference; the damping is that of force mode."""

    def __init__(self, model: mujoco.MjModel, plan: Plan, window: int) -> None:
        robot = plan.position_robot
        super().__init__(model, plan, window, robot)
        self.mode = ForceMode(*(np.repeat(pair, 3) for pair in (robot.mass, robot.damping, robot.deadband)))
        self.limits = np.repeat(robot.speed, 3)

    def begin(self, samples: list[State], grasp_error: GraspError) -> None:
        """Also puts force mode at rest."""
        super().begin(samples, grasp_error)
        self.twist = np.zeros(6)

    def sample(self, reference: np.ndarray) -> None:
        """One sample of force mode, in the axes of the world."""
        wrench, measured = self.commanded(reference), np.concatenate(self.wrench)
        self.twist = self.mode.twist(self.twist, wrench, measured, self.limits, self.robot.period)
        self.go_on(self.robot.period)

    def go_on(self, seconds: float) -> None:
        """The command moves with the twist for a time."""
        position, rotation = self.command
        self.command = position + seconds * self.twist[:3], rotation_of(seconds * self.twist[3:]) @ rotation

    def commanded(self, reference: np.ndarray) -> np.ndarray:
        """The wrench of the impedance law (Eq. impedancewrench) at the flange, without the damping of its velocity."""
        position, rotation = self.believed(reference)
        turn = np.zeros(4)
        mujoco.mju_mat2Quat(turn, (rotation @ self.flange[1].T).flatten())
        stiffness, damping = self.robot.stiffness, self.robot.damping
        spin = rotation_matrix(reference[3:7]) @ reference[10:13]
        force = stiffness[0] * (position - self.flange[0]) + damping[0] * reference[7:10]
        return np.concatenate([force, 2 * stiffness[1] * turn[0] * turn[1:] + damping[1] * spin])


class ForceArmPlayer(ForcePlayer):
    """An arm in force mode: its joints follow their commands as servos do. Of the arm itself, only the kinematics is
    used."""

    def __init__(self, model: mujoco.MjModel, plan: Plan, window: int) -> None:
        super().__init__(model, plan, window)
        self.arm = ArmPlayer(arm_world.build(plan, Contact(0.0, self.time_step)), plan, window)
        self.jacobian = np.zeros((6, self.arm.model.nv))
        # Samples of the last motion, and where the joints begin it.
        self.known: tuple[list[State], np.ndarray] | None = None

    def begin(self, samples: list[State], grasp_error: GraspError) -> None:
        """Also puts the joints where the flange is."""
        super().begin(samples, grasp_error)
        if self.known is None or self.known[0] is not samples:
            self.known = samples, start_configuration(self.arm.model, self.plan.robot, samples)
        self.joints = self.known[1].copy()
        self.rates = np.zeros(len(self.joints))
        self.move()
        self.hold(self.joints)

    def go_on(self, seconds: float) -> None:
        """The commanded joints move with the twist for a time."""
        jacobian = self.jacobian
        square = jacobian @ jacobian.T + LEAST_DAMPING * np.eye(6)
        self.command = self.command + seconds * (jacobian.T @ np.linalg.solve(square, self.twist))

    def follow(self, *joints: np.ndarray) -> None:
        """The servos of all joints: critically damped, in small steps."""
        ahead = np.array(joints) - self.joints
        self.rates = self.rates + self.time_step * (self.rate**2 * ahead - 2 * self.rate * self.rates)
        self.joints = self.joints + self.time_step * self.rates
        self.move()

    def move(self) -> None:
        """Puts the flange where the joints have it."""
        model, data, site = self.arm.model, self.arm.data, self.arm.grasp
        data.qpos[:] = self.joints
        mujoco.mj_kinematics(model, data)
        mujoco.mj_comPos(model, data)
        mujoco.mj_jacSite(model, data, self.jacobian[:3], self.jacobian[3:], site)
        rotation = data.site_xmat[site].reshape(3, 3) @ rotation_matrix(self.turned).T
        self.flange = data.site_xpos[site].copy(), rotation
        twist = self.jacobian @ self.rates
        self.speed = [twist[:3], twist[3:]]
