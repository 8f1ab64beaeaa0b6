"""The topics of a robot of ROS 2 without ROS: what a simulated arm says comes as messages, and time is its time."""

import abc
import argparse
from typing import Any

import numpy as np
from inbox import Inbox, Message

import rotations
from failures import InputError
from lab.players.simulated_arm import SimulatedArm

# Stamps begin here (s).
EPOCH = 100.0


class SimulatedTopics(abc.ABC):
    """What middlewares share, with a controller of some period (s) and its parameters."""

    # A controller that clips its gains takes no larger ones.
    largest_gain = 1000.0

    def __init__(
        self, arguments: argparse.Namespace, arm: SimulatedArm, period: float, gains: dict[str, Any], more: list[str]
    ) -> None:
        self.arm, self.frame, self.period = arm, arguments.frame, period
        self.gains, self.first_gains = dict(gains), dict(gains)
        self.inbox = Inbox(arguments.frame, ["pose", "wrench", "joint states", *more])
        self.is_on, self.count = False, 0
        self.hear()

    @abc.abstractmethod
    def step(self) -> None:
        """The controller works for a period."""

    @abc.abstractmethod
    def is_left_at_rest(self) -> bool:
        """Whether the controller holds the tool where it really is."""

    def now(self) -> float:
        return self.arm.time

    def wait(self, seconds: float) -> None:
        for _ in range(max(1, round(seconds / self.period))):
            if self.is_on:
                self.step()
            else:
                self.arm.rest(self.period)
        if not (self.arm.fails("disconnect") or self.arm.fails("hang")):
            self.hear()
        if self.arm.fails("gap"):
            self.arm.time += 0.2

    def hear(self) -> None:
        """What the robot says comes as messages."""
        said, now = self.arm.said(), self.arm.time
        age = {"late": 0.3, "old": 5.0}.get(self.arm.task.fault.kind, 0.0) if now >= self.arm.task.fault.time else 0.0
        stamp = said.time - age + EPOCH
        if self.arm.fails("doubled"):
            stamp = self.arm.task.fault.time + EPOCH
        if self.arm.fails("reordered"):
            stamp -= 0.05 * (self.count % 2)
        self.count += 1
        pose = np.concatenate([said.pose, rotations.quaternion(said.rotation)])
        frame = "world" if self.arm.fails("frame name") else self.frame
        self.inbox.put_pose(Message(pose, now, stamp, age), frame)
        if self.arm.fails("no speeds"):
            self.inbox.refuse("joint states come with 0 velocities for 6 joints")
        elif not self.arm.fails("no joints"):
            self.inbox.put("joint states", Message(np.concatenate([said.positions, said.speeds]), now, stamp, age))
        if not self.arm.fails("no wrench"):
            self.inbox.put("wrench", Message(said.wrench, now, stamp, age))

    def hearers(self) -> int:
        return 0 if self.arm.fails("nobody") else 1

    def parameters(self, of: str, names: list[str]) -> dict[str, Any]:
        return {name: self.gains[name] for name in names}

    def set_parameters(self, of: str, values: dict[str, Any]) -> None:
        if self.arm.fails("read-only"):
            raise InputError("the controller does not take the gains of the plan: parameters are read-only")
        if not self.arm.fails("deaf"):
            taken = {name: np.minimum(value, self.largest_gain).tolist() for name, value in values.items()}
            self.gains |= taken if self.arm.fails("clipped") else values

    def close(self) -> None:
        """The controller goes on holding the last reference: the mode is left when that was where the tool really was,
        and when it has the gains that it had."""
        has_own = self.arm.fails("clipped") or self.gains == self.first_gains
        if not self.is_on or (self.is_left_at_rest() and has_own):
            self.arm.mode = "position"
        self.arm.leave()
