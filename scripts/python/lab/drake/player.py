"""A free body in Drake: discrete steps, contact solved as a convex program (SAP) between points of convex pieces."""

import collections

import numpy as np
from pydrake.geometry import AddContactMaterial, Convex, ProximityProperties
from pydrake.math import RigidTransform, RotationMatrix
from pydrake.multibody.math import SpatialForce, SpatialVelocity
from pydrake.multibody.plant import (
    AddMultibodyPlant,
    CoulombFriction,
    ExternallyAppliedSpatialForce,
    MultibodyPlant,
    MultibodyPlantConfig,
)
from pydrake.multibody.tree import RotationalInertia, SpatialInertia
from pydrake.systems.analysis import Simulator
from pydrake.systems.framework import DiagramBuilder

from lab.errors import InputError
from lab.mujoco.control import FreeControl, GraspError, State, displaced
from lab.mujoco.plans import Plan
from lab.mujoco.rollout import Outcome, final_errors
from lab.mujoco.rotations import rotation_matrix
from lab.mujoco.world import Contact, check_time_step

# Time (s) in which a contact stops to yield.
RELAXATION = 1e-4
# Time (s) between looks at the contacts.
LOOK = 1e-3


class DrakePlayer:
    """Plays motions of a free body. Forces are means over `window` looks."""

    def __init__(self, plan: Plan, contact: Contact, stiffness: float, window_time: float) -> None:
        if plan.free_body is None:
            raise InputError(
                f"{plan.folder}: no free body has the apparent inertia of an arm; play it in MuJoCo, --arm"
            )
        if plan.position_robot:
            raise InputError(f"{plan.folder}: Drake has no robot that is commanded by position; use --engine mujoco")
        check_time_step(plan, contact.time_step)
        self.plan, self.time_step = plan, contact.time_step
        self.control = FreeControl(plan)
        self.stride = max(1, round(LOOK / contact.time_step))
        self.window = max(1, round(window_time / (self.stride * contact.time_step)))
        builder = DiagramBuilder()
        config = MultibodyPlantConfig(time_step=contact.time_step, discrete_contact_approximation="sap")
        self.plant, _ = AddMultibodyPlant(config, builder)
        self.plant.mutable_gravity_field().set_gravity_vector(np.zeros(3))
        self.body = self.plant.AddRigidBody("body", inertia(plan))
        properties = material(contact.friction, stiffness)
        for body, parts, name in (
            (self.body, plan.body, "body"),
            (self.plant.world_body(), plan.environment, "environment"),
        ):
            for index, vertices in enumerate(parts):
                add_part(self.plant, body, f"{name}{index}", vertices, properties)
        self.plant.Finalize()
        self.simulator = Simulator(builder.Build())
        self.context = self.plant.GetMyMutableContextFromRoot(self.simulator.get_mutable_context())
        self.applied = ExternallyAppliedSpatialForce()
        self.applied.body_index = self.body.index()
        self.applied.p_BoBq_B = np.zeros(3)
        self.port = self.plant.get_applied_spatial_force_input_port().FixValue(self.context, [self.applied])

    def release(self, initial: np.ndarray, grasp_error: GraspError) -> None:
        """Puts the body into a state (13 numbers) with an error in the gripper."""
        self.simulator.get_mutable_context().SetTime(0.0)
        rotation = RotationMatrix(rotation_matrix(initial[3:7]))
        self.plant.SetFreeBodyPose(self.context, self.body, RigidTransform(rotation, initial[:3]))
        velocity = SpatialVelocity(rotation.multiply(initial[10:]), initial[7:10])
        self.plant.SetFreeBodySpatialVelocity(self.context, self.body, velocity)
        self.simulator.Initialize()
        self.steps = 0
        self.control.hold(grasp_error)

    def push(self, wrench: tuple[float, ...]) -> None:
        """One step under a force (N, world) and a torque about the origin of the body (Nm, body)."""
        rotation = self.plant.EvalBodyPoseInWorld(self.context, self.body).rotation()
        self.applied.F_Bq_W = SpatialForce(rotation.multiply(np.array(wrench[3:])), np.array(wrench[:3]))
        self.port.GetMutableData().set_value([self.applied])
        self.steps += 1
        self.simulator.AdvanceTo(self.steps * self.time_step)

    def state(self) -> State:
        """Pose and velocity of the body (13 numbers, as in `reference.csv`)."""
        positions = self.plant.GetPositions(self.context)
        velocities = self.plant.GetVelocities(self.context)
        turning = rotation_matrix(positions[:4]).T @ velocities[:3]
        return [*positions[4:], *positions[:4], *velocities[3:], *turning]

    def outcome(self, samples: list[State], grasp_error: GraspError) -> Outcome:
        """Plays a motion from rest and measures where it ends."""
        self.release(displaced(np.array(samples[0]), grasp_error), grasp_error)
        overlap, force, looks = 0.0, 0.0, collections.deque(maxlen=self.window)
        try:
            for step, reference in enumerate(samples):
                state = self.state()
                self.push(self.control.wrench(reference, state[:7], state[7:]))
                if step % self.stride == 0:
                    deepest, forces = self.contacts()
                    overlap = max(overlap, deepest)
                    looks.append(forces)
                    sums = sum(looks, collections.Counter())
                    force = max(force, max(sums.values(), default=0.0) / self.window)
        except RuntimeError:
            # The solver found no contact forces.
            return Outcome(np.inf, np.inf, overlap, force, warned=True)
        position, angle = final_errors(self.state(), self.plan.goal)
        return Outcome(position, angle, overlap, force, warned=not np.isfinite(position))

    def contacts(self) -> tuple[float, collections.Counter]:
        """Deepest overlap (m), and normal force (N) of every pair that touches."""
        results = self.plant.get_contact_results_output_port().Eval(self.context)
        deepest, forces = 0.0, collections.Counter()
        for index in range(results.num_point_pair_contacts()):
            info = results.point_pair_contact_info(index)
            pair = info.point_pair()
            deepest = max(deepest, pair.depth)
            forces[(pair.id_A.get_value(), pair.id_B.get_value())] += abs(float(info.contact_force() @ pair.nhat_BA_W))
        return deepest, forces


def inertia(plan: Plan) -> SpatialInertia:
    """Of the body, about its origin."""
    free = plan.free_body
    (xx, xy, xz), (_, yy, yz), (_, _, zz) = free.inertia.tolist()
    try:
        rotational = RotationalInertia(xx, yy, zz, xy, xz, yz)
        return SpatialInertia.MakeFromCentralInertia(free.mass, free.center, rotational)
    except RuntimeError as error:
        raise InputError(f"{plan.folder}: Drake refuses the inertia of the body: {error}") from error


def material(friction: float, stiffness: float) -> ProximityProperties:
    """Friction and stiffness of all pieces: two equal ones in a row yield twice as much as one."""
    properties = ProximityProperties()
    coulomb = CoulombFriction(friction, friction)
    AddContactMaterial(properties=properties, point_stiffness=2 * stiffness, friction=coulomb)
    properties.AddProperty("material", "relaxation_time", RELAXATION / 2)
    return properties


def add_part(
    plant: MultibodyPlant, body: object, name: str, vertices: np.ndarray, properties: ProximityProperties
) -> None:
    """One convex piece."""
    shape = Convex(points=vertices.T, label=name)
    plant.RegisterCollisionGeometry(body, RigidTransform(), shape, name, properties)
