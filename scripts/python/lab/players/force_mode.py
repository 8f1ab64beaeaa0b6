"""An arm in the force mode of its maker, as plans for it assume: the tool moves at a speed in proportion to the
difference between the wrench that it is told to apply and the one that it feels."""

import json

import numpy as np

from lab.mujoco.force_robot import ForceMode
from lab.players.position_arm import PositionArm
from lab.players.simulated_arm import Task

# Where an arm is nearly singular, its joints move less (as a part of the largest singular value).
LEAST_SINGULAR = 1e-3


def is_planned_for_force(task: Task) -> bool:
    """Whether the plan is for a robot in force mode."""
    admittance = json.loads((task.plan / "plan.json").read_text()).get("admittance")
    return admittance is not None and admittance["interface"] == "force"


class ForceModeArm(PositionArm):
    """Its gains are the inverse dampings of the plan's law."""

    def __init__(self, task: Task) -> None:
        super().__init__(task)
        law = json.loads((task.plan / "plan.json").read_text())["admittance"]
        self.law = ForceMode(*(np.repeat(law[name], 3) for name in ("mass", "damping", "deadband")))
        self.twist, self.wanted = np.zeros(6), self.data.qpos.copy()

    def comply(self, wrench: np.ndarray, limits: np.ndarray, seconds: float) -> None:
        """A period in which the tool is told to apply a wrench, with largest speeds (m/s, rad/s), all along the axes of
        the root."""
        self.twist = self.law.twist(self.twist, wrench, self.wrench(), limits, seconds)
        inverse = np.linalg.pinv(self.tool()[2], rcond=LEAST_SINGULAR)
        self.wanted = self.wanted + seconds * (inverse @ self.twist)
        self.move(self.wanted, seconds)
