"""The MuJoCo model of a scene, and checks that it is what the scene says."""

import dataclasses
from collections.abc import Iterator
from typing import Any

import mujoco
import numpy as np

from lab.errors import InputError
from lab.mujoco.plans import FreeBody, Plan
from lab.mujoco.rotations import rotation_matrix

# Contacts: the default solref of 0.02 lets a peg sink in deeper than its clearance, this one by hundredths of a
# millimetre.
SOLREF = [0.004, 1.0]
SOLIMP = [0.95, 0.99, 0.0001, 0.5, 2.0]

# Largest product of time step and frequency (rad/s) of springs that is integrated faithfully.
LARGEST_PHASE = 0.2

# MuJoCo keeps vertices in single precision: they may be misplaced by this much (m).
PLACEMENT_TOLERANCE = 1e-6


@dataclasses.dataclass(frozen=True)
class Contact:
    """How parts touch and how finely time is resolved (s)."""

    friction: float
    time_step: float


def build(plan: Plan, contact: Contact) -> mujoco.MjModel:
    """The body as a free joint with its inertia at its centre of mass, the environment fixed, and every pair of parts
    able to touch: also those that the plan left out."""
    free_body = plan.free_body
    if free_body is None:
        raise InputError(
            f"{plan.folder}: no free body has the apparent inertia of an arm; play the whole arm with --arm"
        )
    check_time_step(plan, contact.time_step)
    spec = mujoco.MjSpec()
    set_options(spec.option, contact)
    # Without a position the orientation of the inertia is silently dropped.
    body = spec.worldbody.add_body(name="body", explicitinertial=True, mass=free_body.mass, ipos=free_body.center)
    body.fullinertia = free_body.inertia[[0, 1, 2, 0, 0, 1], [0, 1, 2, 1, 2, 2]]
    body.add_freejoint()
    add_parts(spec, body, plan, contact.friction)
    try:
        model = spec.compile()
    except ValueError as error:
        raise InputError(f"{plan.folder}: MuJoCo refuses the scene: {error}") from error
    check_inertia(model, free_body)
    check_parts(model, plan)
    return model


def check_time_step(plan: Plan, time_step: float) -> None:
    """Refuses a time step that is too long for the springs that move the body: those of the controller, or of the
    contacts of a robot that is commanded by position."""
    smallest = np.linalg.eigvalsh(plan.free_body.inertia).min()
    robot, stiffness = plan.position_robot, plan.impedance
    springs = (stiffness.translational_stiffness, stiffness.rotational_stiffness)
    if robot:
        springs = (robot.contact_stiffness, robot.contact_stiffness * robot.lever**2)
    for name, frequency in (
        ("k_r / I", np.sqrt(springs[1] / smallest)),
        ("k_t / m", np.sqrt(springs[0] / plan.free_body.mass)),
    ):
        if time_step * frequency >= LARGEST_PHASE:
            raise InputError(
                f"{plan.folder}: time step x sqrt({name}) = {time_step * frequency:.2f}, not below {LARGEST_PHASE}: "
                f"the simulation would diverge; use --time-step {LARGEST_PHASE / frequency / 2:.1g}"
            )


def set_options(option: mujoco.MjOption, contact: Contact) -> None:
    """Solver options."""
    option.timestep = contact.time_step
    option.gravity = [0.0, 0.0, 0.0]
    option.cone = mujoco.mjtCone.mjCONE_ELLIPTIC
    # A diverged run would restart, without its offset, and then succeed.
    # Several contacts per pair come with wrong normals where edges cross.
    option.disableflags = mujoco.mjtDisableBit.mjDSBL_AUTORESET | mujoco.mjtDisableBit.mjDSBL_MULTICCD


def add_parts(spec: mujoco.MjSpec, body: mujoco.MjsBody, plan: Plan, friction: float) -> None:
    """The parts of the body and of the environment, and all pairs of them."""
    for parent, parts, name in ((body, plan.body, "body"), (spec.worldbody, plan.environment, "environment")):
        for index, vertices in enumerate(parts):
            add_part(spec, parent, f"{name}{index}", vertices)
    for first in range(len(plan.body)):
        for second in range(len(plan.environment)):
            add_pair(spec, (f"body{first}", f"environment{second}"), friction)


def add_part(spec: mujoco.MjSpec, parent: mujoco.MjsBody, name: str, vertices: np.ndarray) -> None:
    """One convex part, which touches others only in explicit pairs."""
    spec.add_mesh(name=name, uservert=vertices.flatten(), inertia=mujoco.mjtMeshInertia.mjMESH_INERTIA_CONVEX)
    parent.add_geom(name=name, type=mujoco.mjtGeom.mjGEOM_MESH, meshname=name, contype=0, conaffinity=0)


def add_pair(spec: mujoco.MjSpec, names: tuple[str, str], friction: float) -> None:
    """Contact between two parts; Coulomb friction is isotropic."""
    pair = spec.add_pair(geomname1=names[0], geomname2=names[1], solref=SOLREF, solimp=SOLIMP, margin=0.0, gap=0.0)
    pair.condim = 3 if friction > 0 else 1
    pair.friction[:2] = friction


def check_inertia(model: mujoco.MjModel, free_body: FreeBody) -> None:
    """MuJoCo moves bodies to their principal axes: checks that the inertia is what it was."""
    body = model.body("body")
    rotation = rotation_matrix(body.iquat)
    inertia = rotation @ np.diag(body.inertia) @ rotation.T
    is_in_place = np.allclose(body.mass, free_body.mass) and np.allclose(body.ipos, free_body.center)
    assert is_in_place, "mass or its centre was changed"
    scale = free_body.inertia.max()
    assert np.allclose(inertia, free_body.inertia, atol=1e-9 * scale), "the inertia was changed"


def check_parts(model: mujoco.MjModel, plan: Plan) -> None:
    """MuJoCo moves meshes to their centres: checks that all corners are where they were."""
    for geom, vertices in geoms(model, plan):
        mesh = geom.dataid[0]
        start, count = model.mesh_vertadr[mesh], model.mesh_vertnum[mesh]
        placed = model.mesh_vert[start : start + count] @ rotation_matrix(geom.quat).T + geom.pos
        assert count == len(vertices), f"{geom.name} has lost corners"
        distance = np.abs(placed - vertices).max()
        assert distance < PLACEMENT_TOLERANCE, f"{geom.name} was moved by {distance} m"


def geoms(model: mujoco.MjModel, plan: Plan) -> Iterator[tuple[Any, np.ndarray]]:
    """All geoms with the corners they should have."""
    for name, parts in (("body", plan.body), ("environment", plan.environment)):
        for index, vertices in enumerate(parts):
            yield model.geom(f"{name}{index}"), vertices


def clearance(model: mujoco.MjModel, data: mujoco.MjData) -> float:
    """Smallest distance (m) of body and environment where they are."""
    pairs = zip(model.pair_geom1, model.pair_geom2)
    return min(mujoco.mj_geomDistance(model, data, first, second, 1.0, None) for first, second in pairs)
