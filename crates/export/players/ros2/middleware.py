"""The topics of a Cartesian impedance controller of ROS 2."""

import argparse

from geometry_msgs.msg import Pose, PoseStamped

from node import Node
from ros2_robot import MotionTarget


class Middleware(Node):
    """Publishes references with gains or without."""

    def __init__(self, arguments: argparse.Namespace, joints: list[str]) -> None:
        kind = PoseStamped
        if arguments.message == "motion-update":
            from aic_control_interfaces.msg import MotionUpdate, TrajectoryGenerationMode

            kind, self.mode = MotionUpdate, TrajectoryGenerationMode.MODE_POSITION
        self.kind = kind
        super().__init__(arguments, joints, kind, arguments.target_topic)
        self.thread.start()

    def publish_pose(self, target: MotionTarget) -> None:
        """A reference without gains."""
        self.targets.publish(self.stamped(target))

    def publish_update(self, target: MotionTarget) -> None:
        """A reference with gains."""
        message = self.stamped(target)
        for vector, numbers in ((message.velocity.linear, target.velocity), (message.velocity.angular, target.spin)):
            vector.x, vector.y, vector.z = numbers
        message.target_stiffness, message.target_damping = target.stiffness, target.damping
        message.trajectory_generation_mode.mode = self.mode
        self.targets.publish(message)

    def stamped(self, target: MotionTarget) -> object:
        """A message with time, frame and pose."""
        message = self.kind()
        message.header.stamp, message.header.frame_id = self.node.get_clock().now().to_msg(), self.frame
        fill_pose(message.pose, target)
        return message


def fill_pose(pose: Pose, target: MotionTarget) -> None:
    """Position and quaternion of a message."""
    pose.position.x, pose.position.y, pose.position.z = target.position
    pose.orientation.w, pose.orientation.x, pose.orientation.y, pose.orientation.z = target.quaternion
