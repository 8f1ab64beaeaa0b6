"""The impedance law of the plan, which acts at the part: Eq. impedancewrench of the paper, in the frame of the base."""

from typing import Any

import numpy as np

import rotations
from exported_plan import ExportedPlan, ToolState
from kinematics import Pose


class Impedance:
    """Computes the wrench that pulls the part to its reference. The factors are the robot's own: what its joints keep for
    themselves asks for more than the plan's gains."""

    def __init__(self, plan: ExportedPlan, stiffness_factor: float = 1.0, damping_factor: float = 1.0) -> None:
        record: dict[str, Any] = plan.document["impedance"]
        self.plan = plan
        self.stiffness = stiffness_factor * record["translational_stiffness"]
        self.turning_stiffness = stiffness_factor * record["rotational_stiffness"]
        world = plan.base.rotation
        self.damping = damping_factor * world.T @ np.array(record["translational_damping"]) @ world
        self.turning_damping = damping_factor * np.array(record["rotational_damping"])

    def wrench(self, reference: ToolState, measured: ToolState) -> np.ndarray:
        """Force (N) and torque (Nm) about the tool point, along the axes of the base."""
        (wanted, wanted_velocity), (part, velocity) = self.of_part(reference), self.of_part(measured)
        force = self.stiffness * (wanted.position - part.position) + self.damping @ (wanted_velocity - velocity)
        # In the frame of the part.
        turn = rotations.sine(part.rotation.T @ wanted.rotation)
        # As in the plan, both angular velocities are taken in the frame of their own part.
        slip = wanted.rotation.T @ reference.angular_velocity - part.rotation.T @ measured.angular_velocity
        torque = part.rotation @ (self.turning_stiffness * turn + self.turning_damping @ slip)
        lever = part.position - measured.pose.position
        return np.concatenate([force, torque + rotations.cross(lever, force)])

    def of_part(self, tool: ToolState) -> tuple[Pose, np.ndarray]:
        """Pose and velocity of the part that the tool holds, in the base."""
        part = tool.pose @ self.plan.grasp
        return part, tool.velocity + rotations.cross(tool.angular_velocity, part.position - tool.pose.position)
