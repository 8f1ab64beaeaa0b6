"""Writes plain parts with trimesh and numpy-stl, and checks that they are read as closed with their volumes.

COUNT cylinders, rings and prisms, 500 by default, with coordinates of 1 to 6 decimals, each as binary STL, ASCII STL and
OBJ.
"""

import pathlib
import random
import subprocess
import sys
import tempfile

import numpy
import stl
import trimesh
from shapely.geometry import Polygon

# Rounding of single precision and of files with few digits (relative).
TOLERANCE = 1e-4
REPOSITORY = pathlib.Path(__file__).resolve().parents[2]


def part(number):
    """A mesh with rounded coordinates."""
    decimals = 1 + number % 6
    radius = round(random.uniform(5, 60), 1)
    height = round(random.uniform(1, 80), 1)
    sections = random.randrange(8, 40)
    match number % 3:
        case 0:
            mesh = trimesh.creation.cylinder(radius=radius, height=height, sections=sections)
        case 1:
            inner = round(radius * random.uniform(0.3, 0.8), 1)
            mesh = trimesh.creation.annulus(r_min=inner, r_max=radius, height=height, sections=sections)
        case _:
            angles = numpy.linspace(0, 2 * numpy.pi, sections, endpoint=False)
            radii = [radius * random.uniform(0.6, 1) for _ in angles]
            corners = numpy.round(numpy.column_stack([radii * numpy.cos(angles), radii * numpy.sin(angles)]), decimals)
            mesh = trimesh.creation.extrude_polygon(Polygon(corners), height)
    mesh.vertices = numpy.round(mesh.vertices, decimals)
    return mesh


def write(mesh, folder, name):
    """The files of a part by both libraries."""
    files = []
    for kind, suffix in [("stl", "stl"), ("stl_ascii", "stl"), ("obj", "obj")]:
        content = mesh.export(file_type=kind)
        files.append(folder / f"{name}_trimesh_{kind}.{suffix}")
        files[-1].write_bytes(content if isinstance(content, bytes) else content.encode())
    data = numpy.zeros(len(mesh.faces), dtype=stl.mesh.Mesh.dtype)
    data["vectors"] = mesh.vertices[mesh.faces]
    for mode in (stl.Mode.BINARY, stl.Mode.ASCII):
        files.append(folder / f"{name}_numpy_{mode.name}.stl")
        stl.mesh.Mesh(data).save(str(files[-1]), mode=mode)
    return files


def main():
    random.seed(51)
    count = int(sys.argv[1]) if len(sys.argv) > 1 else 500
    with tempfile.TemporaryDirectory() as folder:
        expected = {}
        for number in range(count):
            mesh = part(number)
            for file in write(mesh, pathlib.Path(folder), f"part{number}"):
                expected[str(file)] = mesh.volume
        command = ["cargo", "run", "--quiet", "--package", "mesh", "--example", "volumes", "--", *expected]
        lines = subprocess.run(command, cwd=REPOSITORY, check=True, capture_output=True, text=True).stdout.splitlines()
        wrong = 0
        for line in lines:
            file, result = line.split("\t", 1)
            try:
                right = abs(float(result) - expected[file]) <= TOLERANCE * expected[file]
            except ValueError:
                right = False
            if not right:
                wrong += 1
                print(f"{pathlib.Path(file).name}: {result}, not {expected[file]}")
        print(f"{len(lines)} files of {count} parts, {wrong} wrong")
        sys.exit(wrong > 0 or len(lines) != len(expected))


main()
