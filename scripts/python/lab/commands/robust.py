"""Makes robust plans of many scenes, plays them in MuJoCo and writes a page about them.

It can be stopped at any moment and resumes where it was.
"""

import argparse
import pathlib

from lab import program
from lab.robust import arms, bodies
from lab.robust.cases import COUNT


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Adds its arguments."""
    add = parser.add_argument
    add("scenes", nargs="*", help="only these scenes, by name [default: all]")
    add("--jobs", type=int, default=1, help="threads of each solve, processes of MuJoCo [default: 1]")
    add("--count", type=int, default=COUNT, help=f"random offsets of each magnitude in MuJoCo [default: {COUNT}]")
    add(
        "--friction",
        metavar="LIST",
        help="plan and play with these friction coefficients, 0.0,0.1 for example, and write a page of its own",
    )
    add("--no-run", action="store_true", help="only write the page, from what is in out/")
    add(
        "--arm",
        type=pathlib.Path,
        action="append",
        default=[],
        metavar="FILE",
        help="plan for the [robot] table of this TOML file, let the whole arm play, and write a page of its own; "
        "may be repeated",
    )
    add("--starts", type=int, metavar="N", help="only the first N starts of each scene [default: all]")


def run(arguments: argparse.Namespace) -> None:
    """Runs what is missing and writes the page."""
    if not arguments.no_run:
        program.build()
    (arms if arguments.arm else bodies).make(arguments)
