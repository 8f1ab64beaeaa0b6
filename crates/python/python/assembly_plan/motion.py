"""Motions: a reference, and what the body does while the robot tracks it."""

from __future__ import annotations

import numpy as np

from assembly_plan._arrays import FloatArray, fixed, read
from assembly_plan._types import MotionData

_STATE = 13
_TWIST = 6


class Motion:
    """One reference motion and what the body does in each of S scenarios, in N steps. The arrays are read-only.

    A state has 13 numbers: position (m, world frame), unit quaternion ``w x y z``, velocity (m/s, world frame) and
    angular velocity (rad/s, body frame).
    """

    def __init__(self, data: MotionData) -> None:
        """Not to be called."""
        steps, scenarios, pairs = data["steps"], data["scenarios"], tuple(data["pairs"])
        self._time_step, self._pairs = data["time_step"], pairs
        self._time = fixed(self._time_step * np.arange(steps + 1))
        self._reference = read(data["reference"], steps + 1, _STATE)
        self._states = read(data["states"], scenarios, steps + 1, _STATE)
        self._wrenches = read(data["wrenches"], scenarios, steps, _TWIST)
        self._distances = read(data["distances"], scenarios, steps, len(pairs))
        self._forces = read(data["forces"], scenarios, steps, len(pairs))

    @property
    def time_step(self) -> float:
        """Time between two knots (s)."""
        return self._time_step

    @property
    def time(self) -> FloatArray:
        """Times of the N + 1 knots (s), shape (N + 1,)."""
        return self._time

    @property
    def reference(self) -> FloatArray:
        """The motion to track: states at the knots, shape (N + 1, 13)."""
        return self._reference

    @property
    def states(self) -> FloatArray:
        """States of the body in every scenario, shape (S, N + 1, 13)."""
        return self._states

    @property
    def wrenches(self) -> FloatArray:
        """The controller's wrench at the knots after the first, shape (S, N, 6).

        Force (N, world frame), torque (Nm, body frame).
        """
        return self._wrenches

    @property
    def pairs(self) -> tuple[str, ...]:
        """The P pairs of parts that may touch, ``BODY PART/ENVIRONMENT PART``."""
        return self._pairs

    @property
    def distances(self) -> FloatArray:
        """Smoothed distance of every pair (m) at the knots after the first, shape (S, N, P).

        NaN where it could not be computed.
        """
        return self._distances

    @property
    def forces(self) -> FloatArray:
        """Contact force of every pair (N) at the knots after the first, shape (S, N, P)."""
        return self._forces

    def __repr__(self) -> str:
        scenarios, knots = self.states.shape[:2]
        return f"<{type(self).__name__}: {knots - 1} steps of {self.time_step:g} s, {scenarios} scenarios>"
