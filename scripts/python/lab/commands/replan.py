"""Moves robust plans to starts that were measured again, and prints how often that is enough, and how long it takes.

Every scene is planned once. Its start is then moved by each distance, and turned by as many degrees as millimetres, in
random directions. What is there is not done again. The figure is replan.svg in the folder of results.
"""

import argparse
import pathlib

from lab.paths import OUT, PROGRAM

PACKAGES = ("matplotlib", "mujoco", "numpy")

EPILOG = """\
Examples:
  scripts/lab replan peg1 peg3 clamp1
  scripts/lab replan clamp1 --distances 1,5,10 --count 8"""


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Adds its arguments."""
    add = parser.add_argument
    add("scenes", nargs="+", metavar="SCENE", help="scenes by their names in scenes/")
    add("--distances", default="1,3,5", metavar="MM,...", help="how far starts are moved (mm) [default: 1,3,5]")
    add("--count", type=int, default=4, metavar="N", help="starts per scene and distance [default: 4]")
    add("--seed", type=int, default=1, metavar="N", help="seed of their directions [default: 1]")
    add("--friction", default="0,0.1,0.3", help="friction that plans must tolerate [default: 0,0.1,0.3]")
    add("--time", type=int, default=120, metavar="S", help="limit of each plan (s) [default: 120]")
    add("--jobs", type=int, default=2, metavar="N", help="threads of each plan [default: 2]")
    add("--program", type=pathlib.Path, metavar="FILE", help=f"run this one instead of building {PROGRAM.name}")
    add("--out", type=pathlib.Path, default=OUT / "replan", metavar="DIR", help="folder of results")


def run(arguments: argparse.Namespace) -> None:
    """Plans, moves the plans, and prints the table."""
    from lab import program
    from lab.robust import replan

    arguments.program = program.given_or_built(arguments.program)
    print(replan.study(arguments))
