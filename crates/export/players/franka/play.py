#!/usr/bin/env python3
"""Plays the plan of this folder on a robot of Franka Robotics. --help explains; README.md has the steps before."""

import argparse
import sys

try:
    import franka_robot
    from session import main
except ImportError as error:
    print(f"error: {error}; this player needs two packages: pip install numpy franky-control", file=sys.stderr)
    sys.exit(3)


def parser() -> argparse.ArgumentParser:
    """The command line."""
    parser = argparse.ArgumentParser(description=__doc__)
    add = parser.add_argument
    add("host", help="address of the robot")
    return parser


if __name__ == "__main__":
    sys.exit(main(parser(), franka_robot.connect))
