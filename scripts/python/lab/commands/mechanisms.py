"""Switches parts of the search for robust plans off, one at a time, and prints what each is worth.

Every scene is planned by every search with several seeds, each plan in one thread. What is there is not done again.
"""

import argparse
import pathlib

from lab.paths import OUT, PROGRAM

EPILOG = """\
Examples:
  scripts/lab mechanisms clamp1 clamp2 --time 20
  scripts/lab mechanisms clamp1 --arm robot.toml --seeds 5"""


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Adds its arguments."""
    add = parser.add_argument
    add("scenes", nargs="+", metavar="SCENE", help="scenes by their names in scenes/")
    add("--search", action="append", metavar="NAME", help="only this search, such as `no drafts`; may be repeated")
    add("--arm", type=pathlib.Path, metavar="FILE", help="file with the [robot] table of an arm that holds the body")
    add("--time", type=int, default=20, metavar="S", help="limit of each plan (s) [default: 20]")
    add("--seeds", type=int, default=3, metavar="N", help="number of seeds [default: 3]")
    add("--friction", default="0,0.1,0.3", help="friction that plans must tolerate [default: 0,0.1,0.3]")
    add("--jobs", type=int, default=2, metavar="N", help="plans at a time [default: 2]")
    add("--program", type=pathlib.Path, metavar="FILE", help=f"run this one instead of building {PROGRAM.name}")
    add("--out", type=pathlib.Path, default=OUT / "mechanisms", metavar="DIR", help="folder of results")


def run(arguments: argparse.Namespace) -> None:
    """Plans and prints the table."""
    from lab import program
    from lab.errors import InputError
    from lab.robust import mechanisms

    arguments.search = arguments.search or list(mechanisms.SEARCHES)
    if unknown := set(arguments.search) - set(mechanisms.SEARCHES):
        raise InputError(f"no search {', '.join(unknown)}; there are {', '.join(mechanisms.SEARCHES)}")
    arguments.program = program.given_or_built(arguments.program)
    print(mechanisms.study(arguments))
