"""The arm that executes a plan: the [robot] table of a scene."""

import dataclasses
import pathlib
import tomllib
from typing import Any

import numpy as np

IDENTITY = [1.0, 0.0, 0.0, 0.0]


@dataclasses.dataclass(frozen=True)
class Robot:
    """An arm and its controller. Frames are position (m) and unit quaternion (w x y z): `grasp` is the part's in that
    of the link `tip`, `base` the root link's in the world. Per joint from base to tip: `configuration` (rad) near the
    goal, `rotor_inertia` (kg m^2) and `joint_friction` (Nm). Torques are computed every `control_period` (s), held, and
    applied after `delay` (s)."""

    urdf: pathlib.Path
    tip: str
    grasp: np.ndarray
    base: np.ndarray
    configuration: np.ndarray
    rotor_inertia: np.ndarray
    joint_friction: np.ndarray
    control_period: float
    delay: float = 0.0


def read(path: pathlib.Path) -> Robot:
    """The robot of a TOML file; its URDF is relative to the file. ValueError says what is wrong."""
    table = tomllib.loads(path.read_text()).get("robot", {})
    missing = [key for key in ("urdf", "tip", "configuration") if key not in table]
    if missing:
        raise ValueError(
            f"[robot] lacks {', '.join(missing)}: there is no arm to play; --robot takes one from another file"
        )
    for key, kind in (("urdf", str), ("tip", str), ("grasp", dict), ("base", dict)):
        if not isinstance(table.get(key, kind()), kind):
            raise ValueError(f"[robot] {key} is not a {'table' if kind is dict else 'string'}")
    configuration = per_joint(table, "configuration", None)
    robot = Robot(
        urdf=path.parent / table["urdf"],
        tip=table["tip"],
        grasp=frame(table, "grasp"),
        base=frame(table, "base"),
        configuration=configuration,
        rotor_inertia=not_negative(per_joint(table, "rotor_inertia", len(configuration)), "rotor_inertia"),
        joint_friction=not_negative(per_joint(table, "joint_friction", len(configuration)), "joint_friction"),
        control_period=numbers([table.get("control_period", 0.002)], "control_period", 1)[0],
    )
    if robot.control_period <= 0:
        raise ValueError(f"[robot] control_period = {robot.control_period:g} is not above zero")
    return robot


def frame(table: dict[str, Any], key: str) -> np.ndarray:
    """Position and unit quaternion of a sub-table, the identity where it is left out."""
    pose = table.get(key, {})
    position = numbers(pose.get("position", [0.0, 0.0, 0.0]), f"{key}.position", 3)
    quaternion = numbers(pose.get("orientation", IDENTITY), f"{key}.orientation", 4)
    norm = np.linalg.norm(quaternion)
    if norm == 0:
        raise ValueError(f"[robot] {key}.orientation must not be zero")
    return np.concatenate([position, quaternion / norm])


def per_joint(table: dict[str, Any], key: str, count: int | None) -> np.ndarray:
    """One number per joint; a single one counts for all, none is zero."""
    value = table.get(key, 0.0)
    return numbers([value] * count if count and not isinstance(value, list) else value, key, count)


def numbers(values: Any, key: str, count: int | None) -> np.ndarray:
    """A list of finite numbers, of a length unless that is None."""
    try:
        array = np.array(values, dtype=float)
    except (TypeError, ValueError):
        array = np.array(np.nan)
    if array.ndim != 1 or not np.isfinite(array).all():
        raise ValueError(f"[robot] {key} is not made of finite numbers")
    if count is not None and len(array) != count:
        raise ValueError(f"[robot] {key} has {len(array)} numbers; {count} are needed")
    return array


def not_negative(values: np.ndarray, key: str) -> np.ndarray:
    """The numbers, none of which may be below zero."""
    if (values < 0).any():
        raise ValueError(f"[robot] {key} must not be negative")
    return values
