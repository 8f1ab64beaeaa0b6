"""Contacts with friction whose limits are known in closed form, in any engine."""

import dataclasses
import math
import pathlib
from collections.abc import Iterator

import numpy as np

from lab.mujoco.control import GraspError
from lab.mujoco.plans import FreeBody, Plan
from lab.mujoco.shapes import part_vertices
from lab.validation.rollouts import Rollouts, Settings

# What is measured, its error and the largest tolerable one, in one unit.
Check = tuple[str, float, float]

TIME_STEP = 0.00025
FRICTION = 0.3
MASS = 1.0
EDGE = 0.04
IDENTITY = [1.0, 0.0, 0.0, 0.0]
# A load is this much below and above the one at which the body begins to slide.
MARGIN = 0.1
# Speed (m/s) after a second below which a body has stuck; contacts that hold by a regularised law creep.
CREEP = 2e-3


def checks(example: Plan, engine: str) -> Iterator[Check]:
    """All cases; `example` gives what does not matter."""
    yield from slope(example, engine)
    yield from wedge(example, engine)
    yield from jamming(example, engine)


def player(example: Plan, engine: str, body: list[np.ndarray], environment: list[np.ndarray]) -> object:
    """A body of 1 kg among some shapes."""
    moments = MASS * EDGE**2 / 6 * np.eye(3)
    # The controller is not used: it would only limit the time step.
    gains = dataclasses.replace(example.impedance, translational_stiffness=1.0, rotational_stiffness=1e-4)
    plan = dataclasses.replace(
        example, body=body, environment=environment, free_body=FreeBody(MASS, np.zeros(3), moments), impedance=gains
    )
    return Rollouts(plan, Settings(TIME_STEP, 1.0, engine)).player(FRICTION)


def box(edges: list[float], position: list[float], orientation: list[float] = IDENTITY) -> np.ndarray:
    """Corners of a box."""
    return part_vertices({"box": edges, "position": position, "orientation": orientation}, pathlib.Path())


def pushed(player: object, force: list[float], torque: list[float], duration: float) -> np.ndarray:
    """State of a body that was at rest at the origin, after a constant wrench."""
    player.release(np.array([0.0, 0.0, 0.0, *IDENTITY, *6 * [0.0]]), GraspError(np.zeros(3), np.zeros(3)))
    for _ in range(round(duration / TIME_STEP)):
        player.push((*force, *torque))
    return np.array(player.state())


def feet() -> list[np.ndarray]:
    """A body that stands on four points: engines find one point for each pair of pieces, which is no face."""
    half, top = EDGE / 2, 0.0
    corners = [(x, y) for x in (-half, half) for y in (-half, half)]
    return [
        np.array(
            [[x, y, -half], *([x + dx, y + dy, top] for dx, dy in ((0.005, 0.0), (-0.005, 0.005), (-0.005, -0.005)))]
        )
        for x, y in corners
    ]


def slope(example: Plan, engine: str) -> Iterator[Check]:
    """A block on a slope sticks below the angle of friction, and slides with `g (sin - mu cos)` above it."""
    floor = [box([2.0, 2.0, 0.1], [0.0, 0.0, -0.05 - EDGE / 2])]
    block = player(example, engine, feet(), floor)
    for share in (1 - MARGIN, 1 + MARGIN):
        angle = math.atan(share * FRICTION)
        weight = 9.81 * MASS
        state = pushed(block, [weight * math.sin(angle), 0.0, -weight * math.cos(angle)], [0.0, 0.0, 0.0], 1.0)
        speed = 9.81 * max(0.0, math.sin(angle) - FRICTION * math.cos(angle))
        yield (
            f"block on a slope, tangent {share:g} times the friction, m/s",
            abs(state[7] - speed),
            0.02 * speed + CREEP,
        )


def wedge(example: Plan, engine: str) -> Iterator[Check]:
    """A block that is pushed level against a slope goes up it if slope and friction angle are together below a right
    angle, and otherwise locks whatever the force. Seen along the slope, the force comes from above at its angle."""
    floor = [box([2.0, 2.0, 0.1], [0.0, 0.0, -0.05 - EDGE / 2])]
    block = player(example, engine, feet(), floor)
    locking = math.pi / 2 - math.atan(FRICTION)
    for angle, locks in ((locking - 0.03, False), (locking + 0.03, True)):
        for force in (10.0, 100.0):
            along, onto = force * math.cos(angle), force * math.sin(angle)
            state = pushed(block, [along, 0.0, -onto], [0.0, 0.0, 0.0], 0.5)
            speed = 0.0 if locks else 0.5 * (along - FRICTION * onto) / MASS
            name = "locks" if locks else "slides"
            yield f"wedge of {angle:.2f} rad at {force:g} N {name}, m/s", abs(state[7] - speed), 0.02 * speed + CREEP


def jamming(example: Plan, engine: str) -> Iterator[Check]:
    """A peg that a torque presses against a hole at two points, a length apart, jams unless the force along it
    exceeds `2 mu torque / length`."""
    # The hole is deeper than the peg goes; the peg is so wide that it touches with little tilt.
    clearance, length, depth = 2e-5, 0.03, 0.1
    # Two slices: one would turn about the line through its two points.
    peg = [box([EDGE, 1e-3, 2 * length], [0.0, side * EDGE / 2, length]) for side in (-1.0, 1.0)]
    width = EDGE + clearance
    walls = [box([0.05, 0.2, depth], [side * (width / 2 + 0.025), 0.0, length - depth / 2]) for side in (-1.0, 1.0)]
    body = player(example, engine, peg, walls)
    torque = 0.3
    limit = 2 * FRICTION * torque / length
    for share in (1 - MARGIN, 1 + MARGIN):
        state = pushed(body, [0.0, 0.0, -share * limit], [0.0, torque, 0.0], 0.1)
        # Deeper, the points are farther apart and the peg accelerates: only the beginning is known.
        slides = state[2] < -2e-4
        yield f"peg at {share:g} times the force of jamming, {1e3 * state[2]:.3f} mm", float(slides != (share > 1)), 0.5
