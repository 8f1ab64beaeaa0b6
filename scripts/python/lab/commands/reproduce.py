"""Repeats the paper's experiments and writes pages of what came out, beside the paper's numbers.

Runs are kept in out/reproduction; the same command resumes where it was stopped.
"""

import argparse
import pathlib

from lab import notebook, program
from lab.errors import InputError
from lab.paths import OUT

PACKAGES = ("matplotlib", "mujoco", "numpy")
PAGES = ("distances", "pegs", "clamps", "force-mode", "hessians")


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Adds its arguments."""
    add = parser.add_argument
    add("pages", nargs="*", metavar="PAGE", help=f"of {', '.join(PAGES)} [default: all]")
    add("--jobs", type=int, default=1, help="plans solved at once; more make wall times larger [default: 1]")
    add("--quick", action="store_true", help="only the first plan of every study, a few minutes")
    add("--no-run", action="store_true", help="solve and measure nothing, only write what there is")
    add(
        "--out",
        type=pathlib.Path,
        help="folder of the pages [default: that of the documentation, with --quick out/reproduction/pages]",
    )


def run(arguments: argparse.Namespace) -> None:
    """Runs and writes."""
    from lab.reproduction import book

    if unknown := [page for page in arguments.pages if page not in PAGES]:
        raise InputError(f"there is no page {unknown[0]}; there are {', '.join(PAGES)}")
    if arguments.jobs < 1:
        raise InputError(f"--jobs {arguments.jobs}: must be at least 1")
    if not arguments.no_run:
        program.build()
        book.run(arguments.pages or list(PAGES), arguments.jobs, arguments.quick)
    book.write(arguments.out or (OUT / "reproduction/pages" if arguments.quick else notebook.FOLDER / "reproduction"))
