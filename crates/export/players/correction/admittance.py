"""The admittance law of the plan, which acts at the part: M a + D (v - v_r) + K (x - x_r) = F, in the frame of the base."""

from typing import Any

import numpy as np

import rotations
from exported_plan import ExportedPlan
from kinematics import Pose


class Admittance:
    """Computes the next commanded pose of the tool from its reference and the measured wrench. Implicit in damping and stiffness."""

    def __init__(self, plan: ExportedPlan, tool: Pose, stiffness_factor: float = 1.0, damping_factor: float = 1.0) -> None:
        record: dict[str, Any] = plan.document["admittance"]
        self.plan, self.period = plan, record["period_s"]
        self.mass, self.deadband = record["mass"], record["deadband"]
        self.damping = [damping_factor * value for value in record["damping"]]
        self.stiffness = [stiffness_factor * value for value in record["stiffness"]]
        self.speed, self.acceleration = record["speed"], record["acceleration"]
        self.commanded = self.before = tool @ plan.grasp
        self.velocity, self.angular_velocity = np.zeros(3), np.zeros(3)

    def step(self, reference: Pose, measured: Pose, force: np.ndarray, torque: np.ndarray) -> Pose:
        """The pose of the tool that is commanded a period after the last one; `measured` is where the wrench (N, Nm) was measured."""
        wanted, part = reference @ self.plan.grasp, measured @ self.plan.grasp
        torque = torque - rotations.cross(part.position - measured.position, force)
        error = self.before.position - self.commanded.position
        slope = (wanted.position - self.before.position) / self.period
        turn = rotations.sine(self.before.rotation @ self.commanded.rotation.T)
        turning = rotations.vector(wanted.rotation @ self.before.rotation.T) / self.period
        self.before = wanted
        self.velocity = self.answer(0, self.velocity, slope, error, force)
        self.angular_velocity = self.answer(1, self.angular_velocity, turning, turn, torque)
        self.commanded = Pose(
            self.commanded.position + self.period * self.velocity,
            rotations.of_vector(self.period * self.angular_velocity) @ self.commanded.rotation,
        )
        return self.commanded @ self.plan.grasp.inverse()

    def answer(self, part: int, before: np.ndarray, slope: np.ndarray, error: np.ndarray, load: np.ndarray) -> np.ndarray:
        """The velocity of translations (0) or rotations (1) a period later, within the limits of speed and acceleration."""
        mass, damping, stiffness, period = self.mass[part], self.damping[part], self.stiffness[part], self.period
        load = load - np.clip(load, -self.deadband[part], self.deadband[part])
        momentum = mass * before + period * (damping * slope + stiffness * (error + period * slope) + load)
        change = momentum / (mass + period * damping + period**2 * stiffness) - before
        return capped(before + capped(change, self.acceleration[part] * period), self.speed[part])


def capped(vector: np.ndarray, most: float) -> np.ndarray:
    """The vector, no longer than this."""
    length = float(np.linalg.norm(vector))
    return vector * (most / length) if length > most else vector
