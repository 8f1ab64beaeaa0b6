"""A plan as `assembly-plan solve` wrote it, and its reference at the simulator's time steps."""

import dataclasses
import json
import math
import pathlib
import tomllib
from typing import Any

import numpy as np

from lab import tables
from lab.errors import InputError
from lab.mujoco.robots import Robot
from lab.mujoco.rotations import rotation_matrix, rotation_vector, slerp
from lab.mujoco.shapes import part_vertices

TIME_COLUMN = "time_s"
STATE_COLUMNS = [
    "px_m",
    "py_m",
    "pz_m",
    "qw",
    "qx",
    "qy",
    "qz",
    "vx_m_s",
    "vy_m_s",
    "vz_m_s",
    "wx_rad_s",
    "wy_rad_s",
    "wz_rad_s",
]


Matrix = tuple[tuple[float, float, float], ...]


def damping_matrix(damping: float | list[float] | list[list[float]]) -> Matrix:
    """Rows of a damping that is given as a number, per axis, or as rows."""
    values = np.array(damping, dtype=float)
    rows = values if values.ndim == 2 else np.diag(np.broadcast_to(values, 3))
    return tuple(tuple(row) for row in rows.tolist())


@dataclasses.dataclass(frozen=True)
class Impedance:
    """The controller (Eq. impedancewrench): stiffness N/m, Nm/rad; rows of damping Ns/m (world frame), Nms/rad
    (body)."""

    translational_stiffness: float
    rotational_stiffness: float
    translational_damping: Matrix
    rotational_damping: Matrix

    def turned(self, rotation: np.ndarray) -> "Impedance":
        """With the rotational damping of a frame whose axes, seen from the body, are the columns of a matrix."""
        damping = rotation @ np.array(self.rotational_damping) @ rotation.T
        return dataclasses.replace(self, rotational_damping=damping_matrix(damping.tolist()))

    def scaled(self, factor: float) -> "Impedance":
        """All gains times a factor."""
        return Impedance(
            factor * self.translational_stiffness,
            factor * self.rotational_stiffness,
            damping_matrix((factor * np.array(self.translational_damping)).tolist()),
            damping_matrix((factor * np.array(self.rotational_damping)).tolist()),
        )


@dataclasses.dataclass(frozen=True)
class Reference:
    """Knots of a motion: times (s) and states (position, quaternion w x y z, velocity, angular velocity)."""

    times: np.ndarray
    states: np.ndarray

    def interval(self) -> float:
        """Mean time between knots (s)."""
        return self.times[-1] / (len(self.times) - 1)

    def sample(self, time_step: float, settling_time: float) -> np.ndarray:
        """States at multiples of `time_step`: positions linear, orientations by slerp, the velocity of the later knot
        held between knots; after the last knot its pose at rest for `settling_time`."""
        count = round((self.times[-1] + settling_time) / time_step)
        times = np.arange(count) * time_step
        # Times of knots that are multiples of the time step belong to the interval that they begin.
        later = np.searchsorted(self.times, times + 1e-9, side="right")
        moving = later < len(self.times)
        later = np.minimum(later, len(self.times) - 1)
        share = np.clip((times - self.times[later - 1]) / (self.times[later] - self.times[later - 1]), 0.0, 1.0)
        before, after = self.states[later - 1], self.states[later]
        states = np.empty((count, len(STATE_COLUMNS)))
        states[:, :3] = before[:, :3] + share[:, None] * (after[:, :3] - before[:, :3])
        states[:, 3:7] = slerp(before[:, 3:7], after[:, 3:7], share)
        states[:, 7:] = np.where(moving[:, None], after[:, 7:], 0.0)
        return states


@dataclasses.dataclass(frozen=True)
class PositionRobot:
    """A robot that is commanded by position, or a wrench in force mode: period and delay (s), bandwidth and cutoff
    (Hz), virtual mass, damping and stiffness of translations and rotations, contact stiffness (N/m) and its lever (m);
    of force mode, deadband of the measured wrench (N, Nm) and largest speeds (m/s, rad/s)."""

    period: float
    delay: float
    bandwidth: float
    cutoff: float
    mass: tuple[float, float]
    damping: tuple[float, float]
    stiffness: tuple[float, float]
    contact_stiffness: float
    lever: float
    is_force_mode: bool = False
    deadband: tuple[float, float] = (0.0, 0.0)
    speed: tuple[float, float] = (math.inf, math.inf)


@dataclasses.dataclass(frozen=True)
class FreeBody:
    """Mass (kg), centre of mass in the body frame (m) and rotational inertia about it (kg m^2)."""

    mass: float
    center: np.ndarray
    inertia: np.ndarray


@dataclasses.dataclass(frozen=True)
class Plan:
    """Everything needed to play a plan. `offsets` (n x 3, m, body frame) are those of the planned scenarios; `coverage`
    is `hull`, `disc` or `ball`, a disc lies across `insertion_axis` (body frame). `turn` (rad) is the largest turn in
    the gripper. `free_body` is None where no free body has the apparent inertia, `robot` is None unless an arm shall
    play the plan."""

    folder: pathlib.Path
    title: str
    start_name: str
    status: str
    body: list[np.ndarray]
    environment: list[np.ndarray]
    free_body: FreeBody | None
    impedance: Impedance
    start: np.ndarray
    goal: np.ndarray
    position_tolerance: float
    angle_tolerance: float
    delta: float
    offsets: np.ndarray
    coverage: str
    insertion_axis: np.ndarray
    turn: float
    reference: Reference
    robot: Robot | None = None
    position_robot: PositionRobot | None = None

    def straight(self) -> Reference:
        """The unplanned baseline: straight from start to goal at constant speed, in the plan's time."""
        duration = self.reference.times[-1]
        velocity = (self.goal[:3] - self.start[:3]) / duration
        spin = rotation_vector(self.start[3:], self.goal[3:]) / duration
        states = np.zeros((2, len(STATE_COLUMNS)))
        states[:, :7] = self.start, self.goal
        states[:, 7:] = np.concatenate([velocity, spin])
        return Reference(np.array([0.0, duration]), states)


def load(folder: pathlib.Path, scene_file: pathlib.Path | None) -> Plan:
    """Reads a folder of `solve`; a scene file replaces the shapes in `resolved.toml` by those it was solved from."""
    try:
        resolved = tomllib.loads((folder / "resolved.toml").read_text())
        result = json.loads((folder / "result.json").read_text())
        reference = read_reference(folder / "reference.csv")
        shapes_file = scene_file or folder / "resolved.toml"
        shapes = tomllib.loads(shapes_file.read_text())
        return plan(folder, resolved, result, reference, (shapes, shapes_file.parent))
    except OSError as error:
        raise InputError(f"{folder} is not a folder of a finished `assembly-plan solve`: {error}") from error
    except (KeyError, ValueError) as error:
        raise InputError(f"{folder}: {type(error).__name__}: {error}") from error


def plan(
    folder: pathlib.Path,
    resolved: dict[str, Any],
    result: dict[str, Any],
    reference: Reference,
    shapes: tuple[dict[str, Any], pathlib.Path],
) -> Plan:
    """Puts a plan together from its parsed files."""
    document, mesh_folder = shapes
    impedance = resolved["impedance"]
    return Plan(
        folder=folder,
        title=resolved["title"],
        start_name=resolved["start"][0]["name"],
        status=result["status"],
        body=[part_vertices(part, mesh_folder) for part in document["body"]["part"]],
        environment=[part_vertices(part, mesh_folder) for part in document["environment"]["part"]],
        free_body=free_body(resolved),
        impedance=Impedance(
            impedance["translational_stiffness"],
            impedance["rotational_stiffness"],
            # A force mode has no damping of its own here.
            damping_matrix(impedance.get("translational_damping", 0.0)),
            damping_matrix(impedance.get("rotational_damping", [0.0] * 3)),
        ),
        start=pose(resolved["start"][0]),
        goal=pose(resolved["goal"]),
        position_tolerance=resolved["goal"].get("position_tolerance", 0.003),
        angle_tolerance=resolved["goal"].get("angle_tolerance", 0.1),
        delta=result["delta_m"],
        offsets=np.array([scenario["offset_m"] for scenario in result["scenarios"]]),
        coverage=resolved["robustness"].get("coverage", "hull"),
        insertion_axis=insertion_axis(resolved),
        turn=resolved["robustness"].get("rotation_error", 0.0),
        reference=reference,
        position_robot=position_robot(resolved, document, mesh_folder),
    )


def insertion_axis(resolved: dict[str, Any]) -> np.ndarray:
    """Axis of a disc of offsets (body frame): that of the plan, else the straight line from start to goal."""
    if "insertion_axis" in resolved["robustness"]:
        return np.array(resolved["robustness"]["insertion_axis"])
    start, goal = pose(resolved["start"][0]), pose(resolved["goal"])
    way = rotation_matrix(goal[3:]).T @ (start[:3] - goal[:3])
    length = np.linalg.norm(way)
    return way / length if length > 0 else np.array([0.0, 0.0, 1.0])


def free_body(resolved: dict[str, Any]) -> FreeBody | None:
    """The free body that has the apparent inertia, if there is one."""
    if "mass" in resolved["body"]:
        return FreeBody(resolved["body"]["mass"], np.zeros(3), np.array(resolved["body"]["inertia"]))
    apparent = np.array(resolved["robot"]["apparent_inertia"])
    mass = apparent[0, 0]
    # Of a body with its centre of mass c, the coupling is -m R [c]x at the goal.
    lever = -rotation_matrix(pose(resolved["goal"])[3:]).T @ apparent[:3, 3:] / mass
    scale = 1e-9 * np.abs(apparent).max()
    if not np.allclose(apparent[:3, :3], mass * np.eye(3), atol=scale) or not np.allclose(lever, -lever.T, atol=1e-9):
        return None
    center = np.array([lever[2, 1], lever[0, 2], lever[1, 0]])
    return FreeBody(mass, center, apparent[3:, 3:] + mass * lever @ lever)


def position_robot(resolved: dict[str, Any], document: dict[str, Any], folder: pathlib.Path) -> PositionRobot | None:
    """The robot of a plan that is commanded by position or in force mode; None for one with torques."""
    robot, impedance = resolved.get("robot", {}), resolved["impedance"]
    if robot.get("interface") not in ("position", "force"):
        return None
    parts = [part_vertices(part, folder) for part in document["body"]["part"]]
    common = PositionRobot(
        period=robot["control_period"],
        delay=robot["delay"],
        bandwidth=robot["bandwidth"],
        cutoff=robot["sensor"]["cutoff"],
        mass=(0.0, 0.0),
        damping=(0.0, 0.0),
        stiffness=(impedance["translational_stiffness"], impedance["rotational_stiffness"]),
        contact_stiffness=robot["contact_stiffness"],
        lever=max(float(np.linalg.norm(part, axis=1).max()) for part in parts),
    )
    if robot["interface"] == "force":
        return in_force_mode(common, robot["force_mode"], robot["command"])
    return dataclasses.replace(
        common,
        mass=(robot["virtual_mass"], robot["virtual_inertia"]),
        damping=(impedance["translational_damping"], impedance["rotational_damping"][0]),
    )


def in_force_mode(robot: PositionRobot, mode: dict[str, float], command: dict[str, float]) -> PositionRobot:
    """The robot in force mode: its gains are inverse dampings, and its mass follows within a period."""
    damping = (1 / mode["translational_gain"], 1 / mode["rotational_gain"])
    return dataclasses.replace(
        robot,
        mass=(damping[0] * robot.period, damping[1] * robot.period),
        damping=damping,
        is_force_mode=True,
        deadband=(mode["force_deadband"], mode["torque_deadband"]),
        speed=(command["translational_velocity"], command["rotational_velocity"]),
    )


def read_reference(path: pathlib.Path) -> Reference:
    """Reads `reference.csv`."""
    rows = tables.read(path)
    times = np.array([float(row[TIME_COLUMN]) for row in rows])
    states = np.array([[float(row[column]) for column in STATE_COLUMNS] for row in rows])
    if len(times) < 2 or (np.diff(times) <= 0).any():
        raise ValueError("reference.csv needs at least two rows with increasing times")
    return Reference(times, states)


def pose(table: dict[str, Any]) -> np.ndarray:
    """Position and quaternion of a table of the scene."""
    return np.array([*table["position"], *table["orientation"]])
