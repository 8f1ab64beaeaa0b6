"""Prints the folder of the Python environment, which has the named packages then."""

import argparse

from lab import environment


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Adds its arguments."""
    parser.add_argument("packages", nargs="+", metavar="PACKAGE", help="name of a package")


def run(arguments: argparse.Namespace) -> None:
    """Installs and prints."""
    environment.install(tuple(arguments.packages))
    print(environment.FOLDER)
