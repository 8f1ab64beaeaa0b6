"""Stand-in for the topics of a robot with a Cartesian impedance controller."""

import argparse

import numpy as np
from ros2_robot import DAMPING, STIFFNESS, MotionTarget

import rotations
from lab.players.impedance_controller import ImpedanceController
from lab.players.simulated_arm import SimulatedArm, Task
from lab.players.simulated_topics import SimulatedTopics

PERIOD = 0.002
# A controller that pulls the tool with less (N, Nm) leaves it at rest: a tool of which nothing is heard for 0.1 s has
# moved since.
AT_REST = 25.0
# What the controller has before anybody sets its gains.
GAINS = {**dict.fromkeys(STIFFNESS, 400.0), **dict.fromkeys(DAMPING, 40.0)}


class Middleware(SimulatedTopics):
    """With poses alone, damping brakes the tool and not its lag, as in crisp_controllers."""

    def __init__(self, arguments: argparse.Namespace, joints: list[str]) -> None:
        arm = SimulatedArm(Task.read())
        self.controller, self.pull = ImpedanceController(arm, PERIOD), np.zeros(6)
        super().__init__(arguments, arm, PERIOD, GAINS, [])

    def step(self) -> None:
        self.controller.step()

    def is_left_at_rest(self) -> bool:
        return bool(np.abs(self.pull).max() < AT_REST)

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
