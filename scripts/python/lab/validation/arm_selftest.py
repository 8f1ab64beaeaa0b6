"""Checks of whole arms against solutions that are known."""

import dataclasses
import math
import pathlib
import xml.etree.ElementTree as ElementTree
from collections.abc import Iterator
from typing import Any

import mujoco
import numpy as np

from lab.mujoco import robots, shapes
from lab.mujoco.control import GraspError
from lab.mujoco.inverse_kinematics import configuration_at
from lab.mujoco.plans import Impedance, Plan, Reference, damping_matrix
from lab.mujoco.rotations import rotation_matrix, rotation_vector
from lab.paths import ARMS
from lab.validation.rollouts import Rollouts, Settings

TIME_STEP = 0.0005
FORCE_WINDOW = 20
STIFFNESS = 800.0
NAMES = ("six", "seven")
UPRIGHT = [1.0, 0.0, 0.0, 0.0]
NO_ERROR = GraspError(np.zeros(3), np.zeros(3))

# What is measured, its error and the largest tolerable one, in one unit.
Check = tuple[str, float, float]


def checks(example: Plan, engine: str) -> Iterator[Check]:
    """All checks, with the box of an example above its floor."""
    for arm in NAMES:
        for check in (forward_kinematics, free_motion, press, deadband, delay):
            yield from check(held(example, arm), arm, engine)


def held(example: Plan, arm: str) -> Plan:
    """The example with an arm that computes torques in every step."""
    robot = dataclasses.replace(robots.read(ARMS / f"{arm}.toml"), control_period=TIME_STEP)
    robot = dataclasses.replace(robot, joint_friction=0 * robot.joint_friction)
    impedance = Impedance(STIFFNESS, 60.0, damping_matrix(160.0), damping_matrix(12.0))
    return dataclasses.replace(example, robot=robot, impedance=impedance)


def player(plan: Plan, engine: str) -> Any:
    """A player of a plan without contact friction, and with a MuJoCo model of the arm."""
    return Rollouts(plan, Settings(TIME_STEP, 1.0, engine)).player(0.0)


def resting(pose: np.ndarray, duration: float) -> list[list[float]]:
    """Samples of a reference at rest."""
    states = np.tile([*pose, *6 * [0.0]], (2, 1))
    return Reference(np.array([0.0, duration]), states).sample(TIME_STEP, 0.0).tolist()


def forward_kinematics(plan: Plan, arm: str, engine: str) -> Iterator[Check]:
    """The part is where the product of all transforms of the URDF file puts it, displaced by the grasp error."""
    arm_player, random = player(plan, engine), np.random.default_rng(3)
    offset, angle = np.array([0.004, -0.003, 0.005]), 0.1
    for name, turn in (("", 0.0), (" with a turned part", angle)):
        configuration = random.uniform(-1, 1, len(plan.robot.configuration))
        arm_player.release(configuration, GraspError(offset, np.array([0.0, 0.0, turn])))
        state = np.array(arm_player.state())
        real = transform(state[:3], rotation_matrix(state[3:7]))
        believed = real @ transform(offset, turned(2, turn))
        error = np.abs(believed - believed_frame(plan, configuration)).max()
        yield f"{arm}: forward kinematics{name}, m", error, 1e-9
    goal = configuration_at(arm_player.model, plan.goal, plan.robot.configuration)
    arm_player.release(goal, NO_ERROR)
    state = np.array(arm_player.state())
    error = np.append(state[:3] - plan.goal[:3], rotation_vector(state[3:7], plan.goal[3:]))
    yield f"{arm}: inverse kinematics, m", np.abs(error).max(), 1e-8


def believed_frame(plan: Plan, configuration: np.ndarray) -> np.ndarray:
    """Frame of the part (4 x 4) from the file alone: joints turn about z, all of them on the way to the tip."""
    frame = transform(plan.robot.base[:3], rotation_matrix(plan.robot.base[3:]))
    angles = iter(configuration)
    for joint in ElementTree.parse(plan.robot.urdf).getroot().iter("joint"):
        origin = joint.find("origin")
        roll, pitch, yaw = (float(number) for number in origin.get("rpy").split())
        place = [float(number) for number in origin.get("xyz").split()]
        frame = frame @ transform(place, turned(2, yaw) @ turned(1, pitch) @ turned(0, roll))
        if joint.get("type") == "revolute":
            frame = frame @ transform(np.zeros(3), turned(2, next(angles)))
    return frame @ transform(plan.robot.grasp[:3], rotation_matrix(plan.robot.grasp[3:]))


def transform(position: np.ndarray | list[float], rotation: np.ndarray) -> np.ndarray:
    """A frame as 4 x 4 matrix."""
    frame = np.eye(4)
    frame[:3, :3], frame[:3, 3] = rotation, position
    return frame


def turned(axis: int, angle: float) -> np.ndarray:
    """Rotation matrix about a coordinate axis."""
    quaternion = np.zeros(4)
    quaternion[0], quaternion[1 + axis] = math.cos(angle / 2), math.sin(angle / 2)
    return rotation_matrix(quaternion)


def free_motion(plan: Plan, arm: str, engine: str) -> Iterator[Check]:
    """Released beside a resting reference, the part moves as a body of the apparent inertia on springs and dampers."""
    shift, duration = np.array([0.001, -0.002, 0.002]), 0.3
    arm_player = player(plan, engine)
    samples = resting(np.append(shift, UPRIGHT), duration)
    start = configuration_at(arm_player.model, plan.goal, plan.robot.configuration)
    arm_player.release(start, NO_ERROR)
    inertia = apparent_inertia(arm_player.model, start)
    rows: list[list[float]] = []
    arm_player.play(samples, lambda: rows.append(arm_player.state()))
    actual = np.array(rows)[:, :3]
    # x'' = -inertia^-1 (K x + D x'), as the exponential of one step.
    gains = plan.impedance
    stiffness = np.diag([*3 * [gains.translational_stiffness], *3 * [gains.rotational_stiffness]])
    damping = np.zeros((6, 6))
    damping[:3, :3], damping[3:, 3:] = gains.translational_damping, gains.rotational_damping
    rates = np.block([[np.zeros((6, 6)), np.eye(6)], [-np.linalg.solve(inertia, np.hstack([stiffness, damping]))]])
    values, vectors = np.linalg.eig(rates)
    initial = np.linalg.solve(vectors, np.concatenate([-shift, np.zeros(9)]).astype(complex))
    times = np.arange(len(actual)) * TIME_STEP
    exact = np.real(np.exp(np.outer(times, values)) * initial @ vectors.T)[:, :3] + shift
    yield f"{arm}: free motion, m", np.abs(actual - exact).max(), 1e-5


def apparent_inertia(model: mujoco.MjModel, configuration: np.ndarray) -> np.ndarray:
    """`(J M^-1 J')^-1` of the part (6 x 6), where it is upright."""
    data, jacobian = at(model, configuration)
    mass = np.zeros((model.nv, model.nv))
    mujoco.mj_fullM(model, data, mass)
    return np.linalg.inv(jacobian @ np.linalg.solve(mass, jacobian.T))


def at(model: mujoco.MjModel, configuration: np.ndarray) -> tuple[mujoco.MjData, np.ndarray]:
    """The arm at joint positions (rad), and the Jacobian of the part's pose (6 x joints, world frame)."""
    data, jacobian = mujoco.MjData(model), np.zeros((6, model.nv))
    data.qpos[:] = configuration
    mujoco.mj_forward(model, data)
    mujoco.mj_jacSite(model, data, jacobian[:3], jacobian[3:], model.site("grasp").id)
    return data, jacobian


def press(plan: Plan, arm: str, engine: str) -> Iterator[Check]:
    """Told to go below a floor, the part presses on it with stiffness times depth. A part that sits higher than the
    controller believes presses less."""
    depth, height = 0.01, 0.03
    floor = {"box": [2.0, 2.0, 0.1], "position": [0.0, 0.0, -height - 0.05]}
    plan = dataclasses.replace(plan, environment=[shapes.part_vertices(floor, pathlib.Path())])
    arm_player = player(plan, engine)
    samples = resting(np.array([0.0, 0.0, -depth, *UPRIGHT]), 2.0)
    start = configuration_at(arm_player.model, plan.goal, plan.robot.configuration)
    for offset in (0.0, 0.004):
        arm_player.release(start, GraspError(np.array([0.0, 0.0, -offset]), np.zeros(3)))
        forces: list[float] = []
        arm_player.play(samples, lambda seen=forces: seen.append(arm_player.normal_force()))
        # Its corners take turns in carrying the part.
        force = np.mean(forces[len(forces) // 2 :])
        yield f"{arm}: press with an offset of {1e3 * offset:g} mm, N", abs(force - STIFFNESS * (depth - offset)), 0.05
        yield f"{arm}: height of the pressed part, m", abs(arm_player.state()[2]), 5e-5


def deadband(plan: Plan, arm: str, engine: str) -> Iterator[Check]:
    """With joint friction the arm rests where all torques of the springs are below it, and not elsewhere."""
    friction = 0.5
    robot = dataclasses.replace(plan.robot, joint_friction=np.full(len(plan.robot.configuration), friction))
    arm_player = player(dataclasses.replace(plan, robot=robot), engine)
    start = configuration_at(arm_player.model, plan.goal, robot.configuration)
    _, jacobian = at(arm_player.model, start)
    # Along x the friction of one joint after the other is overcome: the first one at this distance.
    edge = friction / (STIFFNESS * np.abs(jacobian[0]).max())
    for share, moves in ((0.95, False), (1.1, True)):
        arm_player.release(start, NO_ERROR)
        arm_player.play(resting(np.array([share * edge, 0.0, 0.0, *UPRIGHT]), 2.0))
        moved = np.linalg.norm(arm_player.state()[:3])
        if moves:
            yield f"{arm}: rest beyond the deadband, m", max(0.0, 1e-6 - moved), 0.0
        else:
            yield f"{arm}: creep within the deadband, m", moved, 1e-6


def delay(plan: Plan, arm: str, engine: str) -> Iterator[Check]:
    """Until the first torque arrives, the arm carries itself and does not move."""
    wait = 10
    robot = dataclasses.replace(plan.robot, delay=wait * TIME_STEP)
    arm_player = player(dataclasses.replace(plan, robot=robot), engine)
    arm_player.release(configuration_at(arm_player.model, plan.goal, robot.configuration), NO_ERROR)
    speeds: list[float] = []
    samples = resting(np.array([0.01, 0.0, 0.0, *UPRIGHT]), 2 * wait * TIME_STEP)
    arm_player.play(samples, lambda: speeds.append(np.abs(arm_player.state()[7:]).max()))
    # The first torque acts in the step after the delay, and its speed is seen before the next one.
    yield f"{arm}: first motion with delay, steps", abs(int(np.argmax(np.array(speeds) > 1e-6)) - (wait + 1)), 0.0
