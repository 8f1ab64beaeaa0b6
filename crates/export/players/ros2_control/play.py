#!/usr/bin/env python3
"""Plays the plan of this folder through the admittance controller of ros2_controllers. --help explains; README.md has the steps
before."""

import argparse
import sys

try:
    import admittance_robot
    import middleware
    from session import main
    from topic_robot import add_topics
except ImportError as error:
    print(
        f"error: {error}; this player needs ROS 2 with rclpy, control_msgs, geometry_msgs, rcl_interfaces, sensor_msgs and "
        "trajectory_msgs (source its setup.bash), and: pip install numpy",
        file=sys.stderr,
    )
    sys.exit(3)


def parser() -> argparse.ArgumentParser:
    """The command line."""
    parser = argparse.ArgumentParser(description=__doc__)
    add = parser.add_argument
    add("--controller", default="admittance_controller", metavar="NODE", help="the admittance controller [default: %(default)s]")
    add(
        "--controller-manager",
        default="controller_manager",
        metavar="NODE",
        help="whose update_rate is the rate of the law [default: %(default)s]",
    )
    add("--frame", metavar="NAME", help="name of the robot's base [default: the root link of the URDF file]")
    add_topics(parser, pose="pose_broadcaster/pose", wrench="force_torque_sensor_broadcaster/wrench")
    add(
        "--status-topic",
        metavar="TOPIC",
        help="AdmittanceControllerState of the controller [default: `status` below its name]",
    )
    return parser


def connect(arguments: argparse.Namespace, plan: object, settings: object) -> admittance_robot.AdmittanceRobot:
    """The robot behind the topics."""
    return admittance_robot.connect(arguments, plan, settings, middleware.Middleware)


if __name__ == "__main__":
    sys.exit(main(parser(), connect))
