"""Motions of plans in MuJoCo, every 20 ms."""

import pathlib

from lab import tables
from lab.mujoco import plans
from lab.validation import offsets
from lab.validation.rollouts import MUJOCO, Rollouts, Settings

# Plan and friction.
MOTIONS = (("free_motion", "0"), ("sliding", "0"), ("sliding", "0.3"), ("sticking", "0.3"))
TIME_STEP, SETTLING_TIME = 0.0005, 1.0
# Steps between two rows.
STRIDE = 40


def write(folder: pathlib.Path) -> None:
    """Plays the plans in a folder and writes a table beside each."""
    for name, friction in MOTIONS:
        plan = plans.load(folder / name, None)
        grasp_error = offsets.cells(plan, offsets.PLANNED, "1", 1, 1)[0].grasp_errors()[0]
        rows = Rollouts(plan, Settings(TIME_STEP, SETTLING_TIME, MUJOCO)).trace(float(friction), grasp_error)
        # Nine digits are more than two simulators share.
        shown = ([f"{number:.9g}" for number in row] for row in rows[::STRIDE])
        tables.write(folder / name / f"friction_{friction}.csv", [plans.TIME_COLUMN, *plans.STATE_COLUMNS], shown)
