"""Prints what the optimal control problem is worth, as a Markdown table.

Straight pushes, refined by the loop of --robust for the same time without solving anything, beside plans and robust
plans.
"""

import argparse
import pathlib
import subprocess

from lab import tables
from lab.paths import ROOT, SCENES

NAMES = ("peg1", "peg2", "peg3", "peg4", "peg5", "clamp1", "clamp2", "clamp3")
COLUMNS = [
    "scene",
    *("push, %", "force, N"),
    *("refined push, %", "force, N", "after s"),
    *("plan, %", "force, N", "after s"),
    *("robust plan, %", "force, N", "after s"),
]


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Adds its arguments."""
    scenes = [SCENES / f"{name}.toml" for name in NAMES]
    parser.add_argument(
        "scenes", nargs="*", type=pathlib.Path, default=scenes, help="scene files [default: all shipped]"
    )


def run(arguments: argparse.Namespace) -> None:
    """Prints the head; an example of the crate `planner` measures and prints the rows."""
    print(tables.head(COLUMNS), flush=True)
    cargo = ["cargo", "run", "--quiet", "--release", "--locked", "--package", "planner", "--example", "baseline", "--"]
    subprocess.run([*cargo, *(scene.resolve() for scene in arguments.scenes)], cwd=ROOT, check=True)
