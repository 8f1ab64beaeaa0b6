"""What users give, checked and as the native module takes it."""

from __future__ import annotations

import json
import os
from collections.abc import Iterable, Mapping, Sequence
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import ArrayLike

from assembly_plan._arrays import numbers, table
from assembly_plan._types import ChoiceOptions
from assembly_plan.errors import SceneError

StrPath: TypeAlias = str | os.PathLike[str]
"""The name of a file or folder."""

Homotopy: TypeAlias = StrPath | Mapping[str, Any]
"""A homotopy file, or a dictionary with its keys."""


def choices(
    *,
    start: str | int | None,
    delta: float | None,
    homotopy: Homotopy | None,
    linear_solver: str | None = None,
    position_tolerance: float | None = None,
    angle_tolerance: float | None = None,
    rotation_error: float | None = None,
) -> ChoiceOptions:
    """What is chosen of a scene, as the native module takes it."""
    file, content = (homotopy, None) if isinstance(homotopy, str | os.PathLike) else (None, homotopy)
    return {
        "start": None if start is None else str(start),
        "delta": optional(delta, "delta"),
        "rotation_error": optional(rotation_error, "rotation_error"),
        "homotopy": file,
        "homotopy_json": None if content is None else json_of(content),
        "linear_solver": linear_solver,
        "position_tolerance": optional(position_tolerance, "position_tolerance"),
        "angle_tolerance": optional(angle_tolerance, "angle_tolerance"),
    }


def number(value: object, name: str) -> float:
    """A number; `name` is what the caller calls it."""
    if isinstance(value, bool) or not isinstance(value, int | float | np.integer | np.floating):
        raise SceneError(f"{name} = {value!r}: must be a number, is of type {type(value).__name__}")
    return float(value)


def optional(value: object, name: str) -> float | None:
    """A number, or None."""
    return None if value is None else number(value, name)


def whole(value: object, name: str, most: int = 2**63 - 1) -> int:
    """A whole number from 0."""
    if isinstance(value, bool) or not isinstance(value, int | np.integer):
        raise SceneError(f"{name} = {value!r}: must be a whole number, is of type {type(value).__name__}")
    if not 0 <= value <= most:
        raise SceneError(f"{name} = {value}: must lie between 0 and {most}")
    return int(value)


def threads(value: object) -> int | None:
    """The number of threads, or None."""
    if value is not None and whole(value, "jobs") == 0:
        raise SceneError("jobs = 0: must be at least 1, or None for one per processor")
    return None if value is None else whole(value, "jobs")


def several(values: float | Iterable[float], name: str) -> list[float]:
    """A list of numbers, also of one that stands alone."""
    listed: Iterable[Any] = values if isinstance(values, Iterable) and not isinstance(values, str) else [values]
    return [number(value, name) for value in listed]


def vector(values: ArrayLike, count: int, name: str) -> list[float]:
    """A list of this many numbers."""
    array = numbers(values, name)
    if array.shape != (count,):
        raise SceneError(f"{name}: has shape {array.shape}, must have shape ({count},)")
    return [float(value) for value in array]


def vectors(values: ArrayLike, name: str) -> list[list[float]]:
    """Rows of three numbers."""
    return [[float(value) for value in row] for row in table(values, 3, name)]


def grasps(offsets: ArrayLike | None, rotations: ArrayLike | None) -> list[tuple[list[float], list[float]]] | None:
    """Offsets and rotation vectors of the part in the gripper, if any are given."""
    if offsets is None and rotations is None:
        return None
    moved = None if offsets is None else vectors(offsets, "offsets")
    turned = None if rotations is None else vectors(rotations, "rotations")
    moved = moved or [[0.0] * 3] * len(turned or [])
    turned = turned or [[0.0] * 3] * len(moved)
    if len(moved) != len(turned):
        raise SceneError(f"rotations: has {len(turned)} rows, offsets {len(moved)}; both need as many")
    return list(zip(moved, turned, strict=True))


def json_of(content: Any) -> str:
    """The JSON text of a dictionary with the keys of a TOML file."""
    if not isinstance(content, Mapping):
        raise SceneError(f"a {type(content).__name__} is no dictionary with the keys of a file")
    return json.dumps(_plain(content, ""))


def _plain(value: Any, path: str) -> Any:
    """A value as a file has it; `path` names its key in messages."""
    match value:
        case bool() | str():
            return value
        case Mapping():
            return {_key(key, path): _plain(entry, f"{path}.{key}".lstrip(".")) for key, entry in value.items()}
        case os.PathLike():
            return os.fspath(value)
        case np.ndarray() | np.generic():
            return _plain(value.tolist(), path)
        case int() | float():
            if value != value or value in (float("inf"), float("-inf")):
                raise SceneError(f"{path}: {value} must be a finite number")
            return value
        case Sequence():
            return [_plain(entry, f"{path}[{index}]") for index, entry in enumerate(value)]
        case None:
            raise SceneError(f"{path}: None is no value; leave the key out")
        case _:
            kind = type(value).__name__
            raise SceneError(f"{path}: a {kind} is no value of a file; use numbers, text, lists or dictionaries")


def _key(key: Any, path: str) -> str:
    if not isinstance(key, str):
        raise SceneError(f"{path or 'the dictionary'}: the key {key!r} is no text")
    return key
