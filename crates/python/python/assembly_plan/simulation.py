"""Rollouts of plans."""

from __future__ import annotations

import csv
import io
import os
from typing import Any

import numpy as np
from numpy.typing import NDArray

from assembly_plan import _planner

_WORDS = ("plan", "start", "motion")


class Simulation:
    """Rollouts of a plan with hard contacts, beside an unplanned straight push.

    `Scene.simulate` returns it; ``print`` shows the table of the command ``simulate``.
    """

    def __init__(self, native: _planner.Simulation) -> None:
        """Not to be called."""
        self._native = native
        self._rollouts = _columns(native.rollouts())
        self._successes = _columns(native.successes())

    @property
    def rollouts(self) -> dict[str, NDArray[Any]]:
        """One entry per rollout in every column, as in ``rollouts.csv``; ``pandas.DataFrame`` takes it.

        Text: ``plan`` (folder of a stored plan), ``start``, ``motion`` (``plan``, ``straight push``, ``stage 1`` ...).
        Numbers: ``delta_m``, ``friction``, ``magnitude_m``, the offset ``x_m``, ``y_m``, ``z_m`` and the rotation error
        ``turn_x_rad``, ``turn_y_rad``, ``turn_z_rad`` in the body frame, ``success`` (1 or 0), ``position_error_m``,
        ``orientation_error_rad``, ``max_penetration_m``, ``max_force_n``.
        """
        return dict(self._rollouts)

    @property
    def successes(self) -> dict[str, NDArray[Any]]:
        """One entry per motion, friction and magnitude in every column, as in ``success.csv``.

        ``motion``, ``friction``, ``delta_m``, ``magnitude_m``, ``rollouts``, ``successes``, ``rate`` with Wilson's 95 %
        interval ``rate_low`` to ``rate_high``, and the largest ``largest_position_error_m``,
        ``largest_orientation_error_rad``, ``max_penetration_m``, ``max_force_n``.
        """
        return dict(self._successes)

    def rate(self, motion: str = "plan") -> float:
        """Fraction of the rollouts of a motion that succeed: of ``plan``, ``straight push``, ``stage 1`` ..."""
        played = self._rollouts["motion"] == motion
        if not played.any():
            known = ", ".join(dict.fromkeys(self._rollouts["motion"].tolist()))
            raise ValueError(f"motion = {motion!r}: was not played; choose one of {known}")
        return float(self._rollouts["success"][played].mean())

    def save(self, folder: str | os.PathLike[str]) -> None:
        """Write ``rollouts.csv``, ``success.csv`` and ``simulation.json`` into a folder, in the place of older ones.

        Raises `SceneError` where something else stands there.
        """
        self._native.save(folder)

    def __str__(self) -> str:
        return self._native.table()

    def __repr__(self) -> str:
        return f"<Simulation: {len(self._rollouts['success'])} rollouts>"


def _columns(text: str) -> dict[str, NDArray[Any]]:
    """Columns of a table: numbers but for those of words."""
    header, *rows = csv.reader(io.StringIO(text))
    columns = zip(*rows, strict=True)
    return {
        name: np.array(column) if name in _WORDS else np.array(column, dtype=np.float64)
        for name, column in zip(header, columns, strict=True)
    }
