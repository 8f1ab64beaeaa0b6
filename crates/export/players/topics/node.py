"""A node of ROS 2: measurements, the parameters of controllers, and a publisher. Nothing but the players' middleware knows ROS."""

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
from topic_robot import Value, Values

# Longest wait (s) for a node to say or take its parameters.
PATIENCE = 2.0
# Where a parameter has its value, and how that is written.
FIELDS = {
    ParameterType.PARAMETER_INTEGER: ("integer_value", int),
    ParameterType.PARAMETER_DOUBLE: ("double_value", float),
    ParameterType.PARAMETER_STRING: ("string_value", str),
    ParameterType.PARAMETER_BOOL_ARRAY: ("bool_array_value", list),
    ParameterType.PARAMETER_DOUBLE_ARRAY: ("double_array_value", list),
}


class Node:
    """Publishes one kind of message and puts measurements into the inbox."""

    def __init__(self, arguments: argparse.Namespace, joints: list[str], kind: type, topic: str, more: tuple[str, ...] = ()) -> None:
        # Signals are the player's own: it still has to publish.
        rclpy.init(signal_handler_options=SignalHandlerOptions.NO)
        self.node = rclpy.create_node("assembly_plan_player")
        self.joints, self.frame = joints, arguments.frame
        self.inbox = Inbox(arguments.frame, ["pose", "wrench", *(["joint states"] if joints else []), *more])
        node = self.node
        node.create_subscription(PoseStamped, arguments.pose_topic, self.hear_pose, 1)
        node.create_subscription(JointState, arguments.joint_topic, self.hear_joints, 1)
        node.create_subscription(WrenchStamped, arguments.wrench_topic, self.hear_wrench, 1)
        self.targets = node.create_publisher(kind, topic, 1)
        self.thread = threading.Thread(target=self.spin, daemon=True)

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

    def parameters(self, of: str, names: list[str]) -> Values:
        """Parameters of a node."""
        response = self.call(GetParameters, of, "get_parameters", GetParameters.Request(names=names))
        if len(response.values) != len(names) or any(value.type not in FIELDS for value in response.values):
            raise InputError(f"`{of}` has no parameters {', '.join(names)}; name the controller with --controller")
        return {name: value_of(value) for name, value in zip(names, response.values)}

    def set_parameters(self, of: str, values: Values) -> None:
        """Sets all of them or none."""
        parameters = [Parameter(name=name, value=parameter_value(value)) for name, value in values.items()]
        request = SetParametersAtomically.Request(parameters=parameters)
        response = self.call(SetParametersAtomically, of, "set_parameters_atomically", request)
        if not response.result.successful:
            raise InputError(f"`{of}` does not take the gains of the plan: {response.result.reason}")

    def call(self, kind: type, of: str, service: str, request: object) -> object:
        """A service of a node."""
        client = self.node.create_client(kind, f"{of}/{service}")
        try:
            future = client.call_async(request) if client.wait_for_service(timeout_sec=PATIENCE) else None
            deadline = self.now() + PATIENCE
            while future is not None and not future.done() and self.now() < deadline:
                self.wait(0.001)
            if future is None or not future.done():
                raise InputError(f"`{of}` does not answer; name the controller with --controller")
            return future.result()
        finally:
            self.node.destroy_client(client)

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


def value_of(parameter: ParameterValue) -> Value:
    """The value of a parameter."""
    field, kind = FIELDS[parameter.type]
    return kind(getattr(parameter, field))


def parameter_value(value: Value) -> ParameterValue:
    """A number, or a list of numbers or truth values, as a parameter."""
    if isinstance(value, float):
        return ParameterValue(type=ParameterType.PARAMETER_DOUBLE, double_value=value)
    if isinstance(value[0], bool):
        return ParameterValue(type=ParameterType.PARAMETER_BOOL_ARRAY, bool_array_value=value)
    return ParameterValue(type=ParameterType.PARAMETER_DOUBLE_ARRAY, double_array_value=value)
