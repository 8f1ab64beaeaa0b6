"""A robot behind topics: what is published and when it is given up. Knows nothing of ROS, so that it is tested without."""

import argparse
import contextlib
import dataclasses
from typing import Protocol

import numpy as np

import rotations
from exported_plan import ExportedPlan, ToolState
from failures import InputError
from guards import Measurement, require_command
from inbox import Inbox
from kinematics import Pose
from settings import Settings, require_between

MESSAGES = ("pose", "motion-update")
# Longest wait (s) for the first measurements, and for somebody who hears the references.
FIRST_PATIENCE = 5.0
# Time (s) for the last reference to be sent.
PARTING = 0.1
# Most references per second, and fewest: between two of them, nobody looks at the guards.
MOST_RATE, LEAST_RATE = 2000.0, 50.0
# Parameters of crisp_controllers: stiffness and damping along and about the axes.
STIFFNESS, DAMPING = (
    [f"task.{letter}_{kind}_{axis}" for kind in ("pos", "rot") for axis in "xyz"] for letter in ("k", "d")
)
# Parameters that are read back are those that were set, but for rounding.
SAME_GAINS = 1e-6


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
    """What is needed of a middleware. Times are monotonic (s)."""

    inbox: Inbox

    def now(self) -> float: ...
    def wait(self, seconds: float) -> None: ...
    def hearers(self) -> int: ...
    def parameters(self, names: list[str]) -> list[float]: ...
    def set_parameters(self, names: list[str], values: list[float]) -> None: ...
    def publish_pose(self, target: MotionTarget) -> None: ...
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
        # The quaternion is that of the last reference, if there was one.
        self.next, self.is_first, self.quaternion = topics.now(), True, None
        self.former_gains: list[float] = []
        self.last_known: Pose | None = None

    def read(self) -> Measurement:
        """Waits for the end of the period and takes the newest measurements."""
        # A clock that was late does not make the player hurry.
        self.next = max(self.next + self.period, self.topics.now())
        self.topics.wait(self.next - self.topics.now())
        if self.is_first:
            self.await_first()
            self.is_first = False
        now = self.topics.now()
        heard = self.topics.inbox.take(now)
        pose = Pose.of(heard.pose.values)
        positions, speeds, twist = np.zeros(0), np.zeros(0), np.zeros(6)
        if self.plan.arm is not None:
            positions, speeds = np.split(heard.joints.values, 2)
            expected, jacobian = self.plan.arm.pose_and_jacobian(positions)
            twist = jacobian @ speeds
            pose_of_joints = expected if np.isfinite(positions).all() else None
        else:
            pose_of_joints = pose if np.isfinite(heard.pose.values).all() else None
        self.last_known = pose_of_joints or self.last_known
        wrench = heard.wrench.values
        return Measurement(now, positions, speeds, ToolState(pose, twist[:3], twist[3:]), wrench[:3], wrench[3:])

    def await_first(self) -> None:
        """Waits for the first measurements."""
        deadline = self.topics.now() + FIRST_PATIENCE
        while missing := self.topics.inbox.missing():
            if self.topics.now() > deadline:
                raise InputError(f"nothing comes on the topics of {', '.join(missing)}; name them with --pose-topic and the like")
            self.topics.wait(self.period)
        self.topics.inbox.require_clock()

    def begin(self, hold: ToolState) -> None:
        """Waits for a controller that hears, and sets its gains, where references have none."""
        deadline = self.topics.now() + FIRST_PATIENCE
        while not self.topics.hearers():
            if self.topics.now() > deadline:
                raise InputError("no controller hears the references; name their topic with --target-topic")
            self.topics.wait(self.period)
        # The reference first: a controller that holds another one would jump to it with the new gains.
        self.publish(hold)
        if self.message == "pose":
            names, wanted = STIFFNESS + DAMPING, [*np.diag(self.stiffness), *np.diag(self.damping)]
            former = self.topics.parameters(names)
            self.former_gains = former
            self.topics.set_parameters(names, wanted)
            held = np.array(self.topics.parameters(names))
            if not (np.abs(held - wanted) <= SAME_GAINS * np.abs(wanted)).all():
                raise InputError(f"the controller does not take the gains of the plan: it has {held.tolist()}, not {wanted}")
        self.publish(hold)

    def track(self, reference: ToolState, measured: Measurement) -> None:
        """The reference until the next one."""
        self.publish(reference)

    def end(self) -> None:
        """The controller holds the tool where its joints last had it, so that it presses on nothing any more, with the gains that it
        had before; it goes on running."""
        if self.quaternion is None:
            return
        try:
            self.publish(ToolState.at_rest(self.last_known))
            self.topics.wait(PARTING)
        finally:
            if self.former_gains:
                self.topics.set_parameters(STIFFNESS + DAMPING, self.former_gains)

    def close(self) -> None:
        """Leaves the middleware."""
        with contextlib.suppress(KeyboardInterrupt):
            self.topics.close()

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
    factors = (arguments.stiffness_factor, arguments.damping_factor)
    return Ros2Robot(topics, plan, arguments.message, 1.0 / arguments.rate, factors)


def is_diagonal(plan: ExportedPlan) -> bool:
    """Whether no axis of the stiffness is coupled to another."""
    stiffness = np.array(plan.document["tool_stiffness"])
    return bool(np.abs(stiffness - np.diag(np.diag(stiffness))).max() < 1e-6 * np.abs(stiffness).max())
