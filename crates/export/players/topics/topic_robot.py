"""A robot behind topics: what is heard of it, the gains of its controller, and how it is left. Knows nothing of ROS, so that it is
tested without."""

import abc
import argparse
import contextlib
from collections.abc import Iterable
from typing import Protocol

import numpy as np

from exported_plan import ExportedPlan, ToolState
from failures import InputError
from guards import Measurement
from inbox import Inbox, Message
from kinematics import Pose

# A parameter of a node.
Value = float | int | str | list[float] | list[bool]
Values = dict[str, Value]
# Longest wait (s) for the first measurements, and for somebody who hears the references.
FIRST_PATIENCE = 5.0
# Time (s) for the last reference to be sent.
PARTING = 0.1
# Parameters that are read back are those that were set, but for rounding.
SAME_GAINS = 1e-6


class Topics(Protocol):
    """What is needed of a middleware. Times are monotonic (s)."""

    inbox: Inbox

    def now(self) -> float: ...
    def wait(self, seconds: float) -> None: ...
    def hearers(self) -> int: ...
    def parameters(self, of: str, names: list[str]) -> Values: ...
    def set_parameters(self, of: str, values: Values) -> None: ...
    def close(self) -> None: ...


class TopicRobot(abc.ABC):
    """Publishes references, one in each period (s), to a controller with some gains, and at the end where the tool is."""

    # The flag that names the topic of the references.
    named_by = "--target-topic"

    def __init__(self, topics: Topics, plan: ExportedPlan, period: float, controller: str, gains: Values) -> None:
        self.topics, self.plan, self.period = topics, plan, period
        self.controller, self.gains = controller, gains
        self.next, self.is_first = topics.now(), True
        self.has_published = False
        self.former_gains: Values = {}
        self.last_known: Pose | None = None

    @abc.abstractmethod
    def publish(self, state: ToolState) -> None:
        """A reference."""

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
        pose = Pose.of(heard["pose"].values)
        positions, speeds, twist = np.zeros(0), np.zeros(0), np.zeros(6)
        if self.plan.arm is not None:
            positions, speeds = np.split(heard["joint states"].values, 2)
            expected, jacobian = self.plan.arm.pose_and_jacobian(positions)
            twist = jacobian @ speeds
            pose_of_joints = expected if np.isfinite(positions).all() else None
        else:
            pose_of_joints = pose if np.isfinite(heard["pose"].values).all() else None
        self.last_known = pose_of_joints or self.last_known
        self.note(heard)
        wrench = heard["wrench"].values
        return Measurement(now, positions, speeds, ToolState(pose, twist[:3], twist[3:]), wrench[:3], wrench[3:])

    def note(self, heard: dict[str, Message]) -> None:
        """What else is needed of the newest messages."""

    def await_first(self) -> None:
        """Waits for the first measurements."""
        deadline = self.topics.now() + FIRST_PATIENCE
        while missing := self.topics.inbox.missing():
            if self.topics.now() > deadline:
                raise InputError(f"nothing comes on the topics of {', '.join(missing)}; name them with --pose-topic and the like")
            self.topics.wait(self.period)
        self.topics.inbox.require_clock()

    def begin(self, hold: ToolState) -> None:
        """Waits for a controller that hears, and sets its gains."""
        deadline = self.topics.now() + FIRST_PATIENCE
        while not self.topics.hearers():
            if self.topics.now() > deadline:
                raise InputError(f"no controller hears the references; name their topic with {self.named_by}")
            self.topics.wait(self.period)
        # The reference first: a controller that holds another one would jump to it with the new gains.
        self.take_over(hold)
        if self.gains:
            self.set_gains()
        self.publish(hold)

    def take_over(self, hold: ToolState) -> None:
        """The first reference."""
        self.publish(hold)

    def set_gains(self) -> None:
        """Sets the gains and reads them back."""
        names = list(self.gains)
        self.former_gains = self.topics.parameters(self.controller, names)
        self.topics.set_parameters(self.controller, self.gains)
        held = self.topics.parameters(self.controller, names)
        for name, wanted in self.gains.items():
            if np.shape(held[name]) != np.shape(wanted) or not np.allclose(held[name], wanted, rtol=SAME_GAINS, atol=0.0):
                raise InputError(f"the controller does not take the gains of the plan: {name} is {held[name]}, not {wanted}")

    def track(self, reference: ToolState, measured: Measurement) -> None:
        """The reference until the next one."""
        self.publish(reference)

    def end(self) -> Iterable[None]:
        """The controller holds the tool where its joints last had it, so that it presses on nothing any more, with the gains that it
        had before; it goes on running."""
        if not self.has_published:
            return
        try:
            yield from self.leave_at_rest()
        finally:
            if self.former_gains:
                self.topics.set_parameters(self.controller, self.former_gains)

    def leave_at_rest(self) -> Iterable[None]:
        """The last references."""
        self.publish(ToolState.at_rest(self.last_known))
        self.topics.wait(PARTING)
        return ()

    def close(self) -> None:
        """Leaves the middleware."""
        with contextlib.suppress(KeyboardInterrupt):
            self.topics.close()


def add_topics(parser: argparse.ArgumentParser, pose: str, wrench: str) -> None:
    """Flags of the topics on which the robot is heard, with their usual names."""
    add = parser.add_argument
    add("--pose-topic", default=pose, metavar="TOPIC", help="PoseStamped of the tool [default: %(default)s]")
    add("--joint-topic", default="joint_states", metavar="TOPIC", help="JointState [default: %(default)s]")
    add("--wrench-topic", default=wrench, metavar="TOPIC", help="WrenchStamped at the tool [default: %(default)s]")
