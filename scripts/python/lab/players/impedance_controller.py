"""A Cartesian impedance controller for the simulated arm: torques `J' (K e + D e_dot)` along the axes of the base, held
for its period."""

import numpy as np

import rotations
from lab.players.simulated_arm import SimulatedArm


class ImpedanceController:
    """Follows a reference: position, rotation matrix and twist of the tool."""

    def __init__(self, arm: SimulatedArm, period: float) -> None:
        self.arm, self.period = arm, period
        self.stiffness, self.damping = np.zeros((6, 6)), np.zeros((6, 6))
        self.position, self.rotation = arm.tool()[:2]
        self.twist = np.zeros(6)

    def step(self) -> None:
        """One period."""
        position, rotation, jacobian = self.arm.tool()
        error = np.concatenate([self.position - position, rotations.vector(self.rotation @ rotation.T)])
        lag = self.twist - jacobian @ self.arm.data.qvel
        truth = self.arm.task.truth
        wrench = truth.stiffness * self.stiffness @ error + truth.damping * self.damping @ lag
        self.arm.apply(jacobian.T @ wrench, self.period)
