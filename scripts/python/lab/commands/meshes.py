"""Checks that plain parts written by trimesh and by numpy-stl are read as closed, with their volumes.

Cylinders, rings and prisms with coordinates of 1 to 6 decimals, each as binary STL, ASCII STL and OBJ.
"""

import argparse
import pathlib
import random
import subprocess
import tempfile

from lab.paths import ROOT

PACKAGES = ("mapbox_earcut", "numpy", "numpy-stl", "shapely", "trimesh")
# Rounding of single precision and of files with few digits (relative).
TOLERANCE = 1e-4


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Adds its arguments."""
    parser.add_argument("count", nargs="?", type=int, default=500, help="number of parts [default: 500]")


def run(arguments: argparse.Namespace) -> int:
    """Writes parts and reads them; returns the exit code."""
    from lab import meshes

    random.seed(51)
    with tempfile.TemporaryDirectory() as folder:
        expected = {}
        for number in range(arguments.count):
            mesh = meshes.part(number)
            for file in meshes.write(mesh, pathlib.Path(folder), f"part{number}"):
                expected[str(file)] = mesh.volume
        said = [line.split("\t", 1) for line in volumes(list(expected))]
    wrong = [(file, result) for file, result in said if not is_right(result, expected[file])]
    for file, result in wrong:
        print(f"{pathlib.Path(file).name}: {result}, not {expected[file]}")
    print(f"{len(said)} files of {arguments.count} parts, {len(wrong)} wrong")
    return int(bool(wrong) or len(said) != len(expected))


def volumes(files: list[str]) -> list[str]:
    """Lines of files and their volumes, or what is wrong with them."""
    command = ["cargo", "run", "--quiet", "--package", "mesh", "--example", "volumes", "--", *files]
    return subprocess.run(command, cwd=ROOT, check=True, capture_output=True, text=True).stdout.splitlines()


def is_right(result: str, volume: float) -> bool:
    """Whether a result is this volume."""
    try:
        return abs(float(result) - volume) <= TOLERANCE * volume
    except ValueError:
        return False
