"""An arm in MuJoCo that takes joint torques, for stand-ins of the makers' packages: it holds a part with a grasp error
in the scene of a recorded plan. What is simulated, and what goes wrong, stands in the variable SIMULATION (JSON)."""

import collections
import dataclasses
import json
import os
import pathlib
import tomllib
from typing import Any

import mujoco
import numpy as np

import rotations
from lab.mujoco import arm_world, robots
from lab.mujoco.arm import ArmPlayer
from lab.mujoco.control import GraspError
from lab.mujoco.plans import FreeBody, Impedance, Plan, Reference
from lab.mujoco.rotations import rotation_matrix
from lab.mujoco.shapes import part_vertices
from lab.mujoco.world import Contact
from lab.paths import ARMS, SCENES
from lab.players import faults

TIME_STEP = 0.001
# Contact forces are not counted here.
NO_WINDOW = 1
# A push that no sensor feels (N, Nm), away from the corner.
PUSH = np.array([200.0, 0.0, 200.0, 0.0, 0.0, 0.0])
# A load (N) that nobody told the robot of.
LOAD = np.array([0.0, 0.0, -20.0, 0.0, 0.0, 0.0])
# Stiffness (N/m) and damping (Ns/m) of an obstacle, which stands in front of the tool when it comes.
OBSTACLE, OBSTACLE_DAMPING = 1e5, 500.0
FRICTION = 0.1
NO_GAINS = Impedance(0.0, 0.0, ((0.0,) * 3,) * 3, ((0.0,) * 3,) * 3)


@dataclasses.dataclass(frozen=True)
class Fault:
    """What goes wrong, and when (s)."""

    kind: str = ""
    time: float = np.inf


@dataclasses.dataclass(frozen=True)
class Truth:
    """What the robot and the parts really are, where that is not what the plan takes them for: rotor inertia (kg m^2)
    and friction (Nm) of every joint, delay of the torques (s), stiffness and damping of the controller over those which
    are set, friction of contacts. Of robots that are commanded by position or force: delay (s) and bandwidth (Hz),
    error of the measured force and torque (N, Nm, along the axes of the base)."""

    rotor_inertia: float | None = None
    joint_friction: float | None = None
    delay: float = 0.0
    stiffness: float = 1.0
    damping: float = 1.0
    friction: float = FRICTION
    bandwidth: float | None = None
    bias: tuple[float, ...] = (0.0,) * 6

    def robot(self, robot: robots.Robot) -> robots.Robot:
        """The arm as it is."""
        changed = {name: getattr(self, name) for name in ("rotor_inertia", "joint_friction")}
        joints = len(robot.configuration)
        return dataclasses.replace(
            robot, **{name: [value] * joints for name, value in changed.items() if value is not None}
        )


@dataclasses.dataclass(frozen=True)
class Task:
    """What is simulated: folder of the recorded plan, name of the arm, grasp error (m, rad), by how much each joint is
    displaced from the start (rad), whether the controller's base is turned, what the robot really is, fault, and a file
    for the outcome."""

    plan: pathlib.Path
    arm: str
    offset: tuple[float, ...]
    outcome: pathlib.Path
    turn: tuple[float, ...] = (0.0, 0.0, 0.0)
    displaced: float | tuple[float, ...] = 0.0
    base_is_turned: bool = False
    truth: Truth = Truth()
    fault: Fault = Fault()

    @staticmethod
    def read() -> "Task":
        """That of this process."""
        record = json.loads(os.environ["SIMULATION"])
        paths = {key: pathlib.Path(record[key]) for key in ("plan", "outcome")}
        nested = {"fault": Fault(**record.get("fault", {})), "truth": Truth(**record.get("truth", {}))}
        return Task(**{**record, **paths, **nested})


class SimulatedArm:
    """An arm with gravity, joint friction and contacts. It stands still unless torques are applied."""

    def __init__(self, task: Task) -> None:
        self.task = task
        document = json.loads((task.plan / "plan.json").read_text())
        scene = tomllib.loads((SCENES / f"{document['scene']}.toml").read_text())
        robot = task.truth.robot(robots.read(ARMS / f"{task.arm}.toml"))
        # The plan says where it stands.
        robot = dataclasses.replace(robot, base=np.array(document["base"]))
        self.model = arm_world.build(world(scene, document, robot), Contact(task.truth.friction, TIME_STEP))
        self.player = ArmPlayer(self.model, world(scene, document, robot), NO_WINDOW)
        self.data = self.player.data
        start = np.array(document["arm"]["start_configuration"])
        # Displaced joints make the player go to the start first.
        self.player.release(start + task.displaced, GraspError(np.array(task.offset), np.array(task.turn)))
        self.still = mujoco.MjData(self.model)
        # Torques that have not come yet, one for each time step.
        self.pending = collections.deque([np.zeros(self.model.nv)] * round(task.truth.delay / TIME_STEP))
        self.mode, self.time, self.goal = "position", 0.0, np.array(document["goal"])
        # What was said when the fault came, and where an obstacle stands and what it faces.
        self.first: faults.Said | None = None
        self.obstacle: tuple[np.ndarray, np.ndarray] | None = None
        self.commands, self.largest_step, self.former = 0, 0.0, None
        self.greatest_force = 0.0
        # Joint positions that the tool was asked for last, and the answer.
        self.known: tuple[bytes, tuple[np.ndarray, np.ndarray, np.ndarray]] | None = None

    def said(self) -> faults.Said:
        """What the robot says of itself."""
        position, rotation, _ = self.tool()
        data = self.data
        return self.spoiled(
            faults.Said(self.time, data.qpos.copy(), data.qvel.copy(), position, rotation, self.wrench())
        )

    def spoiled(self, said: faults.Said) -> faults.Said:
        """The same, when the fault has come."""
        if self.time < self.task.fault.time or not self.task.fault.kind:
            return said
        self.first = self.first or said
        return faults.spoiled(self.task.fault.kind, said, self.first)

    def obey(self, numbers: np.ndarray) -> None:
        """Counts a command; one that is no number breaks the robot."""
        self.commands += 1
        if not np.isfinite(numbers).all():
            self.mode = "broken"
            raise AssertionError("a command is no number")

    def fails(self, kind: str) -> bool:
        """Whether a fault has come."""
        return self.task.fault.kind == kind and self.time >= self.task.fault.time

    def rest(self, seconds: float) -> None:
        """Position control holds the arm."""
        self.data.qvel[:] = 0.0
        self.time += seconds

    def apply(self, torques: np.ndarray, seconds: float) -> None:
        """Torques (Nm) beside those that carry the arm."""
        commanded, carried = np.clip(torques, *self.player.torque_limits), self.gravity()
        if self.former is not None:
            self.largest_step = max(self.largest_step, float(np.abs(commanded - self.former).max()) / (1e3 * seconds))
        self.former = commanded
        for load, kind in ((PUSH, "push"), (LOAD, "payload")):
            if self.fails(kind):
                carried += self.tool()[2].T @ load
        for _ in range(round(seconds / TIME_STEP)):
            mujoco.mj_step1(self.model, self.data)
            self.pending.append(commanded)
            self.data.qfrc_applied[:] = self.pending.popleft() + carried + self.tool()[2].T @ self.pushed_back()
            mujoco.mj_step2(self.model, self.data)
        self.time += seconds

    def pushed_back(self) -> np.ndarray:
        """What an obstacle does to the tool, in the robot's base."""
        if not self.fails("obstacle"):
            return np.zeros(6)
        position, _, jacobian = self.tool()
        velocity = (jacobian @ self.data.qvel)[:3]
        if self.obstacle is None:
            # It waits until the tool comes.
            if np.linalg.norm(velocity) < 0.003:
                return np.zeros(6)
            self.obstacle = position, velocity / np.linalg.norm(velocity)
        place, facing = self.obstacle
        depth = (position - place) @ facing
        size = max(0.0, OBSTACLE * depth + OBSTACLE_DAMPING * velocity @ facing) if depth > 0 else 0.0
        self.greatest_force = max(self.greatest_force, size)
        return np.concatenate([-size * facing, np.zeros(3)])

    def gravity(self) -> np.ndarray:
        """What carries the arm at rest (Nm)."""
        self.still.qpos[:] = self.data.qpos
        mujoco.mj_fwdPosition(self.model, self.still)
        torques = np.zeros(self.model.nv)
        mujoco.mj_rne(self.model, self.still, 0, torques)
        return torques

    def tool(self) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Position, rotation matrix and Jacobian (6 x joints) of the tool in the robot's base."""
        key = self.data.qpos.tobytes()
        if self.known is None or self.known[0] != key:
            self.known = key, self.computed_tool()
        return self.known[1]

    def computed_tool(self) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """The same, computed."""
        model, data = self.model, self.data
        mujoco.mj_kinematics(model, data)
        mujoco.mj_comPos(model, data)
        robot = self.player.plan.robot
        base, tip = rotation_matrix(robot.base[3:]), model.body(arm_world.PREFIX + robot.tip).id
        linear, angular = np.zeros((2, 3, model.nv))
        mujoco.mj_jacBody(model, data, linear, angular, tip)
        position = base.T @ (data.xpos[tip] - robot.base[:3])
        return position, base.T @ data.xmat[tip].reshape(3, 3), np.vstack([base.T @ linear, base.T @ angular])

    def wrench(self) -> np.ndarray:
        """Force (N) and torque (Nm) that the environment applies, about the tool point, along the axes of the base."""
        load = LOAD if self.fails("payload") else np.zeros(6)
        return self.pushed_back() + load + self.contact_wrench() + np.array(self.task.truth.bias)

    def contact_wrench(self) -> np.ndarray:
        """What the parts do to each other."""
        position, _, _ = self.tool()
        robot = self.player.plan.robot
        base = rotation_matrix(robot.base[3:])
        total, contact_wrench = np.zeros(6), np.zeros(6)
        for index in range(self.data.ncon):
            contact = self.data.contact[index]
            mujoco.mj_contactForce(self.model, self.data, index, contact_wrench)
            frame = contact.frame.reshape(3, 3)
            # From the first geom to the second: the part is the one whose body moves.
            sign = 1.0 if self.model.geom_bodyid[contact.geom2] == self.player.part else -1.0
            force = base.T @ (sign * frame.T @ contact_wrench[:3])
            lever = base.T @ (contact.pos - robot.base[:3]) - position
            total += np.concatenate([force, rotations.cross(lever, force)])
        return total

    def state(self) -> np.ndarray:
        """Pose and twist of the part in the world."""
        return np.array(self.player.state())

    def leave(self) -> None:
        """Writes what has become of the part, and in which mode the robot was left."""
        state = self.state()
        cosine = min(1.0, abs(float(state[3:7] @ self.goal[3:])))
        outcome = {
            "position_error_m": float(np.linalg.norm(state[:3] - self.goal[:3])),
            "angle_error_rad": 2 * float(np.arccos(cosine)),
            "mode": self.mode,
            "time_s": self.time,
            "commands": self.commands,
            "torque_step_nm_per_ms": self.largest_step,
            "obstacle_force_n": self.greatest_force,
        }
        self.task.outcome.write_text(json.dumps(outcome))


def world(
    scene: dict[str, Any], document: dict[str, Any], robot: robots.Robot | None, free_body: FreeBody | None = None
) -> Plan:
    """The parts and what moves one of them; a player needs nothing else of a plan."""
    pose = np.array(document["goal"])
    return Plan(
        folder=pathlib.Path(document["scene"]),
        title=document["scene"],
        start_name=document["start"],
        status="",
        body=[part_vertices(part, SCENES) for part in scene["body"]["part"]],
        environment=[part_vertices(part, SCENES) for part in scene["environment"]["part"]],
        free_body=free_body,
        impedance=NO_GAINS,
        start=pose,
        goal=pose,
        position_tolerance=0.003,
        angle_tolerance=0.1,
        delta=document["delta_m"],
        offsets=np.zeros((1, 3)),
        coverage="hull",
        insertion_axis=np.array([0.0, 0.0, 1.0]),
        turn=0.0,
        reference=Reference(np.array([0.0, 1.0]), np.zeros((2, 13))),
        robot=robot,
    )
