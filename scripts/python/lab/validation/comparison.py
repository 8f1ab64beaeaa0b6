"""The same motions in MuJoCo and in our own simulator."""

import dataclasses
import pathlib
import statistics

import numpy as np

from lab import tables
from lab.errors import InputError
from lab.mujoco.control import GraspError
from lab.mujoco.plans import Plan
from lab.mujoco.rollout import Outcome
from lab.validation.results import Tolerance


@dataclasses.dataclass(frozen=True)
class Rollout:
    """A motion that `assembly-plan simulate` played, success, final errors (m, rad) and largest contact force (N)."""

    motion: str
    friction: float
    grasp_error: GraspError
    success: bool
    position_error: float
    angle_error: float
    force: float


def read(path: pathlib.Path, plan: Plan) -> list[Rollout]:
    """The rows of one plan in a `rollouts.csv` of `assembly-plan simulate`."""
    name = plan.folder.resolve().name
    try:
        # Folders are known by name, so that they may be written from one place and read from another.
        rows = [rollout(row) for row in tables.read(path) if pathlib.Path(row["plan"]).resolve().name == name]
    except (OSError, KeyError, TypeError, ValueError) as error:
        raise InputError(f"--compare {path}: no rollouts.csv of `assembly-plan simulate`: {error}") from error
    if not rows:
        raise InputError(f"--compare {path}: no rollouts of a plan in a folder called {name}")
    return rows


def rollout(row: tables.Row) -> Rollout:
    """One row of the file."""
    offset = np.array([float(row[column]) for column in ("x_m", "y_m", "z_m")])
    turn = np.array([float(row[column]) for column in ("turn_x_rad", "turn_y_rad", "turn_z_rad")])
    return Rollout(
        motion=row["motion"],
        friction=float(row["friction"]),
        grasp_error=GraspError(offset, turn),
        success=row["success"] == "1",
        position_error=float(row["position_error_m"]),
        angle_error=float(row["orientation_error_rad"]),
        force=float(row["max_force_n"]),
    )


def table(theirs: list[Rollout], ours: list[Outcome], tolerance: Tolerance) -> str:
    """How often the simulators agree, how far apart the final errors are where both succeed, and medians of the largest
    forces there."""
    rows = []
    for motion, friction in dict.fromkeys((rollout.motion, rollout.friction) for rollout in theirs):
        pairs = [pair for pair in zip(theirs, ours) if (pair[0].motion, pair[0].friction) == (motion, friction)]
        verdicts = [
            (tolerance.holds(other.position_error, other.angle_error), tolerance.accepts(outcome))
            for other, outcome in pairs
        ]
        both = [pair for pair, verdict in zip(pairs, verdicts) if all(verdict)]
        positions = [1e3 * abs(other.position_error - outcome.position_error) for other, outcome in both]
        angles = [abs(other.angle_error - outcome.angle_error) for other, outcome in both]
        rows.append(
            [
                f"{motion}, friction {friction:g}",
                *(str(verdicts.count(verdict)) for verdict in ((True, True), (False, False))),
                *(str(verdicts.count(verdict)) for verdict in ((False, True), (True, False))),
                f"{max(positions):.2f}" if both else "-",
                f"{max(angles):.4f}" if both else "-",
                *(f"{statistics.median(pair[side].force for pair in both):.1f}" if both else "-" for side in (0, 1)),
            ]
        )
    head = ["motion", "succeeds in both", "fails in both", "only in MuJoCo", "only in ours"]
    return tables.markdown([*head, "errors differ by, mm", "rad", "force in ours, N", "in MuJoCo"], rows)
