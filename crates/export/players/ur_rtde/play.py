#!/usr/bin/env python3
"""Plays the plan of this folder on a robot of Universal Robots. --help explains; README.md has the steps before."""

import argparse
import os
import sys

try:
    import ur_robot
    from session import main
except ImportError as error:
    print(f"error: {error}; this player needs two packages: pip install numpy ur-rtde", file=sys.stderr)
    sys.exit(3)


def parser() -> argparse.ArgumentParser:
    """The command line."""
    parser = argparse.ArgumentParser(description=__doc__)
    add = parser.add_argument
    add("host", help="address of the robot")
    add(
        "--mode",
        choices=("auto", "torque", "force"),
        default="auto",
        help="torque: joint torques, PolyScope 5.26 or newer; force: force mode, whose gains are the robot's own [default: "
        "torque where the robot can]",
    )
    add("--force-mode-gain", type=float, default=0.5, metavar="G", help="gain scaling of force mode, 0 to 2 [default: 0.5]")
    add("--force-mode-damping", type=float, default=0.025, metavar="D", help="its damping, 0 to 1 [default: 0.025]")
    return parser


if __name__ == "__main__":
    code = main(parser(), ur_robot.connect)
    sys.stderr.flush()
    # The package waits for ever for a robot that does not answer, also when the interpreter ends.
    os._exit(code)
