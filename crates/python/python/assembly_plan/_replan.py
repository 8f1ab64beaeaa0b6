"""Scenes in which something was measured again."""

from __future__ import annotations

import tomllib
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from assembly_plan import _values
from assembly_plan._arrays import FloatArray


def measured_again(
    resolved: str, start: ArrayLike | None, goal: ArrayLike | None, offset_magnitude: float | None
) -> dict[str, Any]:
    """The keys of a resolved scene with another start, goal or offset magnitude; the environment moves along."""
    content = tomllib.loads(resolved)
    if start is not None:
        content["start"][0] |= _pose(start, "start")
    if goal is not None:
        before, now = content["goal"], _pose(goal, "goal")
        rotation = _product(np.array(now["orientation"]), _inverse(np.array(before["orientation"])))
        shift = np.array(now["position"]) - _rotated(rotation, np.array(before["position"]))
        content["goal"] = before | now
        # The parts of a resolved scene are in the world frame.
        for part in content["environment"]["part"]:
            part |= {"position": shift.tolist(), "orientation": rotation.tolist()}
    if offset_magnitude is not None:
        content["robustness"]["offset_magnitude"] = _values.number(offset_magnitude, "offset_magnitude")
    return content


def _pose(values: ArrayLike, name: str) -> dict[str, list[float]]:
    given = _values.vector(values, 7, name)
    return {"position": given[:3], "orientation": given[3:]}


def _product(one: FloatArray, other: FloatArray) -> FloatArray:
    """The product of two quaternions ``w x y z``."""
    (w, v), (s, u) = (one[0], one[1:]), (other[0], other[1:])
    return np.concatenate([[w * s - v @ u], w * u + s * v + np.cross(v, u)])


def _inverse(quaternion: FloatArray) -> FloatArray:
    return quaternion * [1.0, -1.0, -1.0, -1.0]


def _rotated(quaternion: FloatArray, vector: FloatArray) -> FloatArray:
    return _product(_product(quaternion, np.concatenate([[0.0], vector])), _inverse(quaternion))[1:]
