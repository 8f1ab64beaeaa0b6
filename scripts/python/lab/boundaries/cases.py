"""Random offsets, each of which is scaled to several magnitudes, and what the program's own simulator makes of them."""

import argparse
import dataclasses
import pathlib
import subprocess
from collections.abc import Sequence

import numpy as np

from lab import tables
from lab.errors import Failure
from lab.mujoco.plans import Plan
from lab.validation import comparison, offsets
from lab.validation.rollouts import PLANNED


@dataclasses.dataclass(frozen=True)
class Case:
    """An offset in magnitudes (body frame), and the friction with which it is played."""

    offset: np.ndarray
    friction: float


def drawn(plan: Plan, frictions: Sequence[float], count: int, seed: int) -> list[Case]:
    """Offsets of what the plan covers, inside and on the rim in turn. More cases begin with the same ones."""
    return [Case(unit_offset(plan, index, seed), frictions[index % len(frictions)]) for index in range(count)]


def unit_offset(plan: Plan, index: int, seed: int) -> np.ndarray:
    """The offset of a case."""
    groups = offsets.unit_offsets(np.random.default_rng([seed, index]), plan, plan.coverage, 2)
    return list(groups.values())[index % len(groups)][0]


def simulated(
    arguments: argparse.Namespace, plan: Plan, known: dict, cases: list[Case], levels: list[float], out: pathlib.Path
) -> list[list[bool]]:
    """Whether each case succeeds at each level in `assembly-plan simulate`."""
    outcomes: dict[int, list[bool]] = {}
    for friction in dict.fromkeys(case.friction for case in cases):
        own = [index for index, case in enumerate(cases) if case.friction == friction]
        errors = np.array([level * cases[index].offset for index in own for level in levels])
        tables.write(out / "offsets.csv", ("x_m", "y_m", "z_m"), errors.tolist())
        tolerances = ["--position-tolerance", known["position_tolerance_m"]]
        tolerances += ["--angle-tolerance", known["angle_tolerance_rad"]]
        command = [arguments.program, "simulate", plan.folder, "--offsets", out / "offsets.csv", *tolerances]
        command += ["--friction", friction, "--jobs", arguments.jobs, "--out", out / "simulated", "--quiet"]
        subprocess.run(list(map(str, command)), check=True, stdout=subprocess.DEVNULL)
        rows = [row for row in comparison.read(out / "simulated/rollouts.csv", plan) if row.motion == PLANNED]
        played = np.array([row.grasp_error.offset for row in rows])
        if played.shape != errors.shape or np.abs(played - errors).max() > 1e-9:
            raise Failure(f"{out}/simulated/rollouts.csv: other offsets than those of {out}/offsets.csv")
        for place, index in enumerate(own):
            of_case = rows[place * len(levels) : (place + 1) * len(levels)]
            outcomes[index] = [row.success for row in of_case]
    return [outcomes[index] for index in range(len(cases))]
