"""Reads, plans and plays pairs of plugs and sockets, and prints a table about them.

FOLDER has one folder for each assembly, with the files plug.obj and socket.obj in the assembled pose. What is known
of an assembly is in out/assemblies/NAME.json; what is there is not done again.
"""

import argparse
import pathlib

from lab.paths import OUT, PROGRAM

EPILOG = """\
Examples:
  scripts/lab assemblies parts/automate --only read
  scripts/lab assemblies parts/automate --time 300 --jobs 2
  scripts/lab assemblies parts/automate --name 00062 --name 00103"""


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Adds its arguments."""
    add = parser.add_argument
    add("folder", type=pathlib.Path, metavar="FOLDER", help="folder of the assemblies")
    add("--name", action="append", metavar="NAME", help="only this assembly; may be repeated [default: all]")
    add("--only", choices=["read", "plan"], help="end after this stage [default: also play plans in MuJoCo]")
    add("--time", type=int, default=300, metavar="S", help="limit of each plan (s) [default: 300]")
    add("--jobs", type=int, default=2, metavar="N", help="threads of each plan, processes of MuJoCo [default: 2]")
    add("--count", type=int, default=20, metavar="N", help="random offsets per friction in MuJoCo [default: 20]")
    add("--unit", default="m", help="unit of the files [default: m]")
    add("--axis", default="z", help="direction in which plugs are taken out [default: z]")
    add("--program", type=pathlib.Path, metavar="FILE", help=f"run this one instead of building {PROGRAM.name}")
    add("--out", type=pathlib.Path, default=OUT / "assemblies", metavar="DIR", help="folder of results")


def run(arguments: argparse.Namespace) -> None:
    """Runs all stages and prints the table."""
    from lab import program
    from lab.assemblies import stages, table
    from lab.errors import InputError

    arguments.program = program.given_or_built(arguments.program)
    found = sorted(file.parent.name for file in arguments.folder.glob("*/plug.obj"))
    names = arguments.name or found
    if not names or not set(names) <= set(found):
        missing = ", ".join(sorted(set(names) - set(found)))
        raise InputError(f"{arguments.folder}: no folder {missing or 'NAME'} with plug.obj and socket.obj")
    arguments.out.mkdir(parents=True, exist_ok=True)
    results = {name: stages.run(arguments, name) for name in names}
    text = table.text(results)
    (arguments.out / "table.md").write_text(text)
    print(text)
