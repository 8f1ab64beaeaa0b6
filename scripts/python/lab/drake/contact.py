"""Contacts in Drake: between points of convex pieces, or over surfaces with a pressure."""

import collections
import dataclasses

import numpy as np
from pydrake.geometry import (
    AddCompliantHydroelasticProperties,
    AddContactMaterial,
    AddRigidHydroelasticProperties,
    ContactSurface,
    Convex,
    ProximityProperties,
)
from pydrake.math import RigidTransform
from pydrake.multibody.plant import CoulombFriction, MultibodyPlant
from pydrake.multibody.tree import RigidBody
from pydrake.systems.framework import Context

from lab.mujoco.plans import Plan

# Time (s) in which a contact stops to yield.
RELAXATION = 1e-4
# Length (m) that has to be given, and that convex pieces do not use.
RESOLUTION = 1e-3


@dataclasses.dataclass(frozen=True)
class Compliance:
    """How contacts yield: each point with a stiffness (N/m); or surfaces with a hydroelastic modulus (Pa), which is the
    pressure in the middle of a piece of the body. It is zero at the faces of the piece."""

    stiffness: float
    modulus: float | None

    @property
    def model(self) -> str:
        """Name of the model in Drake."""
        return "point" if self.modulus is None else "hydroelastic"


def add_parts(plant: MultibodyPlant, body: RigidBody, plan: Plan, friction: float, compliance: Compliance) -> None:
    """The convex pieces of a plan: the body's, which alone yields under pressure, and the world's."""
    for holder, parts, name in ((body, plan.body, "body"), (plant.world_body(), plan.environment, "environment")):
        properties = material(friction, compliance)
        if compliance.modulus is not None and holder is body:
            AddCompliantHydroelasticProperties(RESOLUTION, compliance.modulus, properties)
        elif compliance.modulus is not None:
            AddRigidHydroelasticProperties(properties)
        for index, vertices in enumerate(parts):
            shape = Convex(points=vertices.T, label=f"{name}{index}")
            plant.RegisterCollisionGeometry(holder, RigidTransform(), shape, f"{name}{index}", properties)


def material(friction: float, compliance: Compliance) -> ProximityProperties:
    """Friction and stiffness of all pieces: two equal points in a row yield twice as much as one."""
    properties = ProximityProperties()
    coulomb = CoulombFriction(friction, friction)
    if compliance.modulus is None:
        AddContactMaterial(properties=properties, point_stiffness=2 * compliance.stiffness, friction=coulomb)
    else:
        AddContactMaterial(properties=properties, friction=coulomb)
    properties.AddProperty("material", "relaxation_time", RELAXATION / 2)
    return properties


def contacts(plant: MultibodyPlant, context: Context) -> tuple[float, collections.Counter]:
    """Deepest overlap (m) of the pieces, and normal force (N) of every pair that touches."""
    results = plant.get_contact_results_output_port().Eval(context)
    deepest, forces = 0.0, collections.Counter()
    for index in range(results.num_point_pair_contacts()):
        info = results.point_pair_contact_info(index)
        pair = info.point_pair()
        deepest = max(deepest, pair.depth)
        forces[(pair.id_A.get_value(), pair.id_B.get_value())] += abs(float(info.contact_force() @ pair.nhat_BA_W))
    for index in range(results.num_hydroelastic_contacts()):
        info = results.hydroelastic_contact_info(index)
        surface = info.contact_surface()
        force = abs(float(info.F_Ac_W().translational() @ mean_normal(surface)))
        forces[(surface.id_M().get_value(), surface.id_N().get_value())] += force
    if results.num_hydroelastic_contacts():
        # A pressure has no depth: that of the pieces is measured.
        query = plant.get_geometry_query_input_port().Eval(context)
        deepest = max((pair.depth for pair in query.ComputePointPairPenetration()), default=0.0)
    return deepest, forces


def mean_normal(surface: ContactSurface) -> np.ndarray:
    """Unit normal of a surface, the mean over its area."""
    normals = sum(surface.area(face) * surface.face_normal(face) for face in range(surface.num_faces()))
    return normals / np.linalg.norm(normals)
