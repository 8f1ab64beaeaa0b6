"""Stand-in for the topics of a robot: the controller behind them is simulated, and time is its time."""

import argparse

import numpy as np
from inbox import Inbox, Message
from ros2_robot import DAMPING, STIFFNESS, MotionTarget

import rotations
from failures import InputError
from lab.players.impedance_controller import ImpedanceController
from lab.players.simulated_arm import SimulatedArm, Task

PERIOD = 0.002
# A controller that pulls the tool with less (N, Nm) leaves it at rest: a tool of which nothing is heard for 0.1 s has
# moved since.
AT_REST = 25.0
# What the controller has before anybody sets its gains.
GAINS = {**dict.fromkeys(STIFFNESS, 400.0), **dict.fromkeys(DAMPING, 40.0)}


class Middleware:
    """With poses alone, damping brakes the tool and not its lag, as in crisp_controllers."""

    def __init__(self, arguments: argparse.Namespace, joints: list[str]) -> None:
        self.arm, self.frame = SimulatedArm(Task.read()), arguments.frame
        self.controller = ImpedanceController(self.arm, PERIOD)
        self.inbox = Inbox(arguments.frame, bool(joints))
        self.gains, self.sends_gains = dict(GAINS), arguments.message == "motion-update"
        self.is_on, self.pull, self.count = False, np.zeros(6), 0
        self.hear()

    def now(self) -> float:
        return self.arm.time

    def wait(self, seconds: float) -> None:
        for _ in range(max(1, round(seconds / PERIOD))):
            if self.is_on:
                self.controller.step()
            else:
                self.arm.rest(PERIOD)
        if not (self.arm.fails("disconnect") or self.arm.fails("hang")):
            self.hear()
        if self.arm.fails("gap"):
            self.arm.time += 0.2

    def hear(self) -> None:
        """What the robot says comes as messages."""
        said, now = self.arm.said(), self.arm.time
        age = {"late": 0.3, "old": 5.0}.get(self.arm.task.fault.kind, 0.0) if now >= self.arm.task.fault.time else 0.0
        stamp = said.time - age + 100.0
        if self.arm.fails("doubled"):
            stamp = self.arm.task.fault.time + 100.0
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

    def parameters(self, names: list[str]) -> list[float]:
        return [self.gains[name] for name in names]

    def set_parameters(self, names: list[str], values: list[float]) -> None:
        if self.arm.fails("read-only"):
            raise InputError("the controller does not take the gains of the plan: parameters are read-only")
        if not self.arm.fails("deaf"):
            self.gains |= dict(zip(names, np.minimum(values, 1000.0) if self.arm.fails("clipped") else values))

    def publish_pose(self, target: MotionTarget) -> None:
        self.controller.stiffness, self.controller.damping = (
            np.diag([self.gains[name] for name in names]) for names in (STIFFNESS, DAMPING)
        )
        self.follow(target)
        self.controller.twist = np.zeros(6)

    def publish_update(self, target: MotionTarget) -> None:
        self.controller.stiffness = np.array(target.stiffness).reshape(6, 6)
        self.controller.damping = np.array(target.damping).reshape(6, 6)
        self.follow(target)
        velocity, spin = np.array(target.velocity), np.array(target.spin)
        rotation = self.controller.rotation
        self.controller.twist = np.concatenate([rotation @ velocity, rotation @ spin])

    def follow(self, target: MotionTarget) -> None:
        """A new reference, which pulls the tool from where it really is."""
        self.is_on, self.arm.mode = True, "torque"
        self.arm.obey(np.array([*target.position, *target.quaternion, *target.velocity, *target.spin]))
        controller = self.controller
        controller.position, controller.rotation = (
            np.array(target.position),
            rotations.matrix(np.array(target.quaternion)),
        )
        position, rotation, _ = self.arm.tool()
        error = np.concatenate([controller.position - position, rotations.vector(controller.rotation @ rotation.T)])
        self.pull = controller.stiffness @ error

    def close(self) -> None:
        """The controller goes on holding the last reference: the mode is left when that was where the tool really was,
        and when it has the gains that it had."""
        has_own = self.sends_gains or self.arm.fails("clipped") or self.gains == GAINS
        if not self.is_on or (np.abs(self.pull).max() < AT_REST and has_own):
            self.arm.mode = "position"
        self.arm.leave()
