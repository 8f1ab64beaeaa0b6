"""Exported models, read by the libraries that know them."""

import dataclasses
import pathlib
import subprocess
import tempfile
from collections.abc import Iterator

import mujoco
import numpy as np
from pxr import Usd, UsdGeom, UsdPhysics
from pydrake.multibody.parsing import Parser
from pydrake.multibody.plant import AddMultibodyPlantSceneGraph
from pydrake.systems.framework import DiagramBuilder

from lab.mujoco import plans, robots
from lab.mujoco.control import GraspError
from lab.mujoco.plans import Plan
from lab.mujoco.robots import Robot
from lab.mujoco.rotations import rotation_matrix
from lab.validation.rollouts import MUJOCO, PLANNED, Rollouts, Settings

# What is measured, its error and the largest tolerable one, in one unit.
Check = tuple[str, float, float]

# MuJoCo keeps vertices in single precision, and so does OpenUSD (m).
PLACEMENT = 2e-7
# Largest differences (m, rad) of the ends of one motion with two controllers.
SAME_END, SAME_ANGLE = 1e-4, 1e-3
TIME_STEP = 5e-4


def check(program: pathlib.Path, folder: pathlib.Path) -> bool:
    """Prints every check of a plan and returns whether all hold."""
    plan, good = plans.load(folder, None), True
    with tempfile.TemporaryDirectory() as out:
        for target, checks in (("mjcf", mjcf), ("sdf", sdf), ("usd", usd)):
            written = pathlib.Path(out) / target
            subprocess.run(
                [program, "export", folder, "--to", target, "--out", written], check=True, capture_output=True
            )
            for name, error, tolerance in checks(plan, written):
                good = good and error <= tolerance
                verdict = "ok" if error <= tolerance else "FAILED"
                print(f"{verdict:6} {folder.name}, {target}: {name}: error {error:.2e}, tolerance {tolerance:.0e}")
    return good


def mjcf(plan: Plan, folder: pathlib.Path) -> Iterator[Check]:
    """The model in MuJoCo: where everything is, and where it ends."""
    model = mujoco.MjModel.from_xml_path(str(folder / "plan.xml"))
    data = mujoco.MjData(model)
    mujoco.mj_forward(model, data)
    part, aim = data.site("part"), data.site("reference/pose")
    turned, shift = part.xmat.reshape(3, 3).copy(), part.xpos.copy()
    named = [geom for geom in range(model.ngeom) if model.geom(geom).name]
    bodies = [geom for geom in named if model.geom(geom).name.startswith("body/")]
    walls = [geom for geom in named if geom not in bodies]
    of_part = [(corners(model, data, geom) - shift) @ turned for geom in bodies]
    yield "corners of the part, m", apart(of_part, plan.body), PLACEMENT
    yield (
        "corners of the environment, m",
        apart([corners(model, data, geom) for geom in walls], plan.environment),
        PLACEMENT,
    )
    yield "start of the part, m", np.abs(part.xpos - plan.start[:3]).max(), 1e-6
    yield "start of the reference, m", np.abs(aim.xpos - plan.start[:3]).max(), 1e-6
    if plan.free_body is not None:
        yield "mass, kg", abs(model.body("body").mass[0] - plan.free_body.mass), 1e-9
    else:
        friction = model.dof_frictionloss[model.dof_frictionloss > 0]
        robot = robots.read(plan.folder / "resolved.toml")
        yield (
            "joint friction, Nm",
            np.abs(np.sort(friction) - np.sort(robot.joint_friction[robot.joint_friction > 0])).max(),
            0.0,
        )
        model.dof_frictionloss[:] = 0.0
    samples = plan.reference.sample(model.opt.timestep, 1.0)
    lag = 0.0
    for sample in samples:
        lag = max(lag, float(np.abs(aim.xpos - sample[:3]).max()))
        mujoco.mj_step(model, data)
    yield "largest lag of the reference, m", lag, 2e-4
    yield "end of the reference, m", np.abs(aim.xpos - samples[-1, :3]).max(), 1e-6
    yield "angle of the reference at its end, rad", angle(aim.xmat.reshape(3, 3), samples[-1, 3:7]), 1e-4
    known = np.array(end(plan, float(model.geom_friction[:, 0].max()) if (model.geom_condim > 1).any() else 0.0))
    yield "distance of the part from where `validate` brings it, m", np.linalg.norm(part.xpos - known[:3]), SAME_END
    yield "angle between both, rad", angle(part.xmat.reshape(3, 3), known[3:7]), SAME_ANGLE
    yield "warnings", float(data.warning.number.sum()), 0.0


def without_friction(robot: Robot) -> Robot:
    """Joint friction holds an arm anywhere within its deadband: only without it the end is that of the controller."""
    return dataclasses.replace(robot, joint_friction=np.zeros_like(robot.joint_friction))


def end(plan: Plan, friction: float) -> list[float]:
    """Where a motion without errors ends in the simulation of `validate`, whose model and controller are others."""
    if plan.free_body is None:
        plan = dataclasses.replace(plan, robot=without_friction(robots.read(plan.folder / "resolved.toml")))
    rollouts = Rollouts(plan, Settings(TIME_STEP, 1.0, MUJOCO))
    rollouts.play(PLANNED, friction, GraspError(np.zeros(3), np.zeros(3)))
    return rollouts.player(friction).state()


def sdf(plan: Plan, folder: pathlib.Path) -> Iterator[Check]:
    """The model in Drake."""
    builder = DiagramBuilder()
    plant, _ = AddMultibodyPlantSceneGraph(builder, 1e-3)
    Parser(plant).AddModels(str(folder / "plan.sdf"))
    plant.Finalize()
    count = len(plan.body) + len(plan.environment)
    yield "pieces", abs(plant.num_collision_geometries() - count), 0.0
    meshes = {
        name: [vertices(folder / f"{name}_{index}.obj") for index in range(len(parts))]
        for name, parts in (("body", plan.body), ("environment", plan.environment))
    }
    yield "corners of the part, m", apart(meshes["body"], plan.body), 1e-12
    yield "corners of the environment, m", apart(meshes["environment"], plan.environment), 1e-12
    if plan.free_body is not None:
        context = plant.CreateDefaultContext()
        body = plant.GetBodyByName("body")
        yield "mass, kg", abs(body.default_mass() - plan.free_body.mass), 1e-12
        moments = (
            body.default_spatial_inertia().Shift(plan.free_body.center).CalcRotationalInertia().CopyToFullMatrix3()
        )
        yield "moments of inertia, kg m^2", np.abs(moments - plan.free_body.inertia).max(), 1e-12
        yield "start, m", np.abs(plant.GetFreeBodyPose(context, body).translation() - plan.start[:3]).max(), 1e-12


def usd(plan: Plan, folder: pathlib.Path) -> Iterator[Check]:
    """The model in OpenUSD."""
    stage = Usd.Stage.Open(str(folder / "plan.usda"))
    prims = [prim for prim in stage.Traverse() if prim.HasAPI(UsdPhysics.CollisionAPI)]
    for name, parts in (("body", plan.body), ("environment", plan.environment)):
        meshes = [UsdGeom.Mesh(prim) for prim in prims if prim.GetName().startswith(f"{name}_")]
        own = [np.array(mesh.GetPointsAttr().Get(), dtype=float) for mesh in meshes]
        yield f"corners, {name}, m", apart(own, parts), PLACEMENT if plan.free_body is not None else 1e-6
        faces = [
            UsdGeom.Mesh.ValidateTopology(m.GetFaceVertexIndicesAttr().Get(), m.GetFaceVertexCountsAttr().Get(), len(p))
            for m, p in zip(meshes, own)
        ]
        yield f"faces, {name}", float(not all(valid for valid, _ in faces)), 0.0
    holders = [prim for prim in stage.Traverse() if prim.HasAPI(UsdPhysics.RigidBodyAPI)]
    place = UsdGeom.XformCache().GetLocalToWorldTransform(prims[-1] if plan.free_body is None else holders[0])
    yield "start, m", np.abs(np.array(place.ExtractTranslation()) - plan.start[:3]).max(), 1e-6
    if plan.free_body is not None:
        mass = UsdPhysics.MassAPI(holders[0])
        yield "mass, kg", abs(mass.GetMassAttr().Get() - plan.free_body.mass), 1e-6
        quaternion = mass.GetPrincipalAxesAttr().Get()
        axes = rotation_matrix(np.array([quaternion.real, *quaternion.imaginary]))
        moments = axes @ np.diag(mass.GetDiagonalInertiaAttr().Get()) @ axes.T
        scale = plan.free_body.inertia.max()
        yield "moments of inertia, relative", np.abs(moments - plan.free_body.inertia).max() / scale, 1e-6


def corners(model: mujoco.MjModel, data: mujoco.MjData, geom: int) -> np.ndarray:
    """Corners of a geom in the world (m)."""
    mesh = model.geom_dataid[geom]
    start, count = model.mesh_vertadr[mesh], model.mesh_vertnum[mesh]
    return model.mesh_vert[start : start + count] @ data.geom_xmat[geom].reshape(3, 3).T + data.geom_xpos[geom]


def vertices(file: pathlib.Path) -> np.ndarray:
    """Corners in an OBJ file."""
    lines = [line.split() for line in file.read_text().splitlines()]
    return np.array([[float(value) for value in line[1:]] for line in lines if line[0] == "v"])


def apart(own: list[np.ndarray], parts: list[np.ndarray]) -> float:
    """Largest distance of the corners of pieces from the nearest ones of the same piece of a plan, and back (m)."""
    if len(own) != len(parts):
        return np.inf
    largest = 0.0
    for first, second in zip(own, parts):
        distances = np.linalg.norm(first[:, None] - second[None], axis=2)
        largest = max(largest, distances.min(axis=0).max(), distances.min(axis=1).max())
    return float(largest)


def angle(rotation: np.ndarray, quaternion: np.ndarray) -> float:
    """Angle (rad) between a rotation matrix and a quaternion."""
    between = rotation.T @ rotation_matrix(quaternion)
    vector = np.array([between[2, 1] - between[1, 2], between[0, 2] - between[2, 0], between[1, 0] - between[0, 1]])
    return float(np.arctan2(np.linalg.norm(vector), np.trace(between) - 1))
