"""An arm in MuJoCo that takes joint torques, for stand-ins of the makers' packages: it holds a part with a grasp error in the
scene of a recorded plan. What is simulated, and what goes wrong, stands in the variable SIMULATION (JSON)."""

import collections
import dataclasses
import json
import os
import pathlib
import sys
import tomllib
from typing import Any

import numpy as np

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "scripts/mujoco_validation"))

import mujoco

import arm_world
import robots
from arm import ArmPlayer
from offsets import GraspError
from plans import Impedance, Plan, Reference
from shapes import part_vertices, rotation_matrix
from world import Contact

TIME_STEP = 0.001
# Contact forces are not counted here.
NO_WINDOW = 1
# A push that no sensor feels (N, Nm), away from the corner.
PUSH = np.array([200.0, 0.0, 200.0, 0.0, 0.0, 0.0])
FRICTION = 0.1
NO_GAINS = Impedance(0.0, 0.0, ((0.0,) * 3,) * 3, ((0.0,) * 3,) * 3)


@dataclasses.dataclass(frozen=True)
class Fault:
    """What goes wrong, and when (s of motion)."""

    kind: str = ""
    time: float = np.inf


@dataclasses.dataclass(frozen=True)
class Truth:
    """What the robot and the parts really are, where that is not what the plan takes them for: rotor inertia (kg m^2) and
    friction (Nm) of every joint, delay of the torques (s), damping of the controller over that which is set, friction of
    contacts."""

    rotor_inertia: float | None = None
    joint_friction: float | None = None
    delay: float = 0.0
    damping: float = 1.0
    friction: float = FRICTION

    def robot(self, robot: robots.Robot) -> robots.Robot:
        """The arm as it is."""
        changed = {name: getattr(self, name) for name in ("rotor_inertia", "joint_friction")}
        joints = len(robot.configuration)
        return dataclasses.replace(robot, **{name: [value] * joints for name, value in changed.items() if value is not None})


@dataclasses.dataclass(frozen=True)
class Task:
    """What is simulated: folder of the recorded plan, name of the arm, grasp error (m, rad), by how much each joint is
    displaced from the start (rad), whether the controller's base is turned, what the robot really is, fault, and a file for the
    outcome."""

    plan: pathlib.Path
    arm: str
    offset: tuple[float, ...]
    outcome: pathlib.Path
    turn: tuple[float, ...] = (0.0, 0.0, 0.0)
    displaced: float = 0.0
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
        scene = tomllib.loads((ROOT / f"scenes/{document['scene']}.toml").read_text())
        robot = task.truth.robot(robots.read(ROOT / f"scripts/mujoco_validation/arms/{task.arm}.toml"))
        self.model = arm_world.build(world(scene, document, robot), Contact(task.truth.friction, TIME_STEP))
        self.player = ArmPlayer(self.model, world(scene, document, robot), NO_WINDOW)
        self.data = self.player.data
        start = np.array(document["arm"]["start_configuration"])
        # Displaced joints make the player go to the start first.
        self.player.release(start + task.displaced, GraspError(np.array(task.offset), np.array(task.turn)))
        self.still = mujoco.MjData(self.model)
        # Torques that have not come yet, one for each time step.
        self.pending = collections.deque([np.zeros(self.model.nv)] * round(task.truth.delay / TIME_STEP))
        self.mode, self.time, self.moved, self.goal = "position", 0.0, 0.0, np.array(document["goal"])

    def fails(self, kind: str) -> bool:
        """Whether a fault has come."""
        return self.task.fault.kind == kind and self.moved >= self.task.fault.time

    def rest(self, seconds: float) -> None:
        """Position control holds the arm."""
        self.data.qvel[:] = 0.0
        self.time += seconds

    def apply(self, torques: np.ndarray, seconds: float) -> None:
        """Torques (Nm) beside those that carry the arm."""
        commanded, carried = np.clip(torques, *self.player.torque_limits), self.gravity()
        if self.fails("push"):
            carried += self.tool()[2].T @ PUSH
        for _ in range(round(seconds / TIME_STEP)):
            mujoco.mj_step1(self.model, self.data)
            self.pending.append(commanded)
            self.data.qfrc_applied[:] = self.pending.popleft() + carried
            mujoco.mj_step2(self.model, self.data)
        self.time, self.moved = self.time + seconds, self.moved + seconds

    def gravity(self) -> np.ndarray:
        """What carries the arm at rest (Nm)."""
        self.still.qpos[:] = self.data.qpos
        mujoco.mj_fwdPosition(self.model, self.still)
        torques = np.zeros(self.model.nv)
        mujoco.mj_rne(self.model, self.still, 0, torques)
        return torques

    def tool(self) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Position, rotation matrix and Jacobian (6 x joints) of the tool in the robot's base."""
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
        if self.fails("force"):
            return np.array([0.0, 0.0, 500.0, 0.0, 0.0, 0.0])
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
            total += np.concatenate([force, np.cross(lever, force)])
        return total

    def leave(self) -> None:
        """Writes what has become of the part, and in which mode the robot was left."""
        state = np.array(self.player.state())
        cosine = min(1.0, abs(float(state[3:7] @ self.goal[3:])))
        outcome = {
            "position_error_m": float(np.linalg.norm(state[:3] - self.goal[:3])),
            "angle_error_rad": 2 * float(np.arccos(cosine)),
            "mode": self.mode,
            "time_s": self.time,
        }
        self.task.outcome.write_text(json.dumps(outcome))


def world(scene: dict[str, Any], document: dict[str, Any], robot: robots.Robot) -> Plan:
    """The parts and the arm; a player needs nothing else of a plan."""
    pose = np.array(document["goal"])
    return Plan(
        folder=pathlib.Path(document["scene"]),
        title=document["scene"],
        start_name=document["start"],
        status="",
        body=[part_vertices(part, ROOT / "scenes") for part in scene["body"]["part"]],
        environment=[part_vertices(part, ROOT / "scenes") for part in scene["environment"]["part"]],
        free_body=None,
        impedance=NO_GAINS,
        start=pose,
        goal=pose,
        position_tolerance=0.003,
        angle_tolerance=0.1,
        delta=document["delta_m"],
        offsets=np.zeros((1, 3)),
        turn=0.0,
        reference=Reference(np.array([0.0, 1.0]), np.zeros((2, 13))),
        robot=robot,
    )
