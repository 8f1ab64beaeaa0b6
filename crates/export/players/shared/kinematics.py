"""Kinematics of the arm that the plan was made for, from the chain of joints in plan.json."""

import dataclasses
from typing import Any

import numpy as np

import rotations


@dataclasses.dataclass(frozen=True)
class Pose:
    """Position (m) and rotation matrix."""

    position: np.ndarray
    rotation: np.ndarray

    @staticmethod
    def of(numbers: Any) -> "Pose":
        """Of position and unit quaternion (w x y z)."""
        values = np.array(numbers, dtype=float)
        return Pose(values[:3], rotations.matrix(values[3:]))

    def __matmul__(self, other: "Pose") -> "Pose":
        return Pose(self.position + self.rotation @ other.position, self.rotation @ other.rotation)

    def inverse(self) -> "Pose":
        """The frame that this pose is in, seen from it."""
        return Pose(-self.rotation.T @ self.position, self.rotation.T)

    def errors(self, other: "Pose") -> tuple[float, float]:
        """Distance (m) and angle (rad) to another pose."""
        turn = rotations.vector(self.rotation.T @ other.rotation)
        return float(np.linalg.norm(other.position - self.position)), float(np.linalg.norm(turn))


class Arm:
    """A chain of joints. Poses are in the base, positions in rad or m."""

    def __init__(self, record: dict[str, Any]) -> None:
        joints = record["joints"]
        self.names = [joint["name"] for joint in joints]
        self.frames = [Pose.of(joint["frame"]) for joint in joints]
        self.axes = [np.array(joint["axis"]) for joint in joints]
        self.slides = [joint["slides"] for joint in joints]
        self.tool = Pose.of(record["tool"])
        self.lower = limits(joints, "lower", -np.inf)
        self.upper = limits(joints, "upper", np.inf)
        self.speed = limits(joints, "speed", np.inf)
        self.torque = limits(joints, "torque", np.inf)
        self.start = np.array(record["start_configuration"])
        # Joint positions that were asked for last, and the answer: guards ask once more.
        self.last: tuple[bytes, tuple[Pose, np.ndarray]] | None = None

    def forward(self, positions: np.ndarray) -> Pose:
        """Pose of the tool."""
        return self.pose_and_jacobian(positions)[0]

    def pose_and_jacobian(self, positions: np.ndarray) -> tuple[Pose, np.ndarray]:
        """Pose of the tool, and its Jacobian (6 x joints): velocity of the tool point and angular velocity, along the axes of
        the base, per speed of each joint."""
        if self.last is None or self.last[0] != positions.tobytes():
            self.last = positions.tobytes(), self.computed(positions)
        return self.last[1]

    def computed(self, positions: np.ndarray) -> tuple[Pose, np.ndarray]:
        """The same, computed."""
        frame = Pose(np.zeros(3), np.eye(3))
        axes, origins = np.zeros((2, len(self.frames), 3))
        for index, (before, axis, slides) in enumerate(zip(self.frames, self.axes, self.slides)):
            frame = frame @ before
            axes[index], origins[index] = frame.rotation @ axis, frame.position
            if slides:
                frame = Pose(frame.position + positions[index] * axes[index], frame.rotation)
            else:
                frame = Pose(frame.position, frame.rotation @ rotations.of_vector(positions[index] * axis))
        tool = frame @ self.tool
        jacobian = np.zeros((6, len(self.frames)))
        for index, (axis, origin, slides) in enumerate(zip(axes, origins, self.slides)):
            jacobian[:3, index] = axis if slides else rotations.cross(axis, tool.position - origin)
            jacobian[3:, index] = 0.0 if slides else axis
        return tool, jacobian


def limits(joints: list[dict[str, Any]], key: str, absent: float) -> np.ndarray:
    """A limit of every joint."""
    return np.array([absent if joint[key] is None else joint[key] for joint in joints])
