#!/usr/bin/env python3
"""Plays the plan of this folder through a Cartesian impedance controller of ROS 2. --help explains; README.md has the steps
before."""

import argparse
import sys

try:
    import middleware
    import ros2_robot
    from session import main
    from topic_robot import add_topics
except ImportError as error:
    print(
        f"error: {error}; this player needs ROS 2 with rclpy, geometry_msgs, rcl_interfaces and sensor_msgs (source its "
        "setup.bash), for --message motion-update also aic_control_interfaces, and: pip install numpy",
        file=sys.stderr,
    )
    sys.exit(3)


def parser() -> argparse.ArgumentParser:
    """The command line."""
    parser = argparse.ArgumentParser(description=__doc__)
    add = parser.add_argument
    add(
        "--message",
        choices=ros2_robot.MESSAGES,
        default=ros2_robot.MESSAGES[0],
        help="pose: geometry_msgs/PoseStamped, and the diagonals of the gains as parameters of the controller, as "
        "crisp_controllers has them; motion-update: aic_control_interfaces/MotionUpdate with stiffness and damping "
        "[default: %(default)s]",
    )
    add("--frame", default="base_link", metavar="NAME", help="name of the robot's base [default: %(default)s]")
    add("--target-topic", default="target_pose", metavar="TOPIC", help="of references [default: %(default)s]")
    add(
        "--controller",
        default="cartesian_impedance_controller",
        metavar="NODE",
        help="whose parameters the gains are, with --message pose [default: %(default)s]",
    )
    add_topics(parser, pose="current_pose", wrench="wrench")
    add("--rate", type=float, default=250.0, metavar="HZ", help="references per second [default: %(default)g]")
    return parser


def connect(arguments: argparse.Namespace, plan: object, _: object) -> ros2_robot.Ros2Robot:
    """The robot behind the topics."""
    return ros2_robot.connect(arguments, plan, middleware.Middleware)


if __name__ == "__main__":
    sys.exit(main(parser(), connect))
