"""Writes the solid of a STEP file as an OBJ mesh in millimetres whose vertices lie exactly on its surfaces.

Prints the file's unit and the diameters of its cylinders.
"""

import argparse
import pathlib

PACKAGES = ("cadquery-ocp-novtk",)


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Adds its arguments."""
    parser.add_argument("step", type=pathlib.Path, help="STEP file of a solid, or of several that do not overlap")
    parser.add_argument("obj", type=pathlib.Path, help="OBJ file to write")


def run(arguments: argparse.Namespace) -> None:
    """Converts."""
    from lab import step

    step.convert(arguments.step, arguments.obj)
