"""Plans and their motions."""

from __future__ import annotations

import html
import json
import os
import shutil
import tempfile
import weakref
from dataclasses import dataclass
from pathlib import Path
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import NDArray

from assembly_plan import _planner
from assembly_plan._types import MotionData

FloatArray: TypeAlias = NDArray[np.float64]
"""An array of floats."""

_STATE = 13
_TWIST = 6


@dataclass(frozen=True, eq=False, repr=False)
class Motion:
    """One reference motion and what the body does in each of S scenarios, in N steps. The arrays are read-only.

    A state has 13 numbers: position (m, world frame), unit quaternion ``w x y z``, velocity (m/s, world frame) and
    angular velocity (rad/s, body frame).
    """

    time: FloatArray
    """Times of the N + 1 knots (s), shape (N + 1,)."""
    reference: FloatArray
    """The motion to track: states at the knots, shape (N + 1, 13)."""
    states: FloatArray
    """States of the body in every scenario, shape (S, N + 1, 13)."""
    wrenches: FloatArray
    """The controller's wrench at the knots after the first, shape (S, N, 6).

    Force (N, world frame), torque (Nm, body frame).
    """
    pairs: tuple[str, ...]
    """The P pairs of parts that may touch, ``BODY PART/ENVIRONMENT PART``."""
    distances: FloatArray
    """Smoothed distance of every pair (m) at the knots after the first, shape (S, N, P).

    NaN where it could not be computed.
    """
    forces: FloatArray
    """Contact force of every pair (N) at the knots after the first, shape (S, N, P)."""

    @property
    def time_step(self) -> float:
        """Time between two knots (s)."""
        return float(self.time[1] - self.time[0])

    def __repr__(self) -> str:
        scenarios, knots = self.states.shape[:2]
        return f"<{type(self).__name__}: {knots - 1} steps of {self.time_step:g} s, {scenarios} scenarios>"


def _arrays(native: MotionData) -> dict[str, Any]:
    """The fields of a motion."""
    steps, scenarios, pairs = native["steps"], native["scenarios"], tuple(native["pairs"])

    def array(numbers: bytes, *shape: int) -> FloatArray:
        return np.frombuffer(numbers, dtype=np.float64).reshape(shape)

    time = native["time_step"] * np.arange(steps + 1)
    time.flags.writeable = False
    return {
        "time": time,
        "reference": array(native["reference"], steps + 1, _STATE),
        "states": array(native["states"], scenarios, steps + 1, _STATE),
        "wrenches": array(native["wrenches"], scenarios, steps, _TWIST),
        "pairs": pairs,
        "distances": array(native["distances"], scenarios, steps, len(pairs)),
        "forces": array(native["forces"], scenarios, steps, len(pairs)),
    }


class Plan(Motion):
    """A plan: its motion, and what is known of it.

    `Scene.solve` and `Plan.load` return plans. One that does not reach the goal is a plan too: see `status` and `done`.
    Of a robust plan, the scenarios are rollouts with hard contacts.
    """

    _native: _planner.Plan

    def __init__(self, native: _planner.Plan) -> None:
        """Not to be called."""
        super().__init__(**_arrays(native.motion()))
        object.__setattr__(self, "_native", native)

    @classmethod
    def load(cls, folder: str | os.PathLike[str]) -> Plan:
        """Read the plan in a folder that `Plan.save` or the command ``solve`` has written.

        Raises `SceneError` where there is none, or where a file of it was changed.
        """
        return cls(_planner.Plan.load(folder))

    def save(self, folder: str | os.PathLike[str]) -> None:
        """Write the plan's files into a folder, as the command ``solve --out`` does; all other commands read them.

        An older plan in it is replaced once the new one is whole. Raises `SceneError` where the folder holds a file
        that the plan would replace and that no earlier run has written.
        """
        self._native.save(folder)

    @property
    def result(self) -> dict[str, Any]:
        """Everything that is known of the plan besides its motions: the content of ``result.json``.

        Keys name their units. ``files`` is empty before the plan is saved.
        """
        result: dict[str, Any] = json.loads(self._native.result())
        return result

    @property
    def status(self) -> str:
        """What has become of the plan, in words."""
        return str(self.result["status"])

    @property
    def done(self) -> bool:
        """Whether it is a robust plan that has passed its rollouts (exit code 0 of ``solve --robust``)."""
        return bool(self.result["done"])

    @property
    def planned(self) -> bool:
        """Whether it is the plan of a solver that reaches the goal in its smoothed model (exit code 0 of ``solve``).

        ``result["tested"]`` says how it does in rollouts with hard contact.
        """
        return bool(self.result["planned"])

    @property
    def resolved(self) -> str:
        """Scene and settings after defaults and choices, as TOML: the content of ``resolved.toml``."""
        return self._native.resolved()

    @property
    def offsets(self) -> FloatArray:
        """Offset of the part in the gripper in every scenario (m, body frame), shape (S, 3)."""
        return self._grasps("offset_m")

    @property
    def turns(self) -> FloatArray:
        """Turn of the part in the gripper in every scenario (rotation vector, rad), shape (S, 3)."""
        return self._grasps("turn_rad")

    @property
    def stages(self) -> list[Motion]:
        """The motion after every homotopy step."""
        return [Motion(**_arrays(native)) for native in self._native.stages()]

    def report(self, file: str | os.PathLike[str]) -> None:
        """Write the HTML page that shows the plan, as the command ``report`` does; it needs no other file."""
        with tempfile.TemporaryDirectory() as folder:
            self.save(Path(folder) / "plan")
            _planner.write_page(Path(folder) / "plan", file)

    def _repr_html_(self) -> str:
        """The page of the plan, in a notebook."""
        with tempfile.TemporaryDirectory() as folder:
            file = Path(folder) / "report.html"
            self.report(file)
            page = html.escape(file.read_text(encoding="utf-8"))
        return f'<iframe srcdoc="{page}" width="100%" height="720" style="border: 0"></iframe>'

    def plot(self, axes: Any = None) -> Any:
        """Plot positions of reference and body over time with Matplotlib, which has to be installed.

        Returns the axes: three, for x, y and z (mm). `axes` are three to draw into.
        """
        import matplotlib.pyplot

        if axes is None:
            _, axes = matplotlib.pyplot.subplots(3, sharex=True)
        for axis, name in enumerate("xyz"):
            axes[axis].plot(self.time, 1e3 * self.reference[:, axis], "k--", label="reference")
            for number, states in enumerate(self.states, start=1):
                axes[axis].plot(self.time, 1e3 * states[:, axis], label=f"scenario {number}")
            axes[axis].set_ylabel(f"{name} (mm)")
        axes[-1].set_xlabel("time (s)")
        axes[0].legend(loc="best")
        return axes

    def __reduce__(self) -> tuple[Any, ...]:
        with tempfile.TemporaryDirectory() as folder:
            self.save(Path(folder) / "plan")
            root = Path(folder) / "plan"
            files = {str(file.relative_to(root)): file.read_bytes() for file in root.rglob("*") if file.is_file()}
        return _plan_of, (files,)

    def __copy__(self) -> Plan:
        return self

    def __deepcopy__(self, memo: dict[int, Any]) -> Plan:
        return self

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Plan):
            return NotImplemented
        return self.resolved == other.resolved and bool(np.array_equal(self.reference, other.reference))

    def __hash__(self) -> int:
        return hash((self.resolved, self.reference.tobytes()))

    def __repr__(self) -> str:
        return f"{super().__repr__()[:-1]}, {self.status}>"

    def _grasps(self, key: str) -> FloatArray:
        return np.array([scenario.get(key, [0.0] * 3) for scenario in self.result["scenarios"]])


def _plan_of(files: dict[str, bytes]) -> Plan:
    """The plan with these files, which stay in a folder of their own as long as it lives."""
    folder = Path(tempfile.mkdtemp(prefix="assembly-plan-"))
    for name, content in files.items():
        file = folder / "plan" / name
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_bytes(content)
    plan = Plan.load(folder / "plan")
    weakref.finalize(plan, shutil.rmtree, folder, ignore_errors=True)
    return plan
