"""Errors of the part in the gripper under which a plan is played."""

import dataclasses
import pathlib

import numpy as np

from lab import tables
from lab.errors import InputError
from lab.mujoco.control import GraspError
from lab.mujoco.plans import Plan
from lab.validation.arguments import HULL_MAGNITUDES, ROUND_MAGNITUDES

# Unit of a magnitude that is a length and not a fraction.
MILLIMETRES = "mm"


@dataclasses.dataclass(frozen=True)
class Cell:
    """Offsets (n x 3, m, body frame), each with a turn (n x 3, rad), that are counted together."""

    label: str
    offsets: np.ndarray
    turns: np.ndarray

    def grasp_errors(self) -> list[GraspError]:
        """All of them."""
        return [GraspError(offset, turn) for offset, turn in zip(self.offsets, self.turns)]


# Which offsets may be played.
PLANNED, COVERED, HULL, DISC, BALL = SOURCES = ("planned", "random", "hull", "disc", "ball")


def cells(plan: Plan, source: str, magnitudes: str | None, count: int, seed: int) -> list[Cell]:
    """One cell per magnitude and group of offsets, or a single one from a file.

    `planned`: the offsets of the plan's scenarios, scaled to the magnitude.
    `random`: what the plan covers, one of the following.
    `hull`: convex combinations of the planned ones, weights uniform on the simplex.
    `disc`, `ball`: half of them, rounded up, as long as the magnitude, in directions that are all equally likely; the
    others uniform inside.

    Offsets are the same in every cell but for the magnitude. Turns are random rotation vectors, uniform in the ball of
    the plan's largest turn.
    """
    generator = np.random.default_rng(seed)
    if source not in SOURCES:
        path = pathlib.Path(source)
        offsets = read_offsets(path)
        return [distinct(path.name, offsets, ball(generator, len(offsets), plan.turn))]
    source = plan.coverage if source == COVERED else source
    groups = unit_offsets(generator, plan, source, count)
    turns = {name: ball(generator, len(offsets), plan.turn) for name, offsets in groups.items()}
    default = ROUND_MAGNITUDES if source in (DISC, BALL) else HULL_MAGNITUDES
    return [
        distinct(f"{label}{name}", magnitude * offsets, turns[name])
        for label, magnitude in parse_magnitudes(magnitudes or default, plan.delta)
        for name, offsets in groups.items()
    ]


def unit_offsets(generator: np.random.Generator, plan: Plan, source: str, count: int) -> dict[str, np.ndarray]:
    """Offsets in magnitudes, in groups that are counted together, by what their labels end with."""
    if source in (DISC, BALL):
        span = np.eye(3) if source == BALL else across(plan.insertion_axis)
        on_rim = (count + 1) // 2
        inside = round_points(generator, count - on_rim, len(span))
        rim = round_points(generator, on_rim, len(span))
        rim /= np.linalg.norm(rim, axis=1, keepdims=True)
        groups = {", inside": inside @ span, ", rim": rim @ span}
        return {name: offsets for name, offsets in groups.items() if len(offsets)}
    # Without magnitude there is nothing to scale, and nothing to divide by.
    planned = plan.offsets / plan.delta if plan.delta > 0 else 0 * plan.offsets
    if source == PLANNED:
        return {"": planned}
    return {"": generator.dirichlet(np.ones(len(planned)), count) @ planned}


def across(axis: np.ndarray) -> np.ndarray:
    """Two orthonormal vectors (rows) across an axis."""
    first = np.cross(axis, np.eye(3)[np.abs(axis).argmin()])
    first /= np.linalg.norm(first)
    second = np.cross(axis, first)
    return np.array([first, second / np.linalg.norm(second)])


def round_points(generator: np.random.Generator, count: int, dimension: int) -> np.ndarray:
    """Random points (count x dimension), uniform in the unit disc or ball."""
    directions = generator.normal(size=(count, dimension))
    lengths = generator.uniform(size=(count, 1)) ** (1 / dimension)
    return lengths * directions / np.linalg.norm(directions, axis=1, keepdims=True)


def ball(generator: np.random.Generator, count: int, radius: float) -> np.ndarray:
    """Random points (count x 3), uniform in a ball."""
    return radius * round_points(generator, count, 3)


def distinct(label: str, offsets: np.ndarray, turns: np.ndarray) -> Cell:
    """A cell without repetitions: the simulation is deterministic, so playing an error twice says nothing."""
    _, first = np.unique(np.hstack([offsets, turns]), axis=0, return_index=True)
    kept = np.sort(first)
    return Cell(label, offsets[kept], turns[kept])


def parse_magnitudes(text: str, delta: float) -> list[tuple[str, float]]:
    """Labels and magnitudes (m) of a list: fractions of delta-hat (0.5), lengths (2mm), delta-hat less a length (-1mm).
    Those below zero, when delta-hat is small, are left out."""
    parsed = []
    for entry in filter(None, text.split(",")):
        is_length = entry.endswith(MILLIMETRES)
        try:
            number = float(entry.removesuffix(MILLIMETRES))
        except ValueError as error:
            raise InputError(f"--magnitude: `{entry}` is neither a fraction nor a length in mm") from error
        if not is_length:
            parsed.append((f"{100 * number:g} %", number * delta))
        elif entry.startswith("-"):
            parsed.append((f"delta - {-number:g} mm", delta + 1e-3 * number))
        else:
            parsed.append((f"{number:g} mm", 1e-3 * number))
    possible = [(label, magnitude) for label, magnitude in parsed if magnitude >= 0]
    if not possible:
        raise InputError(f"--magnitude {text}: none is above zero with a delta-hat of {1e3 * delta:g} mm")
    return possible


def read_offsets(path: pathlib.Path) -> np.ndarray:
    """Offsets of a CSV file with the header `x_m,y_m,z_m`."""
    try:
        rows = [[float(row[column]) for column in ("x_m", "y_m", "z_m")] for row in tables.read(path)]
    except (OSError, KeyError, TypeError, ValueError) as error:
        raise InputError(f"--offsets {path}: no CSV file of numbers with the header x_m,y_m,z_m: {error}") from error
    if not rows:
        raise InputError(f"--offsets {path}: no offsets")
    return np.array(rows)
