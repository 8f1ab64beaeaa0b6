"""Plain parts, written by trimesh and by numpy-stl."""

import pathlib
import random

import numpy
import stl
import trimesh
from shapely.geometry import Polygon


def part(number: int) -> trimesh.Trimesh:
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


def write(mesh: trimesh.Trimesh, folder: pathlib.Path, name: str) -> list[pathlib.Path]:
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
