"""Plans pairs of real parts from their meshes, plays the plans in MuJoCo and writes a page about them.

It resumes where it was stopped.
"""

import argparse
import pathlib
import tomllib

from lab import notebook, program
from lab.paths import OUT
from lab.real_parts import make
from lab.real_parts.page import page


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Adds its arguments."""
    add = parser.add_argument
    add("folder", type=pathlib.Path, help="folder with the meshes of scripts/python/lab/real_parts/manifest.toml")
    add("--jobs", type=int, default=2, help="threads of each solve, processes of MuJoCo [default: 2]")
    add("--time-limit", type=int, default=180, help="of each solve (s) [default: 180]")
    add("--count", type=int, default=20, help="random offsets per magnitude in MuJoCo [default: 20]")
    add("--skip", action="append", default=[], metavar="NAME", help="plan nothing new for this pair; may be repeated")


def run(arguments: argparse.Namespace) -> None:
    """Runs everything and writes the page."""
    program.build()
    arguments.folder = arguments.folder.resolve()
    pairs = tomllib.loads((make.HERE / "manifest.toml").read_text())["pair"]
    made = [(pair, OUT / "real-parts" / pair["name"].replace(" ", "-").replace(",", "")) for pair in pairs]
    for pair, out in made:
        if pair["name"] not in arguments.skip:
            make.run(arguments, pair, out)
    notebook.write("real-parts", "Real parts", page(arguments, made))
