"""Motions of arms under an impedance controller in MuJoCo, as JSON: torques `J' w + bias`, held for a control
period.

The controller is written apart from that of `validate`: the program is compared with both, so that a mistake in one of
them shows.
"""

import collections
import dataclasses
import json
from pathlib import Path

import mujoco
import numpy as np

from lab.mujoco.rotations import product, quaternion_of, rotation_matrix
from lab.recording.model import BASE, GRASP, PAYLOAD, build, joint_count, unit

TIME_STEP = 1e-4
CONTROL_PERIOD = 2e-3
# Between two knots of the reference, and between two recorded poses (s).
KNOT_INTERVAL = 0.02
RECORD_INTERVAL = 0.04
EDGES = [0.06, 0.05, 0.08]
TRANSLATIONAL_STIFFNESS, ROTATIONAL_STIFFNESS = 600.0, 30.0
TRANSLATIONAL_DAMPING, ROTATIONAL_DAMPING = 140.0, 6.0
CONFIGURATIONS = {
    "six": [0.3, -1.4, 1.9, -2.0, -1.5, 0.4],
    "seven": [0.2, 0.5, -0.1, -1.6, 0.3, 1.9, 0.4],
}


@dataclasses.dataclass(frozen=True)
class Motion:
    """What differs between motions: the arm, dry friction of the joints (Nm), a delay of the controller (s), how the
    part sits in the gripper (m, rad), how far below its lowest corner a floor is (m) and its friction."""

    arm: str
    joint_friction: float = 0.0
    delay: float = 0.0
    offset: tuple[float, float, float] = (0.0, 0.0, 0.0)
    turn: tuple[float, float, float] = (0.0, 0.0, 0.0)
    floor: float | None = None
    friction: float = 0.0


MOTIONS = {
    "free": Motion("six", offset=(0.004, -0.003, 0.005), turn=(0.05, -0.08, 0.1)),
    "delayed": Motion("seven", delay=0.006),
    "joint_friction": Motion("six", joint_friction=2.0),
    "pressing": Motion("six", floor=0.01, offset=(0.004, -0.003, 0.005), turn=(0.05, -0.08, 0.1)),
    "rubbing": Motion("six", floor=0.01, friction=0.3, joint_friction=0.5),
}


def reference(start: np.ndarray) -> list[np.ndarray]:
    """States at knots: rests, goes aside and down while it turns, rests, comes halfway back, rests."""

    def pose(time: float) -> np.ndarray:
        forth, back = (0.5 - 0.5 * np.cos(np.pi * np.clip((time - begin) / 0.6, 0, 1)) for begin in (0.2, 1.2))
        way = forth - 0.5 * back
        shift, turn = way * np.array([0.05, 0.02, -0.04]), way * np.array([0.1, 0.2, -0.15])
        return np.concatenate([start[:3] + shift, product(start[3:], quaternion_of(turn))])

    states = []
    for knot in range(round(2.4 / KNOT_INTERVAL) + 1):
        before, now = pose(max(knot - 1, 0) * KNOT_INTERVAL), pose(knot * KNOT_INTERVAL)
        spin = np.zeros(3)
        mujoco.mju_subQuat(spin, now[3:], before[3:])
        states.append(np.concatenate([now, (now[:3] - before[:3]) / KNOT_INTERVAL, spin / KNOT_INTERVAL]))
    return states


def tracked(states: list[np.ndarray], time: float) -> np.ndarray:
    """The reference at a time: between two knots, with the twist of the second one."""
    knot = min(int(time / KNOT_INTERVAL + 1e-9), len(states) - 2)
    fraction = time / KNOT_INTERVAL - knot
    before, after = states[knot], states[knot + 1]
    spin = np.zeros(3)
    mujoco.mju_subQuat(spin, after[3:7], before[3:7])
    position = before[:3] + fraction * (after[:3] - before[:3])
    return np.concatenate([position, product(before[3:7], quaternion_of(fraction * spin)), after[7:]])


class Player:
    """An arm in MuJoCo that moves as `motion` says."""

    def __init__(self, urdf: Path, motion: Motion) -> None:
        self.motion = motion
        self.rotor_inertia = [0.1] * joint_count(str(urdf), "tip")
        # The model without contacts tells where the floor has to be.
        spec, _ = build(str(urdf), "tip", self.rotor_inertia)
        self.corner = self.lowest_corner(self.add_part(spec).compile())
        spec, _ = build(str(urdf), "tip", self.rotor_inertia)
        self.model = self.add_contacts(self.add_part(spec)).compile()
        self.data = mujoco.MjData(self.model)
        self.data.qpos[:] = CONFIGURATIONS[motion.arm]
        mujoco.mj_forward(self.model, self.data)

    def add_part(self, spec: mujoco.MjSpec) -> mujoco.MjSpec:
        """With the part where it really is in the gripper: `P` of the offset and the turn is where it is believed."""
        turn = quaternion_of(np.array(self.motion.turn))
        back = turn * [1, -1, -1, -1]
        part = spec.body("arm/the part").add_body(
            name="real part", pos=-rotation_matrix(back) @ np.array(self.motion.offset), quat=back
        )
        half = [0.5 * edge for edge in EDGES]
        part.add_geom(name="part", type=mujoco.mjtGeom.mjGEOM_BOX, size=half, mass=0, contype=0, conaffinity=0)
        # Arms compensate gravity themselves.
        spec.option.gravity = [0, 0, 0]
        spec.option.timestep = TIME_STEP
        spec.option.cone = mujoco.mjtCone.mjCONE_ELLIPTIC
        # Otherwise what sticks by friction creeps.
        spec.option.impratio = 1000
        for joint in spec.joints:
            joint.frictionloss = self.motion.joint_friction
            joint.solref_friction, joint.solimp_friction = [2 * TIME_STEP, 1], [0.9999, 0.9999, 0.001, 0.5, 2]
        return spec

    def lowest_corner(self, model: mujoco.MjModel) -> float:
        """Height of the lowest corner of the part at the start (m)."""
        data = mujoco.MjData(model)
        data.qpos[:] = CONFIGURATIONS[self.motion.arm]
        mujoco.mj_forward(model, data)
        rotation = data.body("real part").xmat.reshape(3, 3)
        return data.body("real part").xpos[2] - np.abs(rotation[2]) @ np.array(EDGES) / 2

    def add_contacts(self, spec: mujoco.MjSpec) -> mujoco.MjSpec:
        """With the floor, if there is one."""
        if self.motion.floor is None:
            return spec
        spec.worldbody.add_geom(
            name="floor",
            type=mujoco.mjtGeom.mjGEOM_BOX,
            size=[2, 2, 0.1],
            pos=[0, 0, self.floor_height() - 0.1],
            contype=0,
            conaffinity=0,
        )
        pair = spec.add_pair(geomname1="part", geomname2="floor", solref=[10 * TIME_STEP, 1])
        pair.solimp = [0.99, 0.999, 1e-5, 0.5, 2]
        pair.condim = 3 if self.motion.friction > 0 else 1
        pair.friction[:2] = self.motion.friction
        return spec

    def floor_height(self) -> float | None:
        """Height of the floor (m)."""
        return None if self.motion.floor is None else self.corner - self.motion.floor

    def pose(self, name: str) -> np.ndarray:
        """Of a body."""
        return np.concatenate([self.data.body(name).xpos, self.data.body(name).xquat])

    def torques(self, target: np.ndarray) -> np.ndarray:
        """Of the impedance law where the part is believed to be."""
        part = self.model.body("arm/the part").id
        linear, angular = np.zeros((3, self.model.nv)), np.zeros((3, self.model.nv))
        pose, velocity = self.pose("arm/the part"), self.data.qvel
        mujoco.mj_jac(self.model, self.data, linear, angular, pose[:3], part)
        angular = rotation_matrix(pose[3:]).T @ angular
        error = product(pose[3:] * [1, -1, -1, -1], target[3:7])
        force = TRANSLATIONAL_STIFFNESS * (target[:3] - pose[:3])
        force += TRANSLATIONAL_DAMPING * (target[7:10] - linear @ velocity)
        torque = 2 * ROTATIONAL_STIFFNESS * error[0] * error[1:]
        torque += ROTATIONAL_DAMPING * (target[10:] - angular @ velocity)
        return linear.T @ force + angular.T @ torque + self.data.qfrc_bias

    def play(self, states: list[np.ndarray]) -> list[list[float]]:
        """Time and pose of the real part as it follows a reference."""
        period, every = round(CONTROL_PERIOD / TIME_STEP), round(RECORD_INTERVAL / TIME_STEP)
        late = round(self.motion.delay / TIME_STEP)
        commands: collections.deque[tuple[int, np.ndarray]] = collections.deque()
        # Until the first torques come, the arm holds itself.
        self.data.qfrc_applied[:] = self.data.qfrc_bias
        record = []
        for step in range(round((len(states) - 1) * KNOT_INTERVAL / TIME_STEP)):
            mujoco.mj_forward(self.model, self.data)
            if step % period == 0:
                commands.append((step + late, self.torques(tracked(states, step * TIME_STEP))))
            if commands and commands[0][0] == step:
                self.data.qfrc_applied[:] = commands.popleft()[1]
            mujoco.mj_step(self.model, self.data)
            if (step + 1) % every == 0:
                mujoco.mj_kinematics(self.model, self.data)
                pose = self.pose("real part").round(7).tolist()
                record.append([round((step + 1) * TIME_STEP, 6), *pose])
        return record


def write(arms: Path, folder: Path) -> None:
    """Plays and records all motions."""
    for name, motion in MOTIONS.items():
        player = Player(arms / f"{motion.arm}.urdf", motion)
        states = reference(player.pose("arm/the part"))
        content = {
            "mujoco": mujoco.__version__,
            **dataclasses.asdict(motion),
            "base": {**BASE, "orientation": unit(BASE["orientation"])},
            "grasp": {**GRASP, "orientation": unit(GRASP["orientation"])},
            "payload": PAYLOAD,
            "rotor_inertia": player.rotor_inertia,
            "configuration": CONFIGURATIONS[motion.arm],
            "control_period": CONTROL_PERIOD,
            "stiffness": [TRANSLATIONAL_STIFFNESS, ROTATIONAL_STIFFNESS],
            "damping": [TRANSLATIONAL_DAMPING, ROTATIONAL_DAMPING],
            "edges": EDGES,
            "floor_height": player.floor_height(),
            "knot_interval": KNOT_INTERVAL,
            "reference": [state.round(9).tolist() for state in states],
            "poses": player.play(states),
        }
        text = json.dumps(content, indent=1)
        (folder / f"{name}.json").write_text(text + "\n", encoding="utf-8")
