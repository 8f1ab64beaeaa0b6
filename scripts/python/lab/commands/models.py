"""Checks models that `assembly-plan export` writes for simulators with the libraries that know them.

Each plan is exported for MuJoCo, as SDF and as OpenUSD, and read with mujoco, Drake and usd-core: corners, masses and
start must be those of the plan. MuJoCo also plays the model as it is, which must end as in `validate`, an arm without
joint friction.
"""

import argparse
import pathlib

PACKAGES = ("drake", "mujoco", "numpy", "usd-core")


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Adds its arguments."""
    parser.add_argument("plans", nargs="+", type=pathlib.Path, metavar="DIR", help="folders that `solve` wrote")
    parser.add_argument("--program", type=pathlib.Path, metavar="FILE", help="assembly-plan [default: built]")


def run(arguments: argparse.Namespace) -> int:
    """Runs what the command line asks for; returns the exit code."""
    from lab import program
    from lab.validation import models

    binary = program.given_or_built(arguments.program).resolve()
    return 0 if all([models.check(binary, plan) for plan in arguments.plans]) else 1
