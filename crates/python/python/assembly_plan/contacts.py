"""Distances and contact normals at many poses."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from assembly_plan._arrays import FloatArray, read
from assembly_plan._types import ContactData

_POSE = 7


@dataclass(frozen=True, eq=False, repr=False, init=False)
class Contacts:
    """Contact information of P pairs at K poses, with exact derivatives by the raw pose. The arrays are read-only.

    Of each pair, C = 7 components: the smoothed distance (m), and the contact normal as 6 numbers: the direction of the
    contact force on the body (world frame), and its torque per newton (m, body frame). With points, C = 10: the contact
    point follows (m, world frame). Derivatives are by position (m) and quaternion ``w x y z``, which is normalised
    first.

    - `pairs`: names of the pairs, ``BODY PART/ENVIRONMENT PART``.
    - `values`: shape (K, P, C).
    - `jacobian`: first derivatives, shape (K, P, C, 7); None unless they were asked for.
    - `hessian`: second derivatives, shape (K, P, C, 7, 7); None unless they were asked for.
    """

    pairs: tuple[str, ...]
    values: FloatArray
    jacobian: FloatArray | None
    hessian: FloatArray | None

    def __init__(self, data: ContactData, poses: int) -> None:
        """Not to be called; `Scene.contacts` returns it."""
        pairs, components = tuple(data["pairs"]), data["components"]
        values = read(data["values"], len(pairs), poses, components)
        jacobian = hessian = None
        if data["jacobians"]:
            jacobian = read(data["jacobians"], len(pairs), poses, components, _POSE)
        if data["hessians"]:
            hessian = read(data["hessians"], len(pairs), components, poses, _POSE, _POSE)
        object.__setattr__(self, "pairs", pairs)
        object.__setattr__(self, "values", values.swapaxes(0, 1))
        object.__setattr__(self, "jacobian", None if jacobian is None else jacobian.swapaxes(0, 1))
        object.__setattr__(self, "hessian", None if hessian is None else np.moveaxis(hessian, 2, 0))

    @property
    def distance(self) -> FloatArray:
        """Smoothed distances (m), shape (K, P)."""
        return self.values[..., 0]

    @property
    def normal(self) -> FloatArray:
        """Contact normals, shape (K, P, 6)."""
        return self.values[..., 1:7]

    @property
    def point(self) -> FloatArray:
        """Contact points (m, world frame), shape (K, P, 3); (K, P, 0) unless they were asked for."""
        return self.values[..., 7:]

    def __repr__(self) -> str:
        return f"<Contacts: {len(self.values)} poses, {len(self.pairs)} pairs>"
