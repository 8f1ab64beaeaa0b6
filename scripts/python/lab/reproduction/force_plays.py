"""Plans of the clamps, played by a UR10e in force mode with offsets of the clamp in the gripper."""

import csv
import dataclasses

import numpy as np

from lab import tables
from lab.mujoco import plans, robots
from lab.mujoco.control import GraspError
from lab.mujoco.rollout import Outcome
from lab.reproduction import force_scenes, studies
from lab.validation.results import Tolerance
from lab.validation.rollouts import MUJOCO, PLANNED, Settings, play_all

TABLE = studies.RUNS / "force_mode/plays.csv"
ARM = studies.MATRICES / "ur10e.toml"
# Steps and rest (s).
SETTINGS = Settings(0.001, 1.0, MUJOCO)
# Directions of the offsets: one of those that are planned, and one outside of their hull.
DIRECTIONS = {"in distribution": (0.7071, 0.7071, 0.0), "out of distribution": (0.7071, -0.7071, 0.0)}
FRICTION = 0.1
# Smoothing of the paper's homotopy iterations.
TAUS = [0.0005 / 2**iteration for iteration in range(6)]
LAST = len(TAUS)


@dataclasses.dataclass(frozen=True)
class Play:
    """One motion: of which plan (clamp, start, delta-hat in m) and homotopy iteration, with which offset (m) and
    friction."""

    clamp: str
    start: str
    delta: float
    iteration: int
    direction: str
    magnitude: float
    friction: float

    def grasp_error(self) -> GraspError:
        """What is injected."""
        return GraspError(self.magnitude * np.array(DIRECTIONS[self.direction]), np.zeros(3))


@dataclasses.dataclass(frozen=True)
class Played:
    """What became of it: final errors (m, rad), largest mean force (N), whether it is a success."""

    position_error: float
    angle_error: float
    force: float
    success: bool


HEADER = [field.name for kind in (Play, Played) for field in dataclasses.fields(kind)]


def read() -> dict[Play, Played]:
    """All motions so far."""
    rows = tables.read(TABLE) if TABLE.exists() else []
    return {
        Play(
            row["clamp"],
            row["start"],
            float(row["delta"]),
            int(row["iteration"]),
            row["direction"],
            float(row["magnitude"]),
            float(row["friction"]),
        ): Played(
            float(row["position_error"]), float(row["angle_error"]), float(row["force"]), row["success"] == "True"
        )
        for row in rows
    }


def append(outcomes: dict[Play, Played]) -> None:
    """Adds motions to those so far."""
    is_new = not TABLE.exists()
    with TABLE.open("a", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerows([HEADER] if is_new else [])
        writer.writerows([*dataclasses.astuple(play), *dataclasses.astuple(done)] for play, done in outcomes.items())


def wanted(clamp: str, cell: studies.Cell, iteration: int) -> list[Play]:
    """The motions of one trajectory. Without an offset, all directions are the same."""
    return [
        Play(clamp, cell.start, cell.delta_m, iteration, direction, magnitude, FRICTION)
        for magnitude in force_scenes.DELTAS
        for direction in (DIRECTIONS if magnitude else list(DIRECTIONS)[:1])
    ]


def finished() -> list[tuple[str, studies.Cell]]:
    """The plans that there are, each with its clamp."""
    cells = [(clamp, cell) for clamp in force_scenes.CLAMPS for cell in studies.load(force_scenes.study(clamp))]
    return [(clamp, cell) for clamp, cell in cells if cell.is_finished]


def trajectories() -> list[tuple[str, studies.Cell, int]]:
    """What is played: first the last iteration of each plan, then the others of those with the largest delta-hat."""
    plans = finished()
    largest = [(clamp, cell) for clamp, cell in plans if cell.delta_m == max(force_scenes.DELTAS)]
    last = [(clamp, cell, LAST) for clamp, cell in plans]
    return last + [(clamp, cell, iteration) for clamp, cell in largest for iteration in range(LAST - 1, 0, -1)]


def run(jobs: int, is_quick: bool) -> None:
    """Plays what is planned and not played yet; only the first trajectory for a quick look."""
    known = read()
    for clamp, cell, iteration in trajectories()[: 1 if is_quick else None]:
        missing = [play for play in wanted(clamp, cell, iteration) if play not in known]
        if missing:
            append(play_trajectory(cell, iteration, missing, jobs))


def play_trajectory(cell: studies.Cell, iteration: int, plays: list[Play], jobs: int) -> dict[Play, Played]:
    """Plays one trajectory."""
    plan = plans.load(cell.folder, None)
    plan = dataclasses.replace(plan, reference=reference(cell, iteration), robot=robots.read(ARM))
    tolerance = Tolerance(plan.position_tolerance, plan.angle_tolerance)
    tasks = [(PLANNED, play.friction, play.grasp_error()) for play in plays]
    return {
        play: of_outcome(outcome, tolerance)
        for play, outcome in zip(plays, play_all(plan, SETTINGS, jobs, tasks), strict=True)
    }


def reference(cell: studies.Cell, iteration: int) -> plans.Reference:
    """The trajectory of the stage that has the smoothing of an iteration of the paper."""
    distances = [abs(stage["tau"] - TAUS[iteration - 1]) for stage in cell.stages]
    return plans.read_reference(cell.folder / f"stages/{1 + int(np.argmin(distances))}/reference.csv")


def of_outcome(outcome: Outcome, tolerance: Tolerance) -> Played:
    """What is kept of an outcome."""
    return Played(outcome.position_error, outcome.angle_error, outcome.force, tolerance.accepts(outcome))
