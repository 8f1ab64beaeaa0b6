"""Joint positions that put the tool at its reference, each near the ones before."""

import numpy as np

import rotations
from exported_plan import ToolState
from failures import Stopped
from guards import JOINT_MARGIN
from kinematics import Arm, Pose

# Newton's method ends when the tool is this close (m and rad) to its reference, or after this many steps.
CLOSE, STEPS = 1e-9, 20
# From one reference to the next, a joint moves by no more than this (rad or m): close to a singular configuration it would.
LARGEST_STEP = 0.05


class JointReference:
    """Inverse kinematics along a motion, by the smallest change of the joints."""

    def __init__(self, arm: Arm, start: np.ndarray, period: float) -> None:
        self.arm, self.positions = arm, start.copy()
        self.largest = np.minimum(LARGEST_STEP, arm.speed * period)

    def follow(self, state: ToolState) -> tuple[np.ndarray, np.ndarray]:
        """Positions (rad or m) and speeds of the joints for a state of the tool as the URDF file has it."""
        positions = self.solved(state.pose)
        _, jacobian = self.arm.pose_and_jacobian(positions)
        speeds = np.linalg.pinv(jacobian) @ np.concatenate([state.velocity, state.angular_velocity])
        self.require(np.abs(positions - self.positions) <= self.largest, "moves too far from one reference to the next")
        self.require(np.abs(speeds) <= self.arm.speed, "is faster than it can in the reference")
        inside = (positions >= self.arm.lower + JOINT_MARGIN) & (positions <= self.arm.upper - JOINT_MARGIN)
        self.require(inside, f"comes within {JOINT_MARGIN:g} of its limits in the reference")
        self.positions = positions
        return positions, speeds

    def solved(self, wanted: Pose) -> np.ndarray:
        """Joint positions at which the tool is where it is wanted."""
        positions = self.positions
        for _ in range(STEPS):
            pose, jacobian = self.arm.pose_and_jacobian(positions)
            error = np.concatenate(
                [wanted.position - pose.position, rotations.vector(wanted.rotation @ pose.rotation.T)]
            )
            if np.abs(error).max() <= CLOSE:
                return positions
            if not np.isfinite(error).all():
                break
            positions = positions + np.linalg.pinv(jacobian) @ error
        raise Stopped("no joint positions near the last ones put the tool at its reference: it is out of reach, or the arm is stretched")

    def require(self, fine: np.ndarray, problem: str) -> None:
        """Stops where a joint cannot follow."""
        if not fine.all():
            name = self.arm.names[int(np.argmin(fine))]
            raise Stopped(f"joint `{name}` {problem}: the arm is close to a singular configuration or a limit")
