"""A robot behind a Cartesian impedance controller. Knows nothing of ROS, so that it is tested without."""

import argparse
import dataclasses
from typing import Protocol

import numpy as np

import rotations
from exported_plan import ExportedPlan, ToolState
from failures import InputError
from guards import require_command
from kinematics import Pose
from settings import require_between
from topic_robot import TopicRobot, Topics, Values

MESSAGES = ("pose", "motion-update")
# Most references per second, and fewest: between two of them, nobody looks at the guards.
MOST_RATE, LEAST_RATE = 2000.0, 50.0
# Parameters of crisp_controllers: stiffness and damping along and about the axes.
STIFFNESS, DAMPING = (
    [f"task.{letter}_{kind}_{axis}" for kind in ("pos", "rot") for axis in "xyz"] for letter in ("k", "d")
)


@dataclasses.dataclass(frozen=True)
class MotionTarget:
    """A reference of the tool: pose in the base, velocity and angular velocity along the axes of the tool, and the rows of
    stiffness and damping in one list."""

    position: list[float]
    quaternion: list[float]
    velocity: list[float]
    spin: list[float]
    stiffness: list[float]
    damping: list[float]


class Publishers(Topics, Protocol):
    """A middleware that publishes references with gains or without."""

    def publish_pose(self, target: MotionTarget) -> None: ...
    def publish_update(self, target: MotionTarget) -> None: ...


class Ros2Robot(TopicRobot):
    """A Cartesian impedance controller: gains are its parameters, or come with every reference."""

    topics: Publishers

    def __init__(
        self, topics: Publishers, plan: ExportedPlan, period: float, arguments: argparse.Namespace
    ) -> None:
        self.message = arguments.message
        self.stiffness = arguments.stiffness_factor * np.array(plan.document["tool_stiffness"])
        self.damping = arguments.damping_factor * np.array(plan.document["tool_damping"])
        values = [*np.diag(self.stiffness).tolist(), *np.diag(self.damping).tolist()]
        gains: Values = dict(zip(STIFFNESS + DAMPING, values)) if self.message == "pose" else {}
        super().__init__(topics, plan, period, arguments.controller, gains)
        # From a twist to the lead of a pose (m, rad).
        self.lead = np.linalg.solve(self.stiffness, self.damping)
        # That of the last reference, if there was one.
        self.quaternion: np.ndarray | None = None

    def publish(self, state: ToolState) -> None:
        """A reference, with gains where the message has them. A controller that hears of poses alone brakes the tool itself: the
        pose leads by as much as makes its spring pull as the damping of the plan would."""
        if self.message == "pose":
            lead = self.lead @ np.concatenate([state.velocity, state.angular_velocity])
            pose = Pose(state.pose.position + lead[:3], rotations.of_vector(lead[3:]) @ state.pose.rotation)
            state = ToolState(pose, state.velocity, state.angular_velocity)
        rotation = state.pose.rotation
        self.quaternion = rotations.quaternion(rotation, self.quaternion)
        target = MotionTarget(
            position=state.pose.position.tolist(),
            quaternion=self.quaternion.tolist(),
            velocity=(rotation.T @ state.velocity).tolist(),
            spin=(rotation.T @ state.angular_velocity).tolist(),
            stiffness=self.stiffness.flatten().tolist(),
            damping=self.damping.flatten().tolist(),
        )
        require_command("reference", [*target.position, *target.quaternion, *target.velocity, *target.spin])
        self.has_published = True
        if self.message == "pose":
            self.topics.publish_pose(target)
        else:
            self.topics.publish_update(target)


def connect(arguments: argparse.Namespace, plan: ExportedPlan, middleware: type) -> Ros2Robot:
    """The robot behind the topics of a middleware."""
    require_between(arguments, "rate", MOST_RATE)
    if arguments.rate < LEAST_RATE:
        raise InputError(f"--rate {arguments.rate:g} is below {LEAST_RATE:g} references per second")
    if arguments.message == "pose" and not is_diagonal(plan):
        raise InputError(
            "the gains at the tool point have coupled axes, and --message pose has room for their diagonals alone: use "
            "--message motion-update, or a `tip` in the scene whose origin is that of the part"
        )
    topics = middleware(arguments, plan.arm.names if plan.arm else [])
    return Ros2Robot(topics, plan, 1.0 / arguments.rate, arguments)


def is_diagonal(plan: ExportedPlan) -> bool:
    """Whether no axis of the stiffness is coupled to another."""
    stiffness = np.array(plan.document["tool_stiffness"])
    return bool(np.abs(stiffness - np.diag(np.diag(stiffness))).max() < 1e-6 * np.abs(stiffness).max())
