"""What `assembly-plan export` wrote: plan.json and trajectory.csv, sealed by SHA256SUMS."""

import csv
import dataclasses
import hashlib
import json
import math
import pathlib
from typing import Any

import numpy as np

import rotations
from failures import InputError
from kinematics import Arm, Pose

# Version of plan.json that this player reads.
FORMAT = 2
# The hashes of all files, as `sha256sum --check` reads them, and the files without which there is no plan.
SUMS, NEEDED = "SHA256SUMS", ("plan.json", "trajectory.csv")
# What is the user's to change.
OWN = {"plan.script", "controllers.yaml"}

POSITION = ("px_m", "py_m", "pz_m")
QUATERNION = ("qw", "qx", "qy", "qz")
VELOCITY = ("vx_m_s", "vy_m_s", "vz_m_s")
ANGULAR_VELOCITY = ("wx_rad_s", "wy_rad_s", "wz_rad_s")

# The norm of a quaternion may differ by this from 1.
UNIT = 1e-6
# Between two samples, the tool moves by no more than its largest velocity makes, and these (m, rad).
JUMP, JUMP_TURN = 1e-3, 1e-2


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

    def is_finite(self) -> bool:
        """Whether all of it are numbers."""
        parts = (self.pose.position, self.pose.rotation, self.velocity, self.angular_velocity)
        return all(bool(np.isfinite(part).all()) for part in parts)


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
        """The reference at a time (s): between two samples on the straight path, after the last one at rest."""
        if time >= self.duration:
            return ToolState.at_rest(Pose(self.positions[-1], rotations.matrix(self.quaternions[-1])))
        index = max(0, int(np.searchsorted(self.times, time, side="right")) - 1)
        share = (max(time, 0.0) - self.times[index]) / (self.times[index + 1] - self.times[index])

        def between(samples: np.ndarray) -> np.ndarray:
            return (1 - share) * samples[index] + share * samples[index + 1]

        quaternion = between(self.quaternions)
        pose = Pose(between(self.positions), rotations.matrix(quaternion / np.linalg.norm(quaternion)))
        return ToolState(pose, between(self.velocities), between(self.angular_velocities))

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

    def free_around_start(self, height: float) -> float:
        """How far (m) around the start of the reference, raised by the height of a dry run (m), the part touches nothing."""
        # Where the tool is raised by a metre, nothing comes nearer than by a metre.
        clearances = self.document["free"]["start_clearance_m"]
        return max((clearance - abs(height - raised) for raised, clearance in clearances), default=0.0)

    def arm_start(self, height: float) -> dict[str, Any]:
        """The arm at the start of the reference, raised by the height of a dry run (m) that is nearest to this one."""
        return min(self.document["free"]["arm_starts"], key=lambda start: abs(start["height_m"] - height))

    def warnings(self) -> list[str]:
        """What whoever plays the plan has to know before."""
        return [str(line) for line in self.document["warnings"]]

    def require_smooth(self) -> None:
        """Refuses times that do not increase, quaternions that are not of unit norm or change their sign, and jumps."""
        samples = (self.times, self.positions, self.quaternions, self.velocities, self.angular_velocities)
        steps = np.diff(self.times)
        speed = np.linalg.norm(self.velocities, axis=1).max()
        turning = np.linalg.norm(self.angular_velocities, axis=1).max()
        cosines = np.sum(self.quaternions[1:] * self.quaternions[:-1], axis=1)
        moved = np.linalg.norm(np.diff(self.positions, axis=0), axis=1)
        # Of small angles, for which this is a bound: the norm of a difference of quaternions is half of the angle.
        turned = 2 * np.linalg.norm(np.diff(self.quaternions, axis=0), axis=1)
        for is_fine, problem in (
            (len(self.times) > 1 and all(np.isfinite(sample).all() for sample in samples), "a value is no number"),
            ((steps > 0).all() and self.times[0] == 0.0, "times do not increase from zero"),
            ((np.abs(np.linalg.norm(self.quaternions, axis=1) - 1) <= UNIT).all(), "a quaternion is not of unit norm"),
            ((cosines > 0).all(), "the sign of the quaternions changes"),
            ((moved <= JUMP + 2 * speed * steps).all(), "the position jumps"),
            ((turned <= JUMP_TURN + 2 * turning * steps).all(), "the orientation jumps"),
        ):
            if not is_fine:
                raise InputError(f"trajectory.csv: {problem}; export again")


def load(folder: pathlib.Path) -> ExportedPlan:
    """Reads the folder of an export; InputError says what is wrong."""
    contents = sealed(folder)
    try:
        document = json.loads(contents["plan.json"], parse_constant=no_number, parse_float=number)
        if document["format"] != FORMAT:
            raise InputError(f"{folder / 'plan.json'}: format {document['format']}, this player reads {FORMAT}; export again")
        plan = ExportedPlan(document, list(csv.DictReader(contents["trajectory.csv"].decode().splitlines())))
    except (ArithmeticError, LookupError, TypeError, ValueError) as error:
        raise InputError(f"{folder} is not a whole export: {type(error).__name__} {error}; export again") from error
    plan.require_smooth()
    return plan


def sealed(folder: pathlib.Path) -> dict[str, bytes]:
    """The contents of all files of an export, none of which was changed. Every module beside the player is one: it may be imported."""
    try:
        sums = dict(reversed(line.split("  ", 1)) for line in (folder / SUMS).read_text().splitlines())
        modules = {path.name for path in folder.glob("*.py")}
        contents = {name: (folder / name).read_bytes() for name in {*NEEDED, *sums, *modules} - OWN}
    except (OSError, ValueError) as error:
        raise InputError(f"{folder} is not a whole folder of `assembly-plan export`: {error}") from error
    for name, content in contents.items():
        if hashlib.sha256(content).hexdigest() != sums.get(name):
            raise InputError(f"{folder / name} was changed since it was exported, or is of another export; export again")
    return contents


def no_number(name: str) -> float:
    """JSON has no NaN."""
    raise ValueError(f"{name} is not a number")


def number(text: str) -> float:
    """A number that is not too large to be one."""
    value = float(text)
    return value if math.isfinite(value) else no_number(text)


def column(rows: list[dict[str, str]], names: tuple[str, ...]) -> np.ndarray:
    """Some columns of a table."""
    return np.array([[float(row[name]) for name in names] for row in rows])
