"""What `assembly-plan export` wrote: plan.json and trajectory.csv."""

import csv
import dataclasses
import hashlib
import json
import pathlib
from typing import Any

import numpy as np

import rotations
from kinematics import Arm, Pose

# Version of plan.json that this player reads.
FORMAT = 1

POSITION = ("px_m", "py_m", "pz_m")
QUATERNION = ("qw", "qx", "qy", "qz")
VELOCITY = ("vx_m_s", "vy_m_s", "vz_m_s")
ANGULAR_VELOCITY = ("wx_rad_s", "wy_rad_s", "wz_rad_s")


class InputError(Exception):
    """Something the user gave is wrong."""


@dataclasses.dataclass(frozen=True)
class ToolState:
    """Pose, velocity of the tool point (m/s) and angular velocity (rad/s), along the axes of the base."""

    pose: Pose
    velocity: np.ndarray
    angular_velocity: np.ndarray

    @staticmethod
    def at_rest(pose: Pose) -> "ToolState":
        """A pose that is held."""
        return ToolState(pose, np.zeros(3), np.zeros(3))


class ExportedPlan:
    """The reference of the tool in the robot's base, and all that belongs to it."""

    def __init__(self, document: dict[str, Any], rows: list[dict[str, str]]) -> None:
        self.document = document
        self.base, self.grasp = Pose.of(document["base"]), Pose.of(document["grasp"])
        self.goal = Pose.of(document["goal"])
        self.arm = Arm(document["arm"]) if document["arm"] else None
        self.times = column(rows, ("time_s",))[:, 0]
        self.positions, self.quaternions = column(rows, POSITION), column(rows, QUATERNION)
        self.velocities, self.angular_velocities = column(rows, VELOCITY), column(rows, ANGULAR_VELOCITY)

    @property
    def duration(self) -> float:
        """Time of the last sample (s)."""
        return float(self.times[-1])

    def reference(self, time: float) -> ToolState:
        """The reference at a time (s): between two samples on the straight way, after the last one at rest."""
        if time >= self.duration:
            return ToolState.at_rest(Pose(self.positions[-1], rotations.matrix(self.quaternions[-1])))
        index = max(0, int(np.searchsorted(self.times, time, side="right")) - 1)
        share = (max(time, 0.0) - self.times[index]) / (self.times[index + 1] - self.times[index])
        quaternion = (1 - share) * self.quaternions[index] + share * self.quaternions[index + 1]
        position = (1 - share) * self.positions[index] + share * self.positions[index + 1]
        pose = Pose(position, rotations.matrix(quaternion / np.linalg.norm(quaternion)))
        return ToolState(pose, self.velocities[index], self.angular_velocities[index])

    def part(self, tool: Pose) -> Pose:
        """Where the robot believes the part in the world, from the pose of the tool in the base."""
        return self.base @ tool @ self.grasp

    def way_out(self) -> np.ndarray:
        """Direction from the goal to the start, a unit vector along the axes of the base: where there is room."""
        way = self.positions[0] - self.positions[-1]
        length = np.linalg.norm(way)
        if length < 1e-6:
            raise InputError("the reference ends where it starts: there is no direction for a dry run")
        return way / length


def load(folder: pathlib.Path) -> ExportedPlan:
    """Reads the folder of an export; InputError says what is wrong."""
    try:
        document = json.loads((folder / "plan.json").read_text())
        content = (folder / "trajectory.csv").read_bytes()
    except (OSError, ValueError) as error:
        raise InputError(f"{folder} is not a folder of `assembly-plan export`: {error}") from error
    if document.get("format") != FORMAT:
        raise InputError(f"{folder / 'plan.json'}: format {document.get('format')}, this player reads {FORMAT}; export again")
    if hashlib.sha256(content).hexdigest() != document["files"]["trajectory.csv"]:
        raise InputError(f"{folder / 'trajectory.csv'} was changed since it was exported; export again")
    return ExportedPlan(document, list(csv.DictReader(content.decode().splitlines())))


def column(rows: list[dict[str, str]], names: tuple[str, ...]) -> np.ndarray:
    """Some columns of a table."""
    return np.array([[float(row[name]) for name in names] for row in rows])
