"""The topics of the admittance controller of ros2_controllers."""

import argparse

import numpy as np
from control_msgs.msg import AdmittanceControllerState
from trajectory_msgs.msg import JointTrajectoryPoint

from admittance_robot import OFFSETS
from inbox import Message
from node import Node


class Middleware(Node):
    """Publishes joint references and hears the offsets that the controller adds to them."""

    def __init__(self, arguments: argparse.Namespace, joints: list[str]) -> None:
        super().__init__(arguments, joints, JointTrajectoryPoint, f"{arguments.controller}/joint_references", (OFFSETS,))
        status = arguments.status_topic or f"{arguments.controller}/status"
        self.node.create_subscription(AdmittanceControllerState, status, self.hear_state, 1)
        self.thread.start()

    def publish_joints(self, positions: list[float], speeds: list[float]) -> None:
        """A reference of all joints, in the order of the plan."""
        self.targets.publish(JointTrajectoryPoint(positions=positions, velocities=speeds))

    def hear_state(self, message: AdmittanceControllerState) -> None:
        """The controller has other joints, or another order of them: references would go to the wrong ones."""
        names = list(message.joint_state.name)
        if names != self.joints:
            self.inbox.refuse(f"the controller moves the joints {', '.join(names)}, and the plan {', '.join(self.joints)}")
            return
        self.inbox.put(OFFSETS, Message(np.array(message.joint_state.position), self.now()))
