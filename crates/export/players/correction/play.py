#!/usr/bin/env python3
"""Plays the plan of this folder on a robot that takes position corrections over UDP. --help explains; README.md has the protocol and
the steps before."""

import argparse
import sys

try:
    import correction_robot
    from session import main
except ImportError as error:
    print(f"error: {error}; this player needs a package: pip install numpy", file=sys.stderr)
    sys.exit(3)


def parser() -> argparse.ArgumentParser:
    """The command line."""
    parser = argparse.ArgumentParser(description=__doc__)
    add = parser.add_argument
    add("--address", default="0.0.0.0", metavar="IP", help="own address, at which the robot's datagrams arrive [default: %(default)s]")
    add("--port", type=int, default=49152, metavar="N", help="own port, 1 to 65535 [default: %(default)s]")
    add(
        "--longest-silence",
        type=float,
        default=0.1,
        metavar="S",
        help="without a datagram for this time, the player stops, 0 to 10 [default: %(default)s]",
    )
    # The player computes the law from its own commands, and the log says so.
    parser.set_defaults(spring_acts_on="commanded pose")
    return parser


if __name__ == "__main__":
    sys.exit(main(parser(), correction_robot.connect))
