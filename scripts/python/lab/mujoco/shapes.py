"""Corner points of the convex parts of a scene file: boxes, vertices, halfspaces, STL meshes."""

import pathlib
import re
from typing import Any

import numpy as np

from lab.mujoco.rotations import rotation_matrix

UNITS = {"m": 1.0, "cm": 0.01, "mm": 0.001, "inch": 0.0254}

# Corners nearer than this (m) are one; MuJoCo keeps vertices in single precision.
MERGE_DISTANCE = 1e-8


def part_vertices(part: dict[str, Any], folder: pathlib.Path) -> np.ndarray:
    """Corners (n x 3, m) of a part in its parent's frame; mesh files are relative to `folder`."""
    if "box" in part:
        signs = np.array([[x, y, z] for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)])
        vertices = signs * np.array(part["box"]) / 2
    elif "vertices" in part:
        vertices = np.array(part["vertices"])
    elif "mesh" in part:
        vertices = stl_vertices(folder / part["mesh"]) * UNITS[part["unit"]]
    else:
        vertices = halfspace_vertices(np.array(part["normals"]), np.array(part["offsets"]))
    quaternion = np.array(part.get("orientation", [1.0, 0.0, 0.0, 0.0]))
    rotation = rotation_matrix(quaternion / np.linalg.norm(quaternion))
    return vertices @ rotation.T + np.array(part.get("position", [0.0, 0.0, 0.0]))


def halfspace_vertices(normals: np.ndarray, offsets: np.ndarray) -> np.ndarray:
    """Corners of the bounded polytope `normals x <= offsets`: every facet is cut out of its plane by the others."""
    scale = np.linalg.norm(normals, axis=1)
    normals, offsets = normals / scale[:, None], offsets / scale
    size = 1e3 * max(1.0, np.abs(offsets).max())
    corners = np.vstack([facet(index, normals, offsets, size) for index in range(len(offsets))])
    rounded = np.round(corners / MERGE_DISTANCE).astype(np.int64)
    return corners[np.unique(rounded, axis=0, return_index=True)[1]]


def facet(index: int, normals: np.ndarray, offsets: np.ndarray, size: float) -> np.ndarray:
    """Corners of one facet, which is empty (0 x 3) when its halfspace is redundant."""
    normal = normals[index]
    first = np.cross(normal, np.eye(3)[np.abs(normal).argmin()])
    first /= np.linalg.norm(first)
    second = np.cross(normal, first)
    square = [first + second, second - first, -first - second, first - second]
    polygon = offsets[index] * normal + size * np.array(square)
    for other in range(len(offsets)):
        # A plane that is given twice would cut everything off, by rounding.
        difference = np.append(normals[other] - normal, offsets[other] - offsets[index])
        if np.abs(difference).max() > 1e-9:
            polygon = clip(polygon, normals[other], offsets[other])
    return polygon


def clip(polygon: np.ndarray, normal: np.ndarray, offset: float) -> np.ndarray:
    """The part of a convex polygon (corners in order) where `normal x <= offset`."""
    heights = polygon @ normal - offset
    if (heights <= 0).all():
        return polygon
    kept = []
    for index in range(len(polygon)):
        below, above = heights[index - 1], heights[index]
        if (below <= 0) != (above <= 0):
            share = below / (below - above)
            kept.append((1 - share) * polygon[index - 1] + share * polygon[index])
        if above <= 0:
            kept.append(polygon[index])
    return np.array(kept).reshape(-1, 3)


def stl_vertices(path: pathlib.Path) -> np.ndarray:
    """All triangle corners of a binary or text STL file, in the file's unit."""
    content = path.read_bytes()
    header = 84
    count = int.from_bytes(content[80:header], "little")
    triangle = np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("attribute", "<u2")])
    # Text files start with "solid", but so do some binary ones; only the size tells.
    if len(content) == header + count * triangle.itemsize:
        corners = np.frombuffer(content, triangle, count, header)["corners"].reshape(-1, 3)
    else:
        corners = re.findall(r"^\s*vertex\s+(\S+)\s+(\S+)\s+(\S+)", content.decode(), re.MULTILINE)
    return np.unique(np.array(corners, dtype=float), axis=0)
