"""Stand-in for the topics of a robot: the controller behind them is simulated, and time is its time."""

import argparse

import numpy as np

import rotations
from impedance_controller import ImpedanceController
from ros2_robot import Heard, MotionTarget
from simulated_arm import SimulatedArm, Task

PERIOD = 0.002


class Middleware:
    """With poses alone, damping brakes the tool and not its lag, as in crisp_controllers. Its damping is set to the
    plan's."""

    def __init__(self, arguments: argparse.Namespace, joints: list[str]) -> None:
        self.arm = SimulatedArm(Task.read())
        self.controller = ImpedanceController(self.arm, PERIOD)
        self.is_on, self.heard, self.way = False, Heard(), np.zeros(3)
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
        """Measures."""
        position, rotation, _ = self.arm.tool()
        if self.arm.fails("frame"):
            position = position + np.array([0.0, 0.0, 0.1])
        pose, now = np.concatenate([position, rotations.quaternion(rotation)]), self.arm.time
        data = self.arm.data
        self.heard = Heard(pose, now, data.qpos.copy(), data.qvel.copy(), now, self.arm.wrench(), now)

    def latest(self) -> Heard:
        return self.heard

    def publish_pose(self, target: MotionTarget) -> None:
        self.follow(target)
        self.controller.twist = np.zeros(6)

    def publish_stiffness(self, diagonal: list[float]) -> None:
        self.controller.stiffness = np.diag(diagonal)

    def publish_update(self, target: MotionTarget) -> None:
        self.follow(target)
        self.controller.stiffness = np.array(target.stiffness).reshape(6, 6)
        velocity, spin = np.array(target.velocity), np.array(target.spin)
        rotation = self.controller.rotation
        self.controller.twist = np.concatenate([rotation @ velocity, rotation @ spin])

    def follow(self, target: MotionTarget) -> None:
        """A new reference."""
        self.is_on, self.arm.mode = True, "torque"
        self.controller.damping = np.array(target.damping).reshape(6, 6)
        self.controller.position = np.array(target.position)
        self.way = self.controller.position - self.heard.pose[:3]
        self.controller.rotation = rotations.matrix(np.array(target.quaternion))

    def close(self) -> None:
        """The controller goes on holding the last reference: the mode is left when that was where the tool was heard."""
        if not self.is_on or np.linalg.norm(self.controller.stiffness[:3, :3] @ self.way) < 1.0:
            self.arm.mode = "position"
        self.arm.leave()
