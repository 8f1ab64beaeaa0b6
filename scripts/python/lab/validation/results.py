"""Success tables."""

import dataclasses
import itertools
import math

import numpy as np

from lab import tables
from lab.mujoco.plans import Plan
from lab.mujoco.rollout import Outcome
from lab.validation.offsets import Cell

# Quantile of the normal distribution for intervals of 95 %.
QUANTILE = 1.96


@dataclasses.dataclass(frozen=True)
class Tolerance:
    """Largest final errors (m, rad) of a success."""

    position: float
    angle: float

    def holds(self, position_error: float, angle_error: float) -> bool:
        """Whether errors (m, rad) are those of a success."""
        return position_error <= self.position and angle_error <= self.angle

    def accepts(self, outcome: Outcome) -> bool:
        """Whether a motion ended at the goal; one with a warning of MuJoCo never did."""
        return not outcome.warned and self.holds(outcome.position_error, outcome.angle_error)


@dataclasses.dataclass(frozen=True)
class Column:
    """One motion at one friction: an outcome for every offset of every cell."""

    motion: str
    friction: float
    outcomes: list[list[Outcome]]

    def all_outcomes(self) -> list[Outcome]:
        """Those of all cells."""
        return list(itertools.chain.from_iterable(self.outcomes))


@dataclasses.dataclass(frozen=True)
class Result:
    """All that was played of one plan."""

    plan: Plan
    cells: list[Cell]
    columns: list[Column]


def wilson(successes: int, count: int) -> tuple[float, float]:
    """Wilson score interval (95 %) of a proportion."""
    share, square = successes / count, QUANTILE**2
    centre = share + square / (2 * count)
    spread = QUANTILE * math.sqrt(share * (1 - share) / count + square / (4 * count**2))
    scale = 1 + square / count
    return max(0.0, (centre - spread) / scale), min(1.0, (centre + spread) / scale)


def proportion(outcomes: list[Outcome], tolerance: Tolerance) -> str:
    """`17/20 (64-95 %)`."""
    if not outcomes:
        return "-"
    successes = sum(tolerance.accepts(outcome) for outcome in outcomes)
    low, high = wilson(successes, len(outcomes))
    return f"{successes}/{len(outcomes)} ({100 * low:.0f}-{100 * high:.0f} %)"


def heading(plan: Plan, columns: list[Column]) -> str:
    """Heading of a plan, and head of the table of its successes by magnitude of the offset."""
    head = ["offset", "longest, mm", *(f"{column.motion}, friction {column.friction:g}" for column in columns)]
    title = (
        f"### {plan.title}, start {plan.start_name}: delta-hat {1e3 * plan.delta:g} mm, {len(plan.offsets)} "
        f'scenarios, plan "{plan.status}"\n'
    )
    return "\n".join([title, tables.head(head)])


def success_row(cell: Cell, columns: list[Column], tolerance: Tolerance) -> str:
    """How often each motion ended at the goal with the offsets of a cell, the last that was played."""
    longest = 1e3 * np.linalg.norm(cell.offsets, axis=1).max()
    return tables.line(
        [cell.label, f"{longest:.1f}", *(proportion(column.outcomes[-1], tolerance) for column in columns)]
    )


def extremes(result: Result, tolerance: Tolerance, clearance: float) -> str:
    """The sum of all rows, extremes and remarks as Markdown."""
    columns = result.columns
    shares = (proportion(column.all_outcomes(), tolerance) for column in columns)
    return "\n".join([tables.line(["all", "", *shares]), "", extreme_table(columns), "", *remarks(columns, clearance)])


def extreme_table(columns: list[Column]) -> str:
    """Final errors, median and largest, deepest overlap and largest force."""
    head = ["all offsets", "final error, mm", "largest", "final angle, rad", "largest", "overlap, mm", "force, N"]
    rows = []
    for column in columns:
        outcomes = column.all_outcomes()
        positions = [1e3 * outcome.position_error for outcome in outcomes]
        angles = [outcome.angle_error for outcome in outcomes]
        rows.append(
            [
                f"{column.motion}, friction {column.friction:g}",
                *(f"{np.median(positions):.2f}", f"{max(positions):.2f}"),
                *(f"{np.median(angles):.4f}", f"{max(angles):.4f}"),
                f"{1e3 * max(outcome.overlap for outcome in outcomes):.3f}",
                f"{max(outcome.force for outcome in outcomes):.1f}",
            ]
        )
    return tables.markdown(head, rows)


def remarks(columns: list[Column], clearance: float) -> list[str]:
    """What makes the table doubtful."""
    outcomes = [outcome for column in columns for outcome in column.all_outcomes()]
    lines = [f"Clearance at the goal {1e3 * clearance:.3f} mm."]
    deeper = sum(outcome.overlap > max(clearance, 0.0) for outcome in outcomes)
    if deeper:
        lines.append(f"Warning: in {deeper} of {len(outcomes)} motions parts overlap by more than the clearance.")
    warned = sum(outcome.warned for outcome in outcomes)
    if warned:
        lines.append(f"Warning: MuJoCo warned in {warned} of {len(outcomes)} motions, counted as failures.")
    return lines


CSV_COLUMNS = [
    "folder",
    "scene",
    "start",
    "motion",
    "friction",
    "offset",
    "x_m",
    "y_m",
    "z_m",
    "position_error_m",
    "angle_error_rad",
    "overlap_m",
    "force_n",
    "warned",
    "success",
    "turn_x_rad",
    "turn_y_rad",
    "turn_z_rad",
]


def csv_rows(result: Result, tolerance: Tolerance) -> list[list[object]]:
    """One row per motion."""
    plan = result.plan
    return [
        [
            *(plan.folder, plan.title, plan.start_name, column.motion, column.friction, cell.label, *offset),
            *(outcome.position_error, outcome.angle_error, outcome.overlap, outcome.force),
            *(int(outcome.warned), int(tolerance.accepts(outcome)), *turn),
        ]
        for column in result.columns
        for cell, outcomes in zip(result.cells, column.outcomes)
        for offset, turn, outcome in zip(cell.offsets.tolist(), cell.turns.tolist(), outcomes)
    ]
