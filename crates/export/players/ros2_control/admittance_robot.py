"""A robot behind the admittance controller of ros2_controllers. Knows nothing of ROS, so that it is tested without."""

import argparse
import math
from collections.abc import Iterable, Iterator
from typing import Any, Protocol

import numpy as np

from exported_plan import ExportedPlan, ToolState
from failures import InputError, Stopped
from guards import Measurement, require_command
from inbox import Message
from joint_reference import JointReference
from kinematics import Pose
from settings import Settings, position_law
from topic_robot import PARTING, TopicRobot, Topics, Values

# What the controller adds to the references of the joints (rad or m), as it says itself.
OFFSETS = "offsets of the controller"
# At the beginning, the law may hold the tool this far (m, rad) from its reference.
LARGEST_OFFSET, LARGEST_TURN = 0.002, 0.01
# At the beginning and the end, the reference goes to where the tool is: all but this far (m, rad) no faster than the law yields,
# with a margin, and within this time (s).
LEFT, LEFT_TURN = 5e-4, 5e-3
YIELDING, LONGEST_PARTING = 1.25, 10.0
# Part by which the controller may be updated less often than the law needs.
SAME_RATE = 1e-3
FRAME = "ft_sensor.frame.id"


class Publishers(Topics, Protocol):
    """A middleware that publishes references of joints."""

    def publish_joints(self, positions: list[float], speeds: list[float]) -> None: ...


class AdmittanceRobot(TopicRobot):
    """The controller moves the joints to their references, and by what its law adds to them."""

    topics: Publishers
    named_by = "--controller"

    def __init__(self, topics: Publishers, plan: ExportedPlan, law: dict[str, Any], arguments: argparse.Namespace) -> None:
        gains = parameters(law, arguments.stiffness_factor, arguments.damping_factor)
        super().__init__(topics, plan, law["period_s"], arguments.controller, gains)
        # Time (s) in which the law yields to a force that no spring holds.
        factor = YIELDING * arguments.damping_factor / arguments.stiffness_factor
        self.yielding = factor * max(damping / stiffness for damping, stiffness in zip(law["damping"], law["stiffness"]))
        self.manager, self.tip = arguments.controller_manager, plan.document["arm"]["tip"]
        self.measured, self.offsets, self.last_sent = np.zeros(0), np.zeros(0), np.zeros(0)
        self.joints: JointReference | None = None
        # From poses as the robot says them to those that follow from its joints.
        self.correction: Pose | None = None

    def note(self, heard: dict[str, Message]) -> None:
        """Joint positions, and what the controller adds to their references."""
        positions, _ = np.split(heard["joint states"].values, 2)
        if np.isfinite(positions).all():
            self.measured = positions
        self.offsets = heard[OFFSETS].values
        if not np.isfinite(self.offsets).all():
            raise Stopped("the controller says no numbers for what it adds to the references")

    def begin(self, hold: ToolState) -> None:
        """The law starts from rest, at the part, and as often as it was chosen for."""
        frame = self.topics.parameters(self.controller, [FRAME])[FRAME]
        if frame != self.tip:
            raise InputError(f"the law of the controller acts at `{frame}`, and that of the plan at `{self.tip}`: set {FRAME}")
        rate = self.topics.parameters(self.manager, ["update_rate"])["update_rate"]
        if not rate * self.period >= 1 - SAME_RATE:
            raise InputError(
                f"`{self.manager}` updates its controllers {rate:g} times per second, and the law was chosen for "
                f"{1 / self.period:g}: load controllers.yaml"
            )
        _, jacobian = self.plan.arm.pose_and_jacobian(self.measured)
        held = jacobian @ self.offsets
        distance, angle = math.hypot(*held[:3]), math.hypot(*held[3:])
        if not (distance <= LARGEST_OFFSET and angle <= LARGEST_TURN):
            raise InputError(
                f"the law holds the tool {1e3 * distance:.1f} mm and {angle:.3f} rad from its reference: zero the sensor, set the "
                "payload, and activate the controller again"
            )
        self.joints = JointReference(self.plan.arm, self.measured, self.period)
        self.correction = self.plan.arm.forward(self.measured) @ hold.pose.inverse()
        super().begin(hold)

    def take_over(self, hold: ToolState) -> None:
        """From the reference that the controller has, as its offsets say, to where the joints are."""
        for _ in self.lead(self.measured - self.offsets, self.measured):
            pass

    def publish(self, state: ToolState) -> None:
        """Positions and speeds of the joints for a reference of the tool."""
        turned = self.correction.rotation
        pose = self.correction @ state.pose
        self.send(*self.joints.follow(ToolState(pose, turned @ state.velocity, turned @ state.angular_velocity)))

    def send(self, positions: np.ndarray, speeds: np.ndarray) -> None:
        """A reference of the joints."""
        require_command("reference", [*positions, *speeds])
        self.has_published, self.last_sent = True, positions
        self.topics.publish_joints(positions.tolist(), speeds.tolist())

    def leave_at_rest(self) -> Iterable[None]:
        """The reference goes to where the joints are."""
        return self.lead(self.last_sent, self.measured)

    def lead(self, begin: np.ndarray, end: np.ndarray) -> Iterator[None]:
        """Leads the reference as slowly as the law yields: the controller adds to it what the law holds, so that the tool would leave
        what it touches, and press on what is behind it."""
        way = begin - end
        _, jacobian = self.plan.arm.pose_and_jacobian(self.measured)
        moved = jacobian @ way
        left = math.log(max(1.0, math.hypot(*moved[:3]) / LEFT, math.hypot(*moved[3:]) / LEFT_TURN))
        duration = min(max(PARTING, left * self.yielding), LONGEST_PARTING)
        steps = math.ceil(duration / self.period)
        for step in range(steps):
            self.send(end + math.exp(-left * step / steps) * way, np.zeros_like(way))
            self.topics.wait(self.period)
            yield
        self.send(end, np.zeros_like(way))


def parameters(law: dict[str, Any], stiffness_factor: float, damping_factor: float) -> Values:
    """The law as parameters of the controller, which makes the damping from its ratio."""
    mass = along_and_about(law["mass"])
    stiffness = [stiffness_factor * value for value in along_and_about(law["stiffness"])]
    damping = [damping_factor * value for value in along_and_about(law["damping"])]
    return {
        "admittance.selected_axes": [True] * 6,
        "admittance.mass": mass,
        "admittance.stiffness": stiffness,
        "admittance.damping_ratio": [d / (2 * math.sqrt(m * k)) for m, k, d in zip(mass, stiffness, damping)],
        "admittance.joint_damping": 0.0,
    }


def along_and_about(pair: list[float]) -> list[float]:
    """A value of translations along x, y, z and one of rotations about them."""
    return [float(pair[0])] * 3 + [float(pair[1])] * 3


def connect(arguments: argparse.Namespace, plan: ExportedPlan, _: Settings, middleware: type) -> AdmittanceRobot:
    """The robot behind the topics of a middleware."""
    law = position_law(arguments, plan)
    if plan.arm is None:
        raise InputError("the controller takes references of joints, and the plan has no arm: export again with --to ros2-control")
    arguments.frame = arguments.frame or plan.document["arm"]["root"]
    return AdmittanceRobot(middleware(arguments, plan.arm.names), plan, law, arguments)
