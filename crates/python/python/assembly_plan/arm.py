"""The arm that holds the body."""

from __future__ import annotations

import json
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike

from assembly_plan import _planner
from assembly_plan._arrays import FloatArray, fixed, read, table
from assembly_plan._values import vector
from assembly_plan.errors import SceneError

if TYPE_CHECKING:
    from assembly_plan.plan import Plan
    from assembly_plan.rollouts import Rollouts


@dataclass(frozen=True, eq=False)
class JointCourse:
    """The n joints of an arm while the body moves in S scenarios, in N steps. The arrays are read-only.

    - `positions`: shape (S, N + 1, n), rad or m.
    - `speeds`: means over the steps, shape (S, N + 1, n), rad/s or m/s; zero at the first knot.
    - `torques`: of the impedance controller plus those that hold arm and body against gravity, shape (S, N + 1, n),
      Nm or N.
    """

    positions: FloatArray
    speeds: FloatArray
    torques: FloatArray


class Arm:
    """The arm of a scene, with its n joints from the base to the tip.

    Joint positions have shape (n,), or (K, n) for many at once; results have the same first axis. Poses are those of
    the body, as the robot believes it to be held: position (m, world frame) and unit quaternion ``w x y z``. Velocities
    are in the world frame, angular velocities and torques in the body frame.
    """

    def __init__(self, native: _planner.Arm) -> None:
        """Not to be called; `Scene.arm` returns it."""
        self._native = native
        content = json.loads(native.content())
        self._joints: list[dict[str, Any]] = content["joints"]
        self._configuration = fixed(content["configuration"])

    @property
    def joints(self) -> tuple[str, ...]:
        """Names of the joints."""
        return tuple(joint["name"] for joint in self._joints)

    @property
    def configuration(self) -> FloatArray:
        """Joint positions with the body at its goal (rad or m), shape (n,)."""
        return self._configuration

    @property
    def position_limits(self) -> FloatArray:
        """Lowest and highest positions (rad or m), shape (2, n); infinite without a limit."""
        lower = [-np.inf if joint["lower"] is None else joint["lower"] for joint in self._joints]
        return fixed([lower, self._limits("upper")])

    @property
    def speed_limits(self) -> FloatArray:
        """Largest speeds (rad/s or m/s), shape (n,); infinite without a limit."""
        return fixed(self._limits("velocity"))

    @property
    def torque_limits(self) -> FloatArray:
        """Largest torques (Nm or N), shape (n,); infinite without a limit."""
        return fixed(self._limits("effort"))

    def pose(self, configuration: ArrayLike) -> FloatArray:
        """Poses of the body at joint positions, shape (7,) or (K, 7)."""
        return self._kinematics(configuration, "poses", 7)

    def jacobian(self, configuration: ArrayLike) -> FloatArray:
        """Velocity and angular velocity of the body per speed of each joint, shape (6, n) or (K, 6, n)."""
        return self._kinematics(configuration, "jacobians", 6, len(self._joints))

    def mass_matrix(self, configuration: ArrayLike) -> FloatArray:
        """Joint-space inertia with rotors and body (kg m^2), shape (n, n) or (K, n, n)."""
        return self._kinematics(configuration, "mass_matrices", len(self._joints), len(self._joints))

    def apparent_inertia(self, configuration: ArrayLike) -> FloatArray:
        """Inertia that the body seems to have (kg, kg m, kg m^2), shape (6, 6) or (K, 6, 6); NaN where singular."""
        return self._kinematics(configuration, "apparent_inertias", 6, 6)

    def inverse_kinematics(self, pose: ArrayLike, near: ArrayLike | None = None) -> FloatArray:
        """Joint positions at which the body has a pose, shape (n,), on the branch of `near`.

        By default `near` is `configuration`. Raises `SceneError` where the arm does not reach the pose from there.
        """
        start = self._table(self._configuration if near is None else near, "near")
        return read(self._native.inverse(vector(pose, 7, "pose"), start.tobytes()), len(self._joints))

    def course(self, plan: Plan | Rollouts) -> JointCourse:
        """The joints in every scenario of a plan, or in rollouts.

        Raises `SceneError` where the arm does not reach a pose or a joint is too slow.
        """
        shape = (len(plan.time), len(self._joints))
        positions, torques = np.empty((len(plan.states), *shape)), np.empty((len(plan.states), *shape))
        for scenario, grasp in enumerate(zip(plan.offsets, plan.turns, strict=True)):
            offset, turn = ([float(value) for value in vector] for vector in grasp)
            states, wrenches = plan.states[scenario].tobytes(), plan.wrenches[scenario].tobytes()
            found = self._native.course(plan.time_step, (offset, turn), states, wrenches)
            positions[scenario] = read(found["positions"], *shape)
            torques[scenario] = read(found["torques"], *shape)
        speeds = np.diff(positions, axis=1, prepend=positions[:, :1]) / plan.time_step
        return JointCourse(fixed(positions), fixed(speeds), fixed(torques))

    def _limits(self, key: str) -> list[float]:
        return [np.inf if joint[key] is None else joint[key] for joint in self._joints]

    def _table(self, configuration: ArrayLike, name: str) -> FloatArray:
        if np.ndim(configuration) not in (1, 2):
            raise SceneError(f"{name}: has shape {np.shape(configuration)}, must be (n,) or (K, n)")
        return table(configuration, len(self._joints), name)

    def _kinematics(self, configuration: ArrayLike, key: str, *shape: int) -> FloatArray:
        rows = self._table(configuration, "configuration")
        found = read(self._native.kinematics(rows.tobytes())[key], len(rows), *shape)
        return found[0] if np.ndim(configuration) == 1 else found

    def __repr__(self) -> str:
        return f"<Arm: {', '.join(self.joints)}>"
