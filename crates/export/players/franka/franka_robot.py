"""A robot of Franka Robotics, by the package franky-control: its Cartesian impedance controller runs at 1 kHz in a thread of its
own and follows the reference that it is given."""

import argparse
import time

import franky
import numpy as np

import rotations
from kinematics import Pose
from exported_plan import ExportedPlan, InputError, ToolState
from guards import ConnectionLost, Measurement
from session import require_positive

# Time between two references (s).
PERIOD = 0.002
# Longest wait (s) for a new measurement.
PATIENCE = 0.1
# The controller clips errors of the pose. What the guards let pass must not be clipped.
CLIP_MARGIN = 1.5
# The robot stops by itself at this many times the force and torque at which the player does: the player says why it stopped.
REFLEX_MARGIN = 1.5
# Torques of joints (Nm) at which it does.
REFLEX_TORQUE = 40.0


class FrankaRobot:
    """Gives the references of a plan to the controller of franky."""

    def __init__(self, host: str, plan: ExportedPlan, stiffness_factor: float, damping_factor: float) -> None:
        self.plan = plan
        self.stiffness = stiffness_factor * np.array(plan.document["tool_stiffness"])
        self.damping = damping_factor * np.array(plan.document["tool_damping"])
        self.robot = franky.Robot(host)
        self.time, self.is_compliant = -1.0, False
        guards = plan.document["guards"]
        self.robot.set_collision_behavior(REFLEX_TORQUE, REFLEX_MARGIN * guards["force_n"])
        self.motion = franky.CartesianImpedanceTrackingMotion(
            translational_error_clip=np.full(3, CLIP_MARGIN * guards["deviation_m"]),
            rotational_error_clip=np.full(3, CLIP_MARGIN * guards["deviation_rad"]),
        )

    def read(self) -> Measurement:
        """Waits for the end of the control period and measures."""
        deadline = time.monotonic() + PATIENCE
        while (state := self.robot.state).time.to_sec() < self.time + PERIOD:
            if time.monotonic() > deadline:
                raise ConnectionLost(f"the robot has sent nothing for {PATIENCE:g} s")
            time.sleep(1e-4)
        self.time = state.time.to_sec()
        self.require_running()
        x, y, z, w = np.array(state.O_T_EE.quaternion).flatten()
        tool = Pose(np.array(state.O_T_EE.translation).flatten(), rotations.matrix(np.array([w, x, y, z])))
        positions, speeds = np.array(state.q).flatten(), np.array(state.dq).flatten()
        twist = self.plan.arm.posture(positions)[1] @ speeds
        wrench = np.array(state.O_F_ext_hat_K).flatten()
        return Measurement(self.time, positions, speeds, ToolState(tool, twist[:3], twist[3:]), wrench[:3], wrench[3:])

    def require_running(self) -> None:
        """The robot obeys."""
        if self.robot.has_errors:
            raise ConnectionLost("the robot has stopped by itself: reflex, or an error that Desk shows")
        if self.is_compliant and not self.robot.is_in_control:
            raise ConnectionLost("the controller does not run on the robot any more")

    def begin(self, hold: ToolState) -> None:
        """Starts the controller with the gains of the plan at the tool point."""
        gains = franky.CartesianImpedanceGains()
        gains.stiffness, gains.damping = self.stiffness, self.damping
        self.motion.set_gains(gains)
        self.motion.set_reference(reference_of(hold))
        self.robot.move(self.motion, asynchronous=True)
        self.is_compliant = True

    def track(self, reference: ToolState, measured: Measurement) -> None:
        """The reference until the next one."""
        self.motion.set_reference(reference_of(reference))

    def end(self) -> None:
        """Lets the torques fade, and waits until the robot stands."""
        if not self.is_compliant:
            return
        self.is_compliant = False
        try:
            if self.robot.is_in_control:
                self.robot.move(franky.TorqueStopMotion(), asynchronous=True)
            self.robot.join_motion()
        except franky.Exception as error:
            raise ConnectionLost(f"the robot has stopped by itself: {error}") from error


def reference_of(state: ToolState) -> franky.CartesianReference:
    """A reference as franky has it."""
    w, x, y, z = rotations.quaternion(state.pose.rotation)
    target = franky.Affine(state.pose.position, np.array([x, y, z, w]))
    return franky.CartesianReference(target, franky.Twist(state.velocity, state.angular_velocity))


def connect(arguments: argparse.Namespace, plan: ExportedPlan) -> FrankaRobot:
    """The robot at an address."""
    require_positive(arguments, "stiffness_factor", "damping_factor")
    try:
        return FrankaRobot(arguments.host, plan, arguments.stiffness_factor, arguments.damping_factor)
    except franky.Exception as error:
        raise InputError(f"{arguments.host}: the robot cannot be reached ({error}); is FCI active in Desk?") from error
