"""A free body in Drake."""

import numpy as np
from pydrake.math import RigidTransform, RotationMatrix
from pydrake.multibody.math import SpatialForce, SpatialVelocity
from pydrake.multibody.plant import ExternallyAppliedSpatialForce
from pydrake.multibody.tree import RigidBody, RotationalInertia, SpatialInertia

from lab.drake.contact import Compliance
from lab.drake.player import DrakePlayer
from lab.errors import InputError
from lab.mujoco.control import FreeControl, GraspError, State, displaced
from lab.mujoco.plans import Plan
from lab.mujoco.rotations import rotation_matrix
from lab.mujoco.world import Contact, check_time_step


class FreePlayer(DrakePlayer):
    """A free body driven by the impedance wrench alone."""

    def __init__(self, plan: Plan, contact: Contact, compliance: Compliance, window_time: float) -> None:
        if plan.free_body is None:
            raise InputError(f"{plan.folder}: no free body has the apparent inertia of an arm; play it with --arm")
        check_time_step(plan, contact.time_step)
        super().__init__(plan, contact, compliance, window_time)
        self.control = FreeControl(plan)
        self.applied = ExternallyAppliedSpatialForce()
        self.applied.body_index = self.body.index()
        self.applied.p_BoBq_B = np.zeros(3)
        self.port = self.plant.get_applied_spatial_force_input_port().FixValue(self.context, [self.applied])

    def add_body(self) -> RigidBody:
        return self.plant.AddRigidBody("body", inertia(self.plan))

    def begin(self, samples: list[State], grasp_error: GraspError) -> None:
        self.release(displaced(np.array(samples[0]), grasp_error), grasp_error)

    def release(self, initial: np.ndarray, grasp_error: GraspError) -> None:
        """Puts the body into a state (13 numbers) with an error in the gripper."""
        rotation = RotationMatrix(rotation_matrix(initial[3:7]))
        self.plant.SetFreeBodyPose(self.context, self.body, RigidTransform(rotation, initial[:3]))
        velocity = SpatialVelocity(rotation.multiply(initial[10:]), initial[7:10])
        self.plant.SetFreeBodySpatialVelocity(self.context, self.body, velocity)
        self.initialize()
        self.control.hold(grasp_error)

    def advance(self, step: int, reference: State) -> None:
        state = self.state()
        self.push(self.control.wrench(reference, state[:7], state[7:]))

    def push(self, wrench: tuple[float, ...]) -> None:
        """One step under a force (N, world) and a torque about the origin of the body (Nm, body)."""
        rotation = self.plant.EvalBodyPoseInWorld(self.context, self.body).rotation()
        self.applied.F_Bq_W = SpatialForce(rotation.multiply(np.array(wrench[3:])), np.array(wrench[:3]))
        self.port.GetMutableData().set_value([self.applied])
        self.step()

    def state(self) -> State:
        positions = self.plant.GetPositions(self.context)
        velocities = self.plant.GetVelocities(self.context)
        turning = rotation_matrix(positions[:4]).T @ velocities[:3]
        return [*positions[4:], *positions[:4], *velocities[3:], *turning]


def inertia(plan: Plan) -> SpatialInertia:
    """Of the body, about its origin."""
    free = plan.free_body
    (xx, xy, xz), (_, yy, yz), (_, _, zz) = free.inertia.tolist()
    try:
        rotational = RotationalInertia(xx, yy, zz, xy, xz, yz)
        return SpatialInertia.MakeFromCentralInertia(free.mass, free.center, rotational)
    except RuntimeError as error:
        raise InputError(f"{plan.folder}: Drake refuses the inertia of the body: {error}") from error
