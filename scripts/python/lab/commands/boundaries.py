"""Finds the offsets that plans tolerate in MuJoCo or Drake, beside those that `assembly-plan tolerance` predicts.

For each plan, `tolerance` predicts the largest offset at which 90 % of the motions succeed. Random offsets are then
scaled to nine magnitudes around that one, in steps of 5 % (at least 0.1 mm). By bisection, both the engine and
`assembly-plan simulate` find the largest one at which each case succeeds, with the frictions of the plan in turn. The
boundary is the largest magnitude at which 90 % of the cases succeed.

Rotation errors and limits of forces are left out: plans with them are refused. What is in the folder of results is not
done again.
"""

import argparse
import pathlib

from lab import environment
from lab.paths import OUT, PROGRAM
from lab.validation.arguments import positive

PACKAGES = ("mujoco", "numpy")

EPILOG = """\
Examples:
  scripts/lab boundaries out/peg out/clamp1
  scripts/lab boundaries out/peg --engine drake --cases 12"""


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Adds its arguments."""
    add = parser.add_argument
    add("plans", nargs="+", type=pathlib.Path, metavar="DIR", help="folders that `solve` wrote")
    add("--engine", choices=("mujoco", "drake"), default="mujoco", help="which engine [default: mujoco]")
    step = "of the engine [default: 0.0005 s in MuJoCo, 0.00025 s in Drake]"
    add("--time-step", type=positive(float), metavar="S", help=step)
    stiffness = "of contacts in Drake [default: 1e6]"
    add("--contact-stiffness", type=positive(float), default=1e6, metavar="N/M", help=stiffness)
    add("--cases", type=positive(int), default=60, metavar="N", help="random offsets per plan [default: 60]")
    add("--seed", type=int, default=1, metavar="N", help="seed of the offsets [default: 1]")
    add("--target-rate", type=float, default=0.9, metavar="RATE", help="success rate to reach [default: 0.9]")
    add("--jobs", type=positive(int), default=1, metavar="N", help="threads of assembly-plan [default: 1]")
    add("--program", type=pathlib.Path, metavar="FILE", help=f"run this one instead of building {PROGRAM.name}")
    add("--out", type=pathlib.Path, default=OUT / "boundaries", metavar="DIR", help="folder of results")


def run(arguments: argparse.Namespace) -> None:
    """Measures what is missing, and prints the table."""
    if arguments.engine == "drake":
        environment.enter(("drake", *PACKAGES))
    from lab import program
    from lab.boundaries import study

    arguments.program = program.given_or_built(arguments.program).resolve()
    print(study.study(arguments))
