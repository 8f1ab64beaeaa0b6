"""Predicts, plays and compares the boundaries of plans."""

import argparse
import csv
import dataclasses
import hashlib
import json
import pathlib
import sys
import tomllib

import numpy as np

from lab import program, tables
from lab.boundaries import search
from lab.boundaries.cases import Case, drawn, simulated
from lab.boundaries.search import Boundary
from lab.errors import InputError
from lab.mujoco import plans
from lab.mujoco.control import GraspError
from lab.mujoco.plans import Plan
from lab.validation.play import TIME_STEPS
from lab.validation.results import Tolerance
from lab.validation.rollouts import DRAKE, PLANNED, Rollouts, Settings

# Rest (s) before a motion is judged.
SETTLING = 1.0
HEAD = ["plan", "predicted, mm", "in `simulate`, mm", "in the engine, mm", "cases at the same, one apart, more"]
HEAD += ["motions", "agree", "within the interval"]
MOTION_COLUMNS = ["case", "level", "friction", "x_m", "y_m", "z_m", "success"]
MOTION_COLUMNS += ["position_error_m", "angle_error_rad", "overlap_m", "force_n"]


@dataclasses.dataclass(frozen=True)
class Measured:
    """What is known of a plan: the prediction, the offsets that were tried (m), both boundaries, how many levels apart
    every case is in the engine and in `simulate`, and how many motions the engine played."""

    known: dict
    levels: list[float]
    simulated: Boundary
    engine: Boundary
    apart: list[int]
    motions: int


def study(arguments: argparse.Namespace) -> str:
    """The table of all plans."""
    loaded = [required(plans.load(folder, None)) for folder in arguments.plans]
    rows = []
    for plan in loaded:
        rows.append(row(plan.folder.name, measured(arguments, plan)))
        print(tables.line(rows[-1]), file=sys.stderr)
    return tables.markdown(HEAD, rows)


def required(plan: Plan) -> Plan:
    """A plan whose only errors are offsets, and whose success depends on where it ends alone."""
    if plan.turn > 0:
        raise InputError(f"{plan.folder}: it is planned for rotation errors, which are left out here")
    limits = tomllib.loads((plan.folder / "resolved.toml").read_text()).get("limits", {})
    if "contact_force" in limits:
        raise InputError(f"{plan.folder}: it has a limit of contact force, which is left out here; plan without it")
    return plan


def measured(arguments: argparse.Namespace, plan: Plan) -> Measured:
    """Does what is missing of a plan."""
    out = arguments.out / plan.folder.name
    out.mkdir(parents=True, exist_ok=True)
    require_same(plan.folder, out)
    known = predicted(arguments, plan, out)
    levels = search.levels(known["boundaries"][0]["value"])
    cases = drawn(plan, known["frictions"], arguments.cases, arguments.seed)
    own = simulated(arguments, plan, known, cases, levels, out)
    engine = Engine(arguments, plan, Tolerance(known["position_tolerance_m"], known["angle_tolerance_rad"]), out)
    ours, theirs, motions = [], [], 0
    for index, case in enumerate(cases):
        played: dict[int, bool] = {}

        def passes(level: int, index: int = index, case: Case = case, played: dict[int, bool] = played) -> bool:
            played[level] = engine.succeeds(index, level, case.friction, levels[level] * case.offset)
            return played[level]

        ours.append(search.levels_passed(own[index].__getitem__, len(levels)))
        theirs.append(search.levels_passed(passes, len(levels)))
        motions += len(played)
    boundaries = [search.boundary(passed, len(levels), arguments.target_rate) for passed in (ours, theirs)]
    return Measured(known, levels, *boundaries, [abs(one - other) for one, other in zip(ours, theirs)], motions)


def require_same(folder: pathlib.Path, out: pathlib.Path) -> None:
    """Refuses results of another plan than that of the folder."""
    file, reference = out / "reference.sha256", hashlib.sha256((folder / "reference.csv").read_bytes()).hexdigest()
    if file.exists() and file.read_text() != reference:
        raise InputError(f"{out}: has results of another plan than {folder} has now; choose another folder with --out")
    file.write_text(reference)


def predicted(arguments: argparse.Namespace, plan: Plan, out: pathlib.Path) -> dict:
    """What `assembly-plan tolerance` says of the offset."""
    file = out / "tolerance.json"
    if not file.exists():
        asked = ["--quantity", "offset", "--no-map", "--target-rate", arguments.target_rate, "--jobs", arguments.jobs]
        command = ["tolerance", plan.folder / "resolved.toml", "--plan", plan.folder, *asked, "--out", out]
        program.measured(*command, log=out / "tolerance.log", program=arguments.program)
    known = json.loads(file.read_text())
    if known["rate"] != arguments.target_rate:
        raise InputError(f"{file} has a rate of {known['rate']:g}; choose another folder with --out")
    if known["boundaries"][0]["value"] is None:
        raise InputError(f"{plan.folder}: it tolerates no offset that `tolerance` tried")
    return known


class Engine:
    """Motions of a plan in an engine; those that are in its file are not played again."""

    def __init__(self, arguments: argparse.Namespace, plan: Plan, tolerance: Tolerance, out: pathlib.Path) -> None:
        time_step = arguments.time_step or TIME_STEPS[arguments.engine]
        stiffness = f"-{arguments.contact_stiffness:g}" if arguments.engine == DRAKE else ""
        self.file = out / f"{arguments.engine}-{time_step:g}{stiffness}-{arguments.seed}.csv"
        self.rollouts = Rollouts(plan, Settings(time_step, SETTLING, arguments.engine, arguments.contact_stiffness))
        self.tolerance = tolerance
        if not self.file.exists():
            tables.write(self.file, MOTION_COLUMNS, [])
        rows = tables.read(self.file)
        self.known = {(int(row["case"]), int(row["level"])): row["success"] == "1" for row in rows}

    def succeeds(self, case: int, level: int, friction: float, offset: np.ndarray) -> bool:
        """Whether a motion ends at its goal."""
        if (case, level) not in self.known:
            outcome = self.rollouts.play(PLANNED, friction, GraspError(offset, np.zeros(3)))
            success = self.tolerance.accepts(outcome)
            errors = [outcome.position_error, outcome.angle_error, outcome.overlap, outcome.force]
            with self.file.open("a", newline="") as file:
                csv.writer(file, lineterminator="\n").writerow(
                    [case, level, friction, *offset.tolist(), int(success), *errors]
                )
            self.known[case, level] = success
        return self.known[case, level]


def row(name: str, found: Measured) -> list[object]:
    """The row of a plan."""
    prediction = found.known["boundaries"][0]
    step = search.margin(prediction["value"]) / 2
    inside = "-"
    if None not in (found.engine.at, found.simulated.at):
        shifted = prediction["value"] + (found.engine.at - found.simulated.at) * step
        inside = yes(is_within(shifted, prediction["interval"]))
    return [
        name,
        f"{millimetres(prediction['value'])} ({between(prediction['interval'])})",
        in_words(found.simulated, found.levels),
        in_words(found.engine, found.levels),
        f"{found.apart.count(0)}, {found.apart.count(1)}, {sum(levels > 1 for levels in found.apart)}",
        found.motions,
        yes(search.agree(found.simulated, found.engine)),
        inside,
    ]


def is_within(value: float, interval: list[float | None]) -> bool:
    """Whether a value is in an interval, whose ends may be unknown; rounding does not count."""
    low, high = interval
    return (low is None or value >= low - 1e-9) and (high is None or value <= high + 1e-9)


def in_words(found: Boundary, levels: list[float]) -> str:
    """A boundary with its interval (mm)."""
    value, *interval = (None if level is None else levels[level] for level in dataclasses.astuple(found))
    return f"{'-' if value is None else millimetres(value)} ({between(interval)})"


def between(interval: list[float | None]) -> str:
    """An interval (mm)."""
    low, high = interval
    if high is None:
        return "unknown" if low is None else f"at least {millimetres(low)}"
    return f"{'0' if low is None else millimetres(low)} to {millimetres(high)}"


def millimetres(length: float) -> str:
    """A length (m) in mm."""
    return f"{1e3 * length:.2f}"


def yes(truth: bool) -> str:
    """A word for it."""
    return "yes" if truth else "no"
