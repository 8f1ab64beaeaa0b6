"""Plays plans of `assembly-plan solve` through MuJoCo or Drake and prints how often they succeed.

The body moves freely, driven by the impedance wrench alone, with errors of the part in the gripper (body frame) that
are injected as in the plan: the body starts displaced and rotated by the error, which the controller does not measure.
After the last knot the reference rests for the settling time, then the final pose is judged.

With --arm a whole arm plays the plan: that of its [robot] table, with its rotor inertia, joint friction, gravity, and
joint torques that are computed every control period.
"""

import argparse

from lab import environment
from lab.validation import arguments as flags

PACKAGES = ("mujoco", "numpy")
EPILOG = """\
Exit codes: 0 done, 1 the self-test failed, 2 wrong input or usage, 3 anything else, 130 interrupted.

Examples:
  scripts/lab validate out/peg1-1 --position-tolerance 0.005 --friction 0,0.1,0.3
  scripts/lab validate out/clamp1-* --magnitude 0mm,2mm,4mm,5mm --jobs 2 --csv clamp1.csv
  scripts/lab validate out/peg1-1 --engine drake --contact-stiffness 5e4
  scripts/lab validate out/peg1-1 --arm --rotation-error 0.02
  scripts/lab validate out/peg1-1 --arm --robot examples/arms/six.toml --gain-factor 8.5"""


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Adds its arguments."""
    flags.add_arguments(parser)


def run(arguments: argparse.Namespace) -> int:
    """Runs what the command line asks for; returns the exit code."""
    flags.check(arguments)
    if arguments.engine == "drake":
        environment.enter(("drake", *PACKAGES))
    from lab.validation import play

    return play.run(arguments)
