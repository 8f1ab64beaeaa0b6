"""A robot behind topics: what is published and when it is given up. Knows nothing of ROS, so that it is tested without."""

import argparse
import dataclasses
from typing import Protocol

import numpy as np

import rotations
from kinematics import Pose
from exported_plan import ExportedPlan, InputError, ToolState
from guards import ConnectionLost, Measurement
from session import require_positive

MESSAGES = ("pose", "motion-update")
# Longest wait (s) for the first measurements, and largest age (s) of later ones.
FIRST_PATIENCE, PATIENCE = 5.0, 0.1
# Time (s) for the last reference to be sent.
PARTING = 0.1


@dataclasses.dataclass
class Heard:
    """The newest measurements with the times (s) at which they came: pose of the tool (position, quaternion w x y z), joint
    positions and speeds, force and torque at the tool."""

    pose: np.ndarray | None = None
    pose_time: float = -np.inf
    positions: np.ndarray | None = None
    speeds: np.ndarray | None = None
    joint_time: float = -np.inf
    wrench: np.ndarray | None = None
    wrench_time: float = -np.inf


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


class Topics(Protocol):
    """What is needed of a middleware."""

    def now(self) -> float: ...
    def wait(self, seconds: float) -> None: ...
    def latest(self) -> Heard: ...
    def publish_pose(self, target: MotionTarget) -> None: ...
    def publish_stiffness(self, diagonal: list[float]) -> None: ...
    def publish_update(self, target: MotionTarget) -> None: ...
    def close(self) -> None: ...


class Ros2Robot:
    """Publishes references at a rate, and at the end the pose at which the tool is."""

    def __init__(self, topics: Topics, plan: ExportedPlan, message: str, period: float, factors: tuple[float, float]) -> None:
        self.topics, self.plan, self.message, self.period = topics, plan, message, period
        self.stiffness = factors[0] * np.array(plan.document["tool_stiffness"])
        self.damping = factors[1] * np.array(plan.document["tool_damping"])
        # From a twist to the lead of a pose (m, rad).
        self.lead = np.linalg.solve(self.stiffness, self.damping)
        self.next, self.last_pose = topics.now(), None

    def read(self) -> Measurement:
        """Waits for the end of the period and takes the newest measurements."""
        self.next = max(self.next + self.period, self.topics.now())
        self.topics.wait(self.next - self.topics.now())
        first = self.last_pose is None
        heard = self.first() if first else self.topics.latest()
        now = self.topics.now()
        self.require_news(heard, now)
        pose = Pose.of(heard.pose)
        velocity, spin = np.zeros(3), np.zeros(3)
        positions, speeds = np.zeros(0), np.zeros(0)
        if self.plan.arm is not None:
            positions = heard.positions
            speeds = heard.speeds if heard.speeds is not None else np.zeros(len(positions))
            twist = self.plan.arm.posture(positions)[1] @ speeds
            velocity, spin = twist[:3], twist[3:]
        self.last_pose = pose
        return Measurement(now, positions, speeds, ToolState(pose, velocity, spin), heard.wrench[:3], heard.wrench[3:])

    def first(self) -> Heard:
        """Waits for the first measurements."""
        deadline = self.topics.now() + FIRST_PATIENCE
        while missing := self.missing(self.topics.latest()):
            if self.topics.now() > deadline:
                raise InputError(f"nothing comes on the topics of {', '.join(missing)}; name them with --pose-topic and the like")
            self.topics.wait(self.period)
        return self.topics.latest()

    def missing(self, heard: Heard) -> list[str]:
        """What was never heard of."""
        needed = {"pose": heard.pose, "wrench": heard.wrench}
        if self.plan.arm is not None:
            needed["joint states"] = heard.positions
        return [name for name, value in needed.items() if value is None]

    def require_news(self, heard: Heard, now: float) -> None:
        """Old measurements are none."""
        times = {"pose": heard.pose_time, "wrench": heard.wrench_time}
        if self.plan.arm is not None:
            times["joint states"] = heard.joint_time
        for name, time in times.items():
            if now - time > PATIENCE:
                raise ConnectionLost(f"the newest {name} is {now - time:.2f} s old, older than {PATIENCE:g} s")

    def begin(self, hold: ToolState) -> None:
        """Sends the gains, where they have a topic of their own."""
        if self.message == "pose":
            self.topics.publish_stiffness(np.diag(self.stiffness).tolist())
        self.publish(hold)

    def track(self, reference: ToolState, measured: Measurement) -> None:
        """The reference until the next one."""
        self.publish(reference)

    def end(self) -> None:
        """The controller holds the tool where it is, so that it presses on nothing any more; it goes on running."""
        try:
            if self.last_pose is not None:
                newest = self.topics.latest().pose
                self.publish(ToolState.at_rest(Pose.of(newest)))
                self.topics.wait(PARTING)
        finally:
            self.topics.close()

    def publish(self, state: ToolState) -> None:
        """A reference, with gains where the message has them. A controller that hears of poses alone brakes the tool itself: the
        pose leads by as much as makes its spring pull as the damping of the plan would."""
        if self.message == "pose":
            lead = self.lead @ np.concatenate([state.velocity, state.angular_velocity])
            pose = Pose(state.pose.position + lead[:3], rotations.of_vector(lead[3:]) @ state.pose.rotation)
            state = ToolState(pose, state.velocity, state.angular_velocity)
        to_tool = state.pose.rotation.T
        target = MotionTarget(
            position=state.pose.position.tolist(),
            quaternion=rotations.quaternion(state.pose.rotation).tolist(),
            velocity=(to_tool @ state.velocity).tolist(),
            spin=(to_tool @ state.angular_velocity).tolist(),
            stiffness=self.stiffness.flatten().tolist(),
            damping=self.damping.flatten().tolist(),
        )
        if self.message == "pose":
            self.topics.publish_pose(target)
        else:
            self.topics.publish_update(target)


def connect(arguments: argparse.Namespace, plan: ExportedPlan, middleware: type) -> Ros2Robot:
    """The robot behind the topics of a middleware."""
    require_positive(arguments, "stiffness_factor", "damping_factor", "rate")
    if arguments.message == "pose" and not is_diagonal(plan):
        raise InputError(
            "the stiffness at the tool point has coupled axes, and --message pose has room for its diagonal alone: use "
            "--message motion-update, or a `tip` in the scene whose origin is that of the part"
        )
    topics = middleware(arguments, plan.arm.names if plan.arm else [])
    factors = (arguments.stiffness_factor, arguments.damping_factor)
    return Ros2Robot(topics, plan, arguments.message, 1.0 / arguments.rate, factors)


def is_diagonal(plan: ExportedPlan) -> bool:
    """Whether no axis of the stiffness is coupled to another."""
    stiffness = np.array(plan.document["tool_stiffness"])
    return bool(np.abs(stiffness - np.diag(np.diag(stiffness))).max() < 1e-6 * np.abs(stiffness).max())
