"""Checks of force mode in MuJoCo against solutions that are known."""

import math
from collections.abc import Callable, Iterator
from pathlib import Path

import numpy as np

from lab.mujoco import robots, shapes, world
from lab.mujoco.control import GraspError
from lab.mujoco.force_robot import ForceArmPlayer, ForcePlayer
from lab.mujoco.plans import FreeBody, Plan, PositionRobot
from lab.paths import ARMS

TIME_STEP = 0.0005
STIFFNESS, DAMPING, CONTACT_STIFFNESS = 1500.0, 300.0, 1e4
# Of the box above the floor (m), and how far the reference lies below its start.
GAP, DEPTH = 0.002, 0.01
# A fast robot, as the solutions know no lag.
ROBOT = PositionRobot(
    period=0.001,
    delay=TIME_STEP,
    bandwidth=100.0,
    cutoff=200.0,
    mass=(0.3, 0.04),
    damping=(DAMPING, 40.0),
    stiffness=(STIFFNESS, 200.0),
    contact_stiffness=CONTACT_STIFFNESS,
    lever=0.05,
    is_force_mode=True,
)
Check = tuple[str, float, float]


def checks(example: Callable[..., Plan]) -> Iterator[Check]:
    """A flange and an arm in force mode go to a reference in the time of damping and stiffness, and press on a floor
    with the force of the spring."""
    size, body = [0.06, 0.06, 0.06], FreeBody(1.0, np.zeros(3), 2.5e-3 * np.eye(3))
    floor = {"box": [0.5, 0.5, 0.1], "position": [0.0, 0.0, -0.08 - GAP]}
    for name, kind, robot in (
        ("a flange", ForcePlayer, None),
        ("an arm", ForceArmPlayer, robots.read(ARMS / "six.toml")),
    ):
        plan = example(
            body=[shapes.part_vertices({"box": size}, Path())],
            environment=[shapes.part_vertices(floor, Path())],
            free_body=body,
            position_robot=ROBOT,
            robot=robot,
        )
        player = kind(world.build(plan, world.Contact(0.0, TIME_STEP)), plan, 1)
        for motion, depth, expected in (
            ("rises", DEPTH, DEPTH * (1 - math.exp(-STIFFNESS / DAMPING * 0.2))),
            ("sinks on a floor", -DEPTH, -GAP),
        ):
            player.begin([plan.reference.states[0].tolist()], GraspError(np.zeros(3), np.zeros(3)))
            goal = plan.reference.states[0] + np.array([0.0, 0.0, depth, *10 * [0.0]])
            player.play([goal.tolist()] * round(0.2 / TIME_STEP if depth > 0 else 2.0 / TIME_STEP))
            yield f"{name} in force mode {motion}, m", abs(player.state()[2] - expected), 4e-4
        force = STIFFNESS * (DEPTH - GAP) / (1 + STIFFNESS / CONTACT_STIFFNESS)
        yield f"{name} in force mode presses on a floor, N", abs(player.wrench[0][2] - force), 0.2
