"""References of the user."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike

from assembly_plan._arrays import FloatArray, fixed, numbers
from assembly_plan._types import ReferenceOptions
from assembly_plan._values import number, optional
from assembly_plan.errors import SceneError

if TYPE_CHECKING:
    from assembly_plan.content import SceneContent
    from assembly_plan.plan import Plan


class Reference:
    """A motion to track, to be played or refined: `Scene.simulate`, `Scene.rollouts` and `Scene.refine` take it.

    lower = plan.reference[:, :7].copy()
    lower[:, 2] -= 0.001
    scene.simulate(assembly_plan.Reference(lower))
    """

    def __init__(
        self,
        states: ArrayLike,
        time_step: float | None = None,
        *,
        start: str | int | None = None,
        delta: float | None = None,
    ) -> None:
        """From states at N + 1 knots, shape (N + 1, 13), or poses, shape (N + 1, 7).

        Poses get the velocities that lead from knot to knot. Knots are `time_step` (s) apart, by default the scene's.
        `start` and `delta` (m) say for which start pose and offset magnitude of the scene; by default its own.
        """
        array = numbers(states, "states")
        if array.ndim != 2 or array.shape[1] not in (7, 13) or len(array) < 2:
            raise SceneError(
                f"states: has shape {array.shape}, must have shape (N + 1, 13) or (N + 1, 7), N at least 1"
            )
        self._states = fixed(array)
        self._time_step = optional(time_step, "time_step")
        self._start = None if start is None else str(start)
        self._delta = optional(delta, "delta")
        self._rotation_error: float | None = None

    @classmethod
    def of(cls, plan: Plan) -> Reference:
        """The reference of a plan, for its start and offset magnitude."""
        result = plan.result
        made = cls(plan.reference, plan.time_step, start=result["start"], delta=result["delta_m"])
        made._rotation_error = number(result["turn_rad"], "turn_rad")
        return made

    @property
    def states(self) -> FloatArray:
        """States or poses at the knots, shape (N + 1, 13) or (N + 1, 7); read-only."""
        return self._states

    @property
    def time_step(self) -> float | None:
        """Time between two knots (s); None for that of the scene."""
        return self._time_step

    @property
    def start(self) -> str | None:
        """Name of the start pose of the scene; None for its first."""
        return self._start

    @property
    def delta(self) -> float | None:
        """Offset magnitude (m); None for that of the scene."""
        return self._delta

    def _options(self, scene: SceneContent) -> ReferenceOptions:
        """As the native module takes it."""
        return {
            "states": self._states.tobytes(),
            "poses": self._states.shape[1] == 7,
            "time_step": scene.time_step if self._time_step is None else self._time_step,
            "start": self._start,
            "delta": self._delta,
            "rotation_error": self._rotation_error,
        }

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Reference):
            return NotImplemented
        own, others = (
            (reference.time_step, reference.start, reference.delta, reference._rotation_error)
            for reference in (self, other)
        )
        return own == others and bool(np.array_equal(self._states, other._states))

    def __hash__(self) -> int:
        return hash((self._time_step, self._start, self._delta, self._states.tobytes()))

    def __repr__(self) -> str:
        return f"<Reference: {len(self._states) - 1} steps>"
