"""The topics of a robot in ROS 2. Nothing else here knows ROS."""

import argparse
import threading
import time

import numpy as np
import rclpy
from geometry_msgs.msg import PoseStamped, WrenchStamped
from rcl_interfaces.msg import Parameter, ParameterType, ParameterValue
from rcl_interfaces.srv import GetParameters, SetParametersAtomically
from rclpy.signals import SignalHandlerOptions
from rclpy.time import Time
from sensor_msgs.msg import JointState

from failures import InputError
from inbox import Inbox, Message
from ros2_robot import MotionTarget

# Longest wait (s) for the controller to say or take its parameters.
PATIENCE = 2.0


class Middleware:
    """A node that publishes references and puts measurements into the inbox."""

    def __init__(self, arguments: argparse.Namespace, joints: list[str]) -> None:
        # Signals are the player's own: it still has to publish.
        rclpy.init(signal_handler_options=SignalHandlerOptions.NO)
        self.node = rclpy.create_node("assembly_plan_player")
        self.joints, self.frame, self.controller = joints, arguments.frame, arguments.controller
        self.inbox = Inbox(arguments.frame, bool(joints))
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
        self.thread = threading.Thread(target=self.spin, daemon=True)
        self.thread.start()

    def spin(self) -> None:
        """Hears until the node is shut down."""
        try:
            rclpy.spin(self.node)
        except rclpy.executors.ExternalShutdownException:
            pass

    def now(self) -> float:
        """Time (s) that nobody sets."""
        return time.monotonic()

    def wait(self, seconds: float) -> None:
        """Lets time pass."""
        time.sleep(max(0.0, seconds))

    def hearers(self) -> int:
        """How many subscriptions there are to the references."""
        return self.targets.get_subscription_count()

    def parameters(self, names: list[str]) -> list[float]:
        """Numbers that the controller has as its parameters."""
        response = self.call(GetParameters, "get_parameters", GetParameters.Request(names=names))
        if len(response.values) != len(names) or any(value.type != ParameterType.PARAMETER_DOUBLE for value in response.values):
            raise InputError(f"`{self.controller}` has no parameters {', '.join(names)}; name the controller with --controller")
        return [value.double_value for value in response.values]

    def set_parameters(self, names: list[str], values: list[float]) -> None:
        """Sets all of them or none."""
        double = ParameterType.PARAMETER_DOUBLE
        parameters = [
            Parameter(name=name, value=ParameterValue(type=double, double_value=float(value)))
            for name, value in zip(names, values)
        ]
        request = SetParametersAtomically.Request(parameters=parameters)
        response = self.call(SetParametersAtomically, "set_parameters_atomically", request)
        if not response.result.successful:
            raise InputError(f"`{self.controller}` does not take the gains of the plan: {response.result.reason}")

    def call(self, kind: type, service: str, request: object) -> object:
        """A service of the controller."""
        client = self.node.create_client(kind, f"{self.controller}/{service}")
        try:
            future = client.call_async(request) if client.wait_for_service(timeout_sec=PATIENCE) else None
            deadline = self.now() + PATIENCE
            while future is not None and not future.done() and self.now() < deadline:
                self.wait(0.001)
            if future is None or not future.done():
                raise InputError(f"the controller `{self.controller}` does not answer; name it with --controller")
            return future.result()
        finally:
            self.node.destroy_client(client)

    def publish_pose(self, target: MotionTarget) -> None:
        """A reference without gains."""
        message = PoseStamped()
        message.header.stamp, message.header.frame_id = self.node.get_clock().now().to_msg(), self.frame
        fill_pose(message.pose, target)
        self.targets.publish(message)

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

    def message(self, header: object, values: list[float]) -> Message:
        """Values with the times of their message."""
        stamp = header.stamp.sec + 1e-9 * header.stamp.nanosec
        if not stamp:
            return Message(np.array(values), self.now())
        age = (self.node.get_clock().now() - Time.from_msg(header.stamp)).nanoseconds * 1e-9
        return Message(np.array(values), self.now(), stamp, age)

    def hear_pose(self, message: PoseStamped) -> None:
        position, turned = message.pose.position, message.pose.orientation
        values = [position.x, position.y, position.z, turned.w, turned.x, turned.y, turned.z]
        self.inbox.put_pose(self.message(message.header, values), message.header.frame_id)

    def hear_joints(self, message: JointState) -> None:
        if not set(self.joints) <= set(message.name):
            return
        indices = [message.name.index(name) for name in self.joints]
        for what, values in (("positions", message.position), ("velocities", message.velocity)):
            if len(values) != len(message.name):
                self.inbox.refuse(f"joint states come with {len(values)} {what} for {len(message.name)} joints")
                return
        values = [values[index] for values in (message.position, message.velocity) for index in indices]
        self.inbox.put("joint states", self.message(message.header, values))

    def hear_wrench(self, message: WrenchStamped) -> None:
        force, torque = message.wrench.force, message.wrench.torque
        self.inbox.put("wrench", self.message(message.header, [force.x, force.y, force.z, torque.x, torque.y, torque.z]))


def fill_pose(pose: object, target: MotionTarget) -> None:
    """Position and quaternion of a message."""
    pose.position.x, pose.position.y, pose.position.z = target.position
    pose.orientation.w, pose.orientation.x, pose.orientation.y, pose.orientation.z = target.quaternion
