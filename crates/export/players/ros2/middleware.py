"""The topics of a robot in ROS 2. Nothing else here knows ROS."""

import argparse
import threading
import time

import numpy as np
import rclpy
from geometry_msgs.msg import PoseStamped, WrenchStamped
from rclpy.signals import SignalHandlerOptions
from sensor_msgs.msg import JointState
from std_msgs.msg import Float64MultiArray

from ros2_robot import Heard, MotionTarget


class Middleware:
    """A node that publishes references and keeps the newest measurements."""

    def __init__(self, arguments: argparse.Namespace, joints: list[str]) -> None:
        # Ctrl-C is the player's own: it still has to publish.
        rclpy.init(signal_handler_options=SignalHandlerOptions.NO)
        self.node = rclpy.create_node("assembly_plan_player")
        self.joints, self.frame = joints, arguments.frame
        self.lock, self.heard = threading.Lock(), Heard()
        node = self.node
        node.create_subscription(PoseStamped, arguments.pose_topic, self.hear_pose, 1)
        node.create_subscription(JointState, arguments.joint_topic, self.hear_joints, 1)
        node.create_subscription(WrenchStamped, arguments.wrench_topic, self.hear_wrench, 1)
        if arguments.message == "motion-update":
            from aic_control_interfaces.msg import MotionUpdate, TrajectoryGenerationMode

            self.update, self.mode = MotionUpdate, TrajectoryGenerationMode.MODE_POSITION
            self.targets = node.create_publisher(MotionUpdate, arguments.target_topic, 1)
        else:
            self.targets = node.create_publisher(PoseStamped, arguments.target_topic, 1)
            self.stiffness = node.create_publisher(Float64MultiArray, arguments.stiffness_topic, 1)
        self.thread = threading.Thread(target=self.spin, daemon=True)
        self.thread.start()

    def spin(self) -> None:
        """Hears until the node is shut down."""
        try:
            rclpy.spin(self.node)
        except rclpy.executors.ExternalShutdownException:
            pass

    def now(self) -> float:
        """Time (s)."""
        return self.node.get_clock().now().nanoseconds * 1e-9

    def wait(self, seconds: float) -> None:
        """Lets time pass."""
        time.sleep(seconds)

    def latest(self) -> Heard:
        """The newest measurements."""
        with self.lock:
            return Heard(**vars(self.heard))

    def publish_pose(self, target: MotionTarget) -> None:
        """A reference without gains."""
        message = PoseStamped()
        message.header.stamp, message.header.frame_id = self.node.get_clock().now().to_msg(), self.frame
        fill_pose(message.pose, target)
        self.targets.publish(message)

    def publish_stiffness(self, diagonal: list[float]) -> None:
        """Stiffness along and about the axes."""
        self.stiffness.publish(Float64MultiArray(data=diagonal))

    def publish_update(self, target: MotionTarget) -> None:
        """A reference with gains."""
        message = self.update()
        message.header.stamp, message.header.frame_id = self.node.get_clock().now().to_msg(), self.frame
        fill_pose(message.pose, target)
        for vector, numbers in ((message.velocity.linear, target.velocity), (message.velocity.angular, target.spin)):
            vector.x, vector.y, vector.z = numbers
        message.target_stiffness, message.target_damping = target.stiffness, target.damping
        message.trajectory_generation_mode.mode = self.mode
        self.targets.publish(message)

    def close(self) -> None:
        """Leaves ROS."""
        rclpy.try_shutdown()
        self.thread.join(timeout=1.0)

    def hear_pose(self, message: PoseStamped) -> None:
        position, turned = message.pose.position, message.pose.orientation
        pose = np.array([position.x, position.y, position.z, turned.w, turned.x, turned.y, turned.z])
        with self.lock:
            self.heard.pose, self.heard.pose_time = pose, self.now()

    def hear_joints(self, message: JointState) -> None:
        if not set(self.joints) <= set(message.name):
            return
        indices = [message.name.index(name) for name in self.joints]
        with self.lock:
            self.heard.positions = np.array([message.position[index] for index in indices])
            self.heard.speeds = np.array([message.velocity[index] for index in indices]) if message.velocity else None
            self.heard.joint_time = self.now()

    def hear_wrench(self, message: WrenchStamped) -> None:
        force, torque = message.wrench.force, message.wrench.torque
        with self.lock:
            self.heard.wrench = np.array([force.x, force.y, force.z, torque.x, torque.y, torque.z])
            self.heard.wrench_time = self.now()


def fill_pose(pose: object, target: MotionTarget) -> None:
    """Position and quaternion of a message."""
    pose.position.x, pose.position.y, pose.position.z = target.position
    pose.orientation.w, pose.orientation.x, pose.orientation.y, pose.orientation.z = target.quaternion
