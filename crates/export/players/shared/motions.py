"""Motions that a player makes by itself: from one pose to another."""

from collections.abc import Callable

import rotations
from exported_plan import ToolState
from kinematics import Pose

# Largest speed of a motion over its mean speed.
PEAK = 1.875


def straight(begin: Pose, end: Pose, duration: float) -> Callable[[float], ToolState]:
    """From one pose to another in a time (s), then at rest. Velocity and acceleration are continuous: no torque steps."""
    way, turn = end.position - begin.position, rotations.vector(end.rotation @ begin.rotation.T)

    def state(time: float) -> ToolState:
        if time >= duration:
            return ToolState.at_rest(end)
        done = time / duration
        share = done**3 * (10 - 15 * done + 6 * done**2)
        rate = 30 * done**2 * (1 - done) ** 2 / duration
        pose = Pose(begin.position + share * way, rotations.of_vector(share * turn) @ begin.rotation)
        return ToolState(pose, rate * way, rate * turn)

    return state
