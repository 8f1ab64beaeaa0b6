"""Rollouts with whole trajectories."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from assembly_plan._arrays import FloatArray, fixed, read
from assembly_plan._types import RolloutData
from assembly_plan.motion import Motion


class Rollouts(Motion):
    """S rollouts of one reference with hard contact, with all that happens at its knots. The arrays are read-only.

    Contact forces are means over the steps. Of a rollout that diverges, the rest is NaN.
    """

    def __init__(self, data: RolloutData) -> None:
        """Not to be called; `Scene.rollouts` returns it."""
        super().__init__(data["motion"])
        grasps, measures = read(data["grasps"], -1, 2, 3), read(data["measures"], -1, 4)
        self._offsets, self._turns = grasps[:, 0], grasps[:, 1]
        self._measures = measures
        self._success = np.array(data["success"], dtype=np.bool_)
        self._success.flags.writeable = False
        self._points = read(data["points"], len(grasps), len(self.time) - 1, len(self.pairs), 3)

    @property
    def offsets(self) -> FloatArray:
        """Offset of the part in the gripper (m, body frame), shape (S, 3)."""
        return self._offsets

    @property
    def turns(self) -> FloatArray:
        """Rotation of the part in the gripper (rotation vector, rad), shape (S, 3)."""
        return self._turns

    @property
    def success(self) -> NDArray[np.bool_]:
        """Whether each ends at the goal after the settling time, shape (S,)."""
        return self._success

    @property
    def position_errors(self) -> FloatArray:
        """Distance from the goal after the settling time (m), shape (S,)."""
        return self._measures[:, 0]

    @property
    def orientation_errors(self) -> FloatArray:
        """Angle to the goal after the settling time (rad), shape (S,)."""
        return self._measures[:, 1]

    @property
    def max_forces(self) -> FloatArray:
        """Largest contact force (N, mean over 10 ms), shape (S,)."""
        return self._measures[:, 2]

    @property
    def max_penetrations(self) -> FloatArray:
        """Deepest penetration at a knot (m), shape (S,)."""
        return self._measures[:, 3]

    @property
    def contact_points(self) -> FloatArray:
        """Where each pair touches or is nearest, at the knots after the first (m, world frame), shape (S, N, P, 3)."""
        return self._points

    @property
    def torques(self) -> FloatArray:
        """Torque of the controller at the knots after the first (Nm, body frame), shape (S, N, 3)."""
        return fixed(self.wrenches[..., 3:])
