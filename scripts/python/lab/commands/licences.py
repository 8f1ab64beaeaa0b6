"""Gathers the licences of what a package holds: those of crates, or of libraries."""

import argparse
import pathlib

from lab.packaging import debian, wheel


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Adds its arguments."""
    kinds = parser.add_subparsers(metavar="KIND", required=True)
    crates = kinds.add_parser("crates", help="print the licences of all crates that a program is linked with")
    crates.add_argument("package", help="name of the program's package")
    crates.set_defaults(run=lambda arguments: print(debian.licences_of_crates(arguments.package)))
    libraries = kinds.add_parser("wheel", help="add to a repaired wheel the licences of all that is in it")
    libraries.add_argument("wheel", type=pathlib.Path, help="file of the wheel")
    libraries.set_defaults(run=lambda arguments: wheel.add_licences(arguments.wheel.resolve()))
