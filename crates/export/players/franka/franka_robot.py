"""A robot of Franka Robotics, by the package franky-control: its Cartesian impedance controller runs at 1 kHz in a thread of its
own and follows the reference that it is given."""

import argparse
import time

import franky
import numpy as np

import rotations
from exported_plan import ExportedPlan, ToolState
from failures import ConnectionLost, InputError
from guards import Limits, Measurement, require_later
from kinematics import Pose
from settings import Settings

# Time between two references (s).
PERIOD = 0.002
# Longest wait (s) for a new measurement.
PATIENCE = 0.1
# The controller clips errors of the pose. What the guards let pass must not be clipped.
CLIP_MARGIN = 1.5
# The robot stops by itself at this many times the force and torque at which the player does: the player says why it stopped.
REFLEX_MARGIN = 1.5
# Torques of joints (Nm) at which it does, and all thresholds after a session (Nm, N): those of the examples of libfranka.
REFLEX_TORQUE, USUAL_TORQUE, USUAL_FORCE = 40.0, 20.0, 20.0
# Gains that are read back are those that were set, but for rounding.
SAME_GAINS = 1e-6


class FrankaRobot:
    """Gives the references of a plan to the controller of franky."""

    def __init__(self, host: str, plan: ExportedPlan, limits: Limits, factors: tuple[float, float]) -> None:
        self.plan, self.limits = plan, limits
        self.stiffness = factors[0] * np.array(plan.document["tool_stiffness"])
        self.damping = factors[1] * np.array(plan.document["tool_damping"])
        self.robot = franky.Robot(host)
        self.time, self.is_compliant, self.quaternion = -1.0, False, None
        self.motion = franky.CartesianImpedanceTrackingMotion(
            translational_error_clip=np.full(3, CLIP_MARGIN * limits.distance),
            rotational_error_clip=np.full(3, CLIP_MARGIN * limits.angle),
        )

    def read(self) -> Measurement:
        """Waits for the end of the control period and measures."""
        deadline = time.monotonic() + PATIENCE
        while self.time <= (state := self.robot.state).time.to_sec() < self.time + PERIOD:
            if time.monotonic() > deadline:
                raise ConnectionLost(f"the robot has sent nothing for {PATIENCE:g} s")
            time.sleep(1e-4)
        now = state.time.to_sec()
        require_later(now, self.time)
        self.time = now
        self.require_running()
        x, y, z, w = np.array(state.O_T_EE.quaternion).flatten()
        tool = Pose(np.array(state.O_T_EE.translation).flatten(), rotations.matrix(np.array([w, x, y, z])))
        positions, speeds = np.array(state.q).flatten(), np.array(state.dq).flatten()
        twist = self.plan.arm.pose_and_jacobian(positions)[1] @ speeds
        wrench = np.array(state.O_F_ext_hat_K).flatten()
        return Measurement(self.time, positions, speeds, ToolState(tool, twist[:3], twist[3:]), wrench[:3], wrench[3:])

    def require_running(self) -> None:
        """The robot obeys."""
        if self.robot.has_errors:
            raise ConnectionLost("the robot has stopped by itself: reflex, or an error that Desk shows")
        if self.is_compliant and not self.robot.is_in_control:
            raise ConnectionLost("the controller does not run on the robot any more")

    def begin(self, hold: ToolState) -> None:
        """Starts the controller with the gains of the plan at the tool point, which are read back."""
        gains = franky.CartesianImpedanceGains()
        gains.stiffness, gains.damping = self.stiffness, self.damping
        self.motion.set_gains(gains)
        held = self.motion.get_gains()
        for wanted, found in ((self.stiffness, held.stiffness), (self.damping, held.damping)):
            if not np.abs(np.array(found) - wanted).max() <= SAME_GAINS * np.abs(wanted).max():
                raise InputError("the controller does not take the gains of the plan")
        force, torque = REFLEX_MARGIN * self.limits.force, REFLEX_MARGIN * self.limits.torque
        self.robot.set_collision_behavior(REFLEX_TORQUE, [force] * 3 + [torque] * 3)
        self.motion.set_reference(self.reference_of(hold))
        self.is_compliant = True
        self.robot.move(self.motion, asynchronous=True)

    def track(self, reference: ToolState, measured: Measurement) -> None:
        """The reference until the next one."""
        self.motion.set_reference(self.reference_of(reference))

    def end(self) -> None:
        """Lets the torques fade, and waits until the robot stands."""
        if not self.is_compliant:
            return
        self.is_compliant = False
        try:
            if self.robot.is_in_control:
                self.robot.move(franky.TorqueStopMotion(), asynchronous=True)
            self.robot.join_motion()
            self.robot.set_collision_behavior(USUAL_TORQUE, USUAL_FORCE)
        except franky.Exception as error:
            raise ConnectionLost(f"the robot has stopped by itself: {error}") from error

    def close(self) -> None:
        """The connection ends with the program."""

    def reference_of(self, state: ToolState) -> franky.CartesianReference:
        """A reference as franky has it; the sign of the quaternion does not jump."""
        self.quaternion = rotations.quaternion(state.pose.rotation, self.quaternion)
        w, x, y, z = self.quaternion
        target = franky.Affine(state.pose.position, np.array([x, y, z, w]))
        return franky.CartesianReference(target, franky.Twist(state.velocity, state.angular_velocity))


def connect(arguments: argparse.Namespace, plan: ExportedPlan, chosen: Settings) -> FrankaRobot:
    """The robot at an address."""
    factors = (arguments.stiffness_factor, arguments.damping_factor)
    try:
        return FrankaRobot(arguments.host, plan, chosen.playing, factors)
    except franky.Exception as error:
        raise InputError(f"{arguments.host}: the robot cannot be reached ({error}); is FCI active in Desk?") from error
