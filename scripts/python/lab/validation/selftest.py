"""Checks of the validation against solutions that are known."""

import dataclasses
import functools
import math
import pathlib
import tempfile
from collections.abc import Iterator

import numpy as np

from lab.mujoco import shapes, world
from lab.mujoco.control import GraspError, displaced
from lab.mujoco.plans import FreeBody, Impedance, Plan, Reference, damping_matrix
from lab.mujoco.rollout import ContactRecord, FreePlayer
from lab.mujoco.rotations import rotation_vector, slerp
from lab.validation import arm_selftest, contact_cases, force_selftest, results
from lab.validation.offsets import cells
from lab.validation.rollouts import MUJOCO

TIME_STEP = 0.0005
# Steps over which forces are averaged.
FORCE_WINDOW = 80
MASS = 1.5
STIFFNESS = 60.0
BOX = [0.1, 0.08, 0.06]
IDENTITY = [1.0, 0.0, 0.0, 0.0]
NO_ERROR = GraspError(np.zeros(3), np.zeros(3))
# Turns (x, y, z) to (-y, -z, x).
TURNED = [0.5, 0.5, -0.5, 0.5]

# What is measured, its error and the largest tolerable one, in one unit.
Check = tuple[str, float, float]


def run(engine: str) -> bool:
    """Prints every check of an engine and returns whether all hold."""
    good = True
    own = MUJOCO_CHECKS if engine == MUJOCO else ()
    both = [functools.partial(module.checks, example(), engine) for module in (contact_cases, arm_selftest)]
    for check in (*both, *own):
        for name, error, tolerance in check():
            verdict = "ok" if error <= tolerance else "FAILED"
            good = good and error <= tolerance
            print(f"{verdict:6} {name}: error {error:.2e}, tolerance {tolerance:.0e}")
    return good


def example(**changes: object) -> Plan:
    """A box above a floor, at rest at the origin; its lower face is 30 mm below."""
    inertia = np.array([[0.12, 0.01, 0.0], [0.01, 0.1, 0.0], [0.0, 0.0, 0.08]])
    rest = np.array([0.0, 0.0, 0.0, *IDENTITY, *6 * [0.0]])
    floor = {"box": [2.0, 2.0, 0.1], "position": [0.0, 0.0, -5.0]}
    plan = Plan(
        folder=pathlib.Path("self-test"),
        title="self-test",
        start_name="1",
        status="done",
        body=[shapes.part_vertices({"box": BOX}, pathlib.Path())],
        environment=[shapes.part_vertices(floor, pathlib.Path())],
        free_body=FreeBody(MASS, np.zeros(3), inertia),
        impedance=Impedance(STIFFNESS, 6.0, damping_matrix(2 * math.sqrt(STIFFNESS * MASS)), damping_matrix(1.5)),
        start=rest[:7],
        goal=rest[:7],
        position_tolerance=0.003,
        angle_tolerance=0.1,
        delta=0.0,
        offsets=np.zeros((1, 3)),
        coverage="hull",
        insertion_axis=np.array([0.0, 0.0, 1.0]),
        turn=0.0,
        reference=Reference(np.array([0.0, 1.0]), np.array([rest, rest])),
    )
    return dataclasses.replace(plan, **changes)


def play(
    plan: Plan, grasp_error: GraspError, initial: np.ndarray, friction: float = 0.0
) -> tuple[np.ndarray, ContactRecord]:
    """Rows of time, pose and velocity of the plan's motion from an initial state, and its contacts."""
    model = world.build(plan, world.Contact(friction, TIME_STEP))
    rows: list[list[float]] = []
    player = FreePlayer(model, plan, FORCE_WINDOW)
    player.release(initial, grasp_error)
    record = player.play(
        plan.reference.sample(TIME_STEP, 1.0).tolist(), lambda: rows.append([player.data.time, *player.state()])
    )
    return np.array(rows), record


def trace(plan: Plan, grasp_error: GraspError, initial: np.ndarray) -> np.ndarray:
    """The rows alone, of a motion without contact."""
    return play(plan, grasp_error, initial)[0]


def oscillator(times: np.ndarray, start: float, frequency: float, ratio: float) -> np.ndarray:
    """A damped oscillator released at rest, `x'' = -2 ratio frequency x' - frequency^2 x`."""
    if ratio == 1:
        return start * (1 + frequency * times) * np.exp(-frequency * times)
    damped = frequency * math.sqrt(1 - ratio**2)
    decay = ratio * frequency
    return start * np.exp(-decay * times) * (np.cos(damped * times) + decay / damped * np.sin(damped * times))


def force_mode() -> Iterator[Check]:
    """Robots in force mode."""
    return force_selftest.checks(example)


def free_motion() -> Iterator[Check]:
    """Released beside a resting reference, the body oscillates along and about each axis."""
    inertia = np.diag([0.12, 0.1, 0.08])
    for ratio in (1.0, 0.3):
        damping = 2 * ratio * np.sqrt(6.0 * np.diag(inertia))
        impedance = Impedance(
            STIFFNESS, 6.0, damping_matrix(2 * ratio * math.sqrt(STIFFNESS * MASS)), damping_matrix(damping)
        )
        plan = example(free_body=FreeBody(MASS, np.zeros(3), inertia), impedance=impedance)
        initial = np.zeros(13)
        initial[:7] = 0.02, -0.01, 0.03, *IDENTITY
        rows = trace(plan, NO_ERROR, initial)
        exact = [oscillator(rows[:, 0], start, math.sqrt(STIFFNESS / MASS), ratio) for start in initial[:3]]
        yield f"free motion, damping ratio {ratio}, m", np.abs(rows[:, 1:4] - np.transpose(exact)).max(), 1e-4
        for axis in range(3):
            yield turning(plan, axis, ratio)


def turning(plan: Plan, axis: int, ratio: float) -> Check:
    """Small rotations about one body axis of a turned reference: the torque `k_r sin(angle)` is linear."""
    angle = 0.02
    state = np.array([0.0, 0.0, 0.0, *TURNED, *6 * [0.0]])
    reference = Reference(np.array([0.0, 1.0]), np.array([state, state]))
    initial = state.copy()
    unit = np.eye(3)[axis]
    initial[3:7] = turned_by(TURNED, angle * unit)
    rows = trace(dataclasses.replace(plan, reference=reference), NO_ERROR, initial)
    exact = oscillator(rows[:, 0], angle, math.sqrt(6.0 / plan.free_body.inertia[axis, axis]), ratio)
    turned = np.array([rotation_vector(np.array(TURNED), quaternion) for quaternion in rows[:, 4:8]])
    error = np.abs(turned - exact[:, None] * unit).max()
    return f"free rotation about {'xyz'[axis]}, damping ratio {ratio}, rad", error, 1e-4


def turned_by(quaternion: list[float], rotation: np.ndarray) -> np.ndarray:
    """A quaternion turned further by a rotation vector in its own frame."""
    w, vector = quaternion[0], np.array(quaternion[1:])
    angle = np.linalg.norm(rotation)
    cosine, sines = math.cos(angle / 2), math.sin(angle / 2) * rotation / angle
    return np.array([w * cosine - vector @ sines, *(w * sines + cosine * vector + np.cross(vector, sines))])


def offset_in_free_motion() -> Iterator[Check]:
    """A displaced body of a turned pose stays where it is: the controller believes it at the reference."""
    turned = np.array([0.1, -0.2, 0.3, *TURNED, *6 * [0.0]])
    reference = Reference(np.array([0.0, 1.0]), np.array([turned, turned]))
    offset = np.array([0.01, 0.02, -0.03])
    for turn in (np.zeros(3), np.array([0.2, -0.1, 0.3])):
        grasp_error = GraspError(offset, turn)
        initial = displaced(turned, grasp_error)
        rows = trace(example(reference=reference), grasp_error, initial)
        yield (
            f"offset in free motion, turn {np.linalg.norm(turn):.2f} rad, m",
            np.abs(rows[:, 1:] - initial).max(),
            1e-9,
        )
        believed = turned_by(initial[3:7].tolist(), turn) if turn.any() else initial[3:7]
        yield "where the turn puts the body", np.abs(believed - TURNED).max(), 1e-12
    initial = displaced(turned, GraspError(offset, np.zeros(3)))
    yield "where the offset puts the body, m", np.abs(initial[:3] - [0.12, -0.23, 0.29]).max(), 1e-12


def turn_in_free_motion() -> Iterator[Check]:
    """Of a body that is turned in the gripper, the believed frame turns as that of any other: about each of its axes,
    with the damping of that axis."""
    angle, damping = 0.02, np.array([0.5, 1.0, 1.4])
    impedance = Impedance(STIFFNESS, 6.0, damping_matrix(20.0), damping_matrix(damping.tolist()))
    plan = example(free_body=FreeBody(MASS, np.zeros(3), 0.1 * np.eye(3)), impedance=impedance)
    turn = np.array([0.4, -0.3, 0.5])
    for axis, unit in enumerate(np.eye(3)):
        believed = turned_by(IDENTITY, angle * unit).tolist()
        initial = np.array([0.0, 0.0, 0.0, *turned_by(believed, -turn), *6 * [0.0]])
        rows = trace(plan, GraspError(np.zeros(3), turn), initial)
        turned = np.array([rotation_vector(np.array(IDENTITY), turned_by(row.tolist(), turn)) for row in rows[:, 4:8]])
        frequency = math.sqrt(6.0 / 0.1)
        exact = oscillator(rows[:, 0], angle, frequency, damping[axis] / (0.2 * frequency))
        error = np.abs(turned - exact[:, None] * unit).max()
        yield f"turn of the believed frame about {'xyz'[axis]}, rad", error, 1e-4


def free_spin() -> Iterator[Check]:
    """Without torque the angular velocity in the body frame is constant in the plan's model, not in nature."""
    initial = np.array([0.0, 0.0, 0.0, *IDENTITY, 0.0, 0.0, 0.0, 1.0, 2.0, -1.5])
    rows = trace(
        example(impedance=Impedance(STIFFNESS, 0.0, damping_matrix(1.0), damping_matrix(0.0))), NO_ERROR, initial
    )
    yield "free spin without gyroscopic term, rad/s", np.abs(rows[:, 11:] - initial[10:]).max(), 1e-3


def even_turn() -> Iterator[Check]:
    """A reference that turns evenly is followed without lag, because the controller knows its velocity."""
    axis, duration = np.array([2.0, -1.0, 2.0]) / 3, 3.0
    states = np.zeros((2, 13))
    states[:, 3:7] = TURNED
    states[1, 3:7] = turned_by(TURNED, 0.5 * duration * axis)
    states[:, 10:] = 0.5 * axis
    plan = example(reference=Reference(np.array([0.0, duration]), states))
    rows = trace(plan, NO_ERROR, np.array([0.0, 0.0, 0.0, *TURNED, *6 * [0.0]]))
    late = rows[(rows[:, 0] > 0.8 * duration) & (rows[:, 0] < duration)]
    turned = np.array([rotation_vector(np.array(TURNED), quaternion) for quaternion in late[:, 4:8]])
    yield "even turn, rad", np.abs(turned - 0.5 * late[:, :1] * axis).max(), 1e-4


def sliding() -> Iterator[Check]:
    """A box pushed into a floor and along it lags behind by friction times depth, and rests on the floor."""
    depth, speed, duration = 0.02, 0.03, 3.0
    height = BOX[2] / 2
    start = np.array([0.0, 0.0, -depth, *IDENTITY])
    states = np.zeros((2, 13))
    states[:, :7] = start
    states[1, 0] = speed * duration
    states[:, 7] = speed
    floor = {"box": [2.0, 2.0, 0.1], "position": [0.0, 0.0, -height - 0.05]}
    plan = example(
        environment=[shapes.part_vertices(floor, pathlib.Path())],
        reference=Reference(np.array([0.0, duration]), states),
    )
    initial = np.zeros(13)
    initial[:7] = 0.0, 0.0, 0.0, *IDENTITY
    for friction in (0.0, 0.3):
        rows, record = play(plan, NO_ERROR, initial, friction)
        late = rows[(rows[:, 0] > 0.8 * duration) & (rows[:, 0] < duration)]
        # Friction makes the box lean as it starts, so that the largest force is not the steady one.
        if not friction:
            # Contact is soft: as the box settles, the largest mean is a little above the steady force.
            yield "sliding without friction, force, N", abs(record.force - STIFFNESS * depth), 2e-2
        lag = speed * late[:, 0] - late[:, 1]
        yield f"sliding with friction {friction}, lag, m", np.abs(lag - friction * depth).max(), 1e-4
        yield f"sliding with friction {friction}, height, m", np.abs(late[:, 3]).max(), 2e-5
        yield f"sliding with friction {friction}, tilt, rad", 2 * np.linalg.norm(late[:, 5:8], axis=1).max(), 1e-2


def shape_forms() -> Iterator[Check]:
    """The four ways to write a part give the same corners."""
    pose = {"position": [0.3, -0.1, 0.2], "orientation": TURNED}
    corners = shapes.part_vertices({"box": BOX}, pathlib.Path())
    # Three more planes than needed: one beyond a corner, one beyond a face, one given twice.
    normals = np.vstack([np.eye(3), -np.eye(3), [[1.0, 1.0, 1.0]], np.eye(3)[:2]])
    halfspaces = {"normals": normals, "offsets": [*2 * [edge / 2 for edge in BOX], 1.0, 1.0, BOX[1] / 2]}
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        lines = [f"vertex {1e3 * x!r} {1e3 * y!r} {1e3 * z!r}" for x, y, z in corners.tolist()]
        (folder / "box.stl").write_text("solid box\n" + "\n".join(lines) + "\nendsolid box\n")
        (folder / "binary.stl").write_bytes(binary_stl(1e3 * corners))
        forms = {
            "vertices": {"vertices": corners},
            "halfspaces, three redundant": halfspaces,
            "text STL": {"mesh": "box.stl", "unit": "mm"},
            "binary STL": {"mesh": "binary.stl", "unit": "mm"},
        }
        expected = shapes.part_vertices({"box": BOX, **pose}, folder)
        for form, part in forms.items():
            actual = shapes.part_vertices({**part, **pose}, folder)
            distances = np.linalg.norm(expected[:, None] - actual[None], axis=2)
            error = max(distances.min(axis=0).max(), distances.min(axis=1).max())
            yield f"corners of a box from {form}, m", error, 1e-8


def binary_stl(corners: np.ndarray) -> bytes:
    """A file of three triangles that have the eight corners of a box; like some programs' it begins as text does."""
    triangles = corners[[0, 1, 2, 3, 4, 5, 5, 6, 7]].reshape(3, 9)
    body = b"".join(np.append(np.zeros(3), triangle).astype("<f4").tobytes() + b"\0\0" for triangle in triangles)
    return b"solid" + bytes(75) + len(triangles).to_bytes(4, "little") + body


def interpolation() -> Iterator[Check]:
    """Slerp turns evenly, and the rotation vector is its angle."""
    start, angle = np.array(IDENTITY), 0.8
    axis = np.array([2.0, -1.0, 2.0]) / 3
    end = np.array([math.cos(angle / 2), *(math.sin(angle / 2) * axis)])
    yield "rotation vector, rad", np.abs(rotation_vector(start, -end) - angle * axis).max(), 1e-12
    shares = np.linspace(0.0, 1.0, 11)
    turned = slerp(np.tile(start, (11, 1)), np.tile(-end, (11, 1)), shares)
    exact = np.column_stack([np.cos(shares * angle / 2), np.sin(shares * angle / 2)[:, None] * axis])
    yield "slerp", np.abs(turned - exact).max(), 1e-12


def statistics() -> Iterator[Check]:
    """Intervals of the literature, and random offsets of what a plan covers."""
    for successes, count, low, high in ((0, 10, 0.0, 0.277533), (24, 30, 0.626947, 0.904952), (90, 90, 0.959064, 1.0)):
        error = np.abs(np.subtract(results.wilson(successes, count), (low, high))).max()
        yield f"interval of {successes} in {count}", error, 1e-4
    # The hull of these is a triangle: x, y >= 0 and x + y <= delta-hat.
    planned = 0.02 * np.array([[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]])
    for cell in cells(example(offsets=planned, delta=0.02), "random", "0.5,-1mm,5mm", 100, 1):
        size = {"50 %": 0.01, "delta - 1 mm": 0.019, "5 mm": 0.005}[cell.label]
        outside = max(0.0, -cell.offsets.min(), cell.offsets.sum(axis=1).max() - size)
        yield f"random offsets outside the hull, {cell.label}, m", outside, 1e-12
    axis = np.array([0.6, 0.0, 0.8])
    for coverage, dimension in (("disc", 2), ("ball", 3)):
        plan = example(delta=0.02, coverage=coverage, insertion_axis=axis)
        inside, rim = cells(plan, "random", None, 2001, 1)
        yield f"random offsets of a {coverage} on its rim", abs(len(rim.offsets) - 1001), 0.5
        lengths = [np.linalg.norm(cell.offsets, axis=1) / plan.delta for cell in (inside, rim)]
        yield f"rim of a {coverage}", np.abs(lengths[1] - 1.0).max(), 1e-12
        yield f"random offsets outside a {coverage}", max(0.0, lengths[0].max() - 1.0), 1e-12
        # Uniform: half of the points lie within this share of the radius.
        yield f"share near the centre of a {coverage}", abs(np.mean(lengths[0] < 0.5 ** (1 / dimension)) - 0.5), 0.04
        along = max(np.abs(cell.offsets @ axis).max() for cell in (inside, rim))
        yield f"offsets of a {coverage} along the insertion, m", abs(along - (0.0 if dimension == 2 else 0.02)), 1e-3


MUJOCO_CHECKS = (
    free_motion,
    offset_in_free_motion,
    turn_in_free_motion,
    free_spin,
    even_turn,
    sliding,
    shape_forms,
    interpolation,
    statistics,
    force_mode,
)
