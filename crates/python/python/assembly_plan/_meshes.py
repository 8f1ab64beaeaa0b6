"""Meshes that are given as arrays."""

from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np

from assembly_plan._arrays import table
from assembly_plan.errors import SceneError


def with_files(content: Mapping[str, Any], folder: Path) -> Mapping[str, Any]:
    """The content of a scene in which files in a folder stand for meshes of arrays; those files are written."""
    changed: dict[str, Any] = dict(content)
    for name in ("body", "environment", "gripper"):
        side = content.get(name)
        parts = side.get("part") if isinstance(side, Mapping) else None
        if isinstance(side, Mapping) and isinstance(parts, list | tuple):
            changed[name] = {
                **side,
                "part": [_with_file(part, folder / f"{name}.part[{index}].obj") for index, part in enumerate(parts)],
            }
    return changed


def _with_file(part: Any, file: Path) -> Any:
    mesh = part.get("mesh") if isinstance(part, Mapping) else None
    if not isinstance(mesh, Mapping):
        return part
    where = f"{file.stem}.mesh"
    if set(mesh) != {"vertices", "faces"}:
        raise SceneError(f"{where}: needs the keys vertices and faces, has {', '.join(map(str, mesh)) or 'none'}")
    vertices = table(mesh["vertices"], 3, f"{where}.vertices")
    faces = np.asarray(mesh["faces"])
    if faces.ndim != 2 or faces.shape[1] != 3 or faces.dtype.kind not in "iu" or len(faces) == 0:
        raise SceneError(f"{where}.faces: must be whole numbers of shape (F, 3), has shape {faces.shape}")
    if faces.min() < 0 or faces.max() >= len(vertices):
        raise SceneError(f"{where}.faces: must be indices of the {len(vertices)} vertices, counted from 0")
    lines = [f"v {x!r} {y!r} {z!r}" for x, y, z in vertices.tolist()]
    lines += [f"f {i + 1} {j + 1} {k + 1}" for i, j, k in faces.tolist()]
    file.write_text("\n".join(lines) + "\n", encoding="ascii")
    return {"unit": "m", **part, "mesh": str(file)}
