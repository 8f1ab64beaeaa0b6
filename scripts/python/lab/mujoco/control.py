"""The controller of a free body, for any engine."""

import dataclasses

import mujoco
import numpy as np

from lab.mujoco.plans import Impedance, Plan
from lab.mujoco.rotations import quaternion_of, rotation_matrix

State = list[float]


@dataclasses.dataclass(frozen=True)
class GraspError:
    """Where the part sits in the gripper: offset (m, body frame), and rotation vector (rad, body frame) from the part's
    orientation to the believed one."""

    offset: np.ndarray
    turn: np.ndarray


def impedance_wrench(
    impedance: Impedance, reference: State, pose: State, velocity: State, offset: State
) -> tuple[float, ...]:
    """Force (world frame, N) and torque (body frame, Nm) that pull the pose `P_q(pose, offset)` to the reference
    (Eq. impedancewrench). Plain numbers: numpy takes several times longer for three of them."""
    x, y, z, w, i, j, k = pose
    a, b, c = offset
    shift = (
        (1 - 2 * (j * j + k * k)) * a + 2 * (i * j - w * k) * b + 2 * (i * k + w * j) * c,
        2 * (i * j + w * k) * a + (1 - 2 * (i * i + k * k)) * b + 2 * (j * k - w * i) * c,
        2 * (i * k - w * j) * a + 2 * (j * k + w * i) * b + (1 - 2 * (i * i + j * j)) * c,
    )
    stiffness = impedance.translational_stiffness
    rx, ry, rz, rw, ri, rj, rk, *reference_velocity = reference
    scalar = w * rw + i * ri + j * rj + k * rk
    twice = 2 * impedance.rotational_stiffness * scalar
    lag = [wanted - actual for wanted, actual in zip(reference_velocity, velocity)]
    force = [row[0] * lag[0] + row[1] * lag[1] + row[2] * lag[2] for row in impedance.translational_damping]
    torque = [row[0] * lag[3] + row[1] * lag[4] + row[2] * lag[5] for row in impedance.rotational_damping]
    return (
        stiffness * (rx - x - shift[0]) + force[0],
        stiffness * (ry - y - shift[1]) + force[1],
        stiffness * (rz - z - shift[2]) + force[2],
        twice * (w * ri - i * rw - j * rk + k * rj) + torque[0],
        twice * (w * rj + i * rk - j * rw - k * ri) + torque[1],
        twice * (w * rk - i * rj + j * ri - k * rw) + torque[2],
    )


def gyroscopic_torque(inertia: list[list[float]], spin: State) -> tuple[float, float, float]:
    """`omega x I omega` (Nm, body frame)."""
    p, q, r = spin
    a, b, c = (row[0] * p + row[1] * q + row[2] * r for row in inertia)
    return q * c - r * b, r * a - p * c, p * b - q * a


class FreeControl:
    """The impedance controller of a free body with an error in the gripper. It cancels what engines have and the
    model of the plan has not: gyroscopic torques, and what the centre of mass does as it goes around the origin."""

    def __init__(self, plan: Plan) -> None:
        self.nominal = plan.impedance
        self.body = plan.free_body
        self.inertia = self.body.inertia.tolist()
        self.is_centered = not self.body.center.any()
        # Isotropic inertia has no gyroscopic term; leaving it out saves time.
        self.isotropic = np.allclose(self.body.inertia, self.body.inertia[0, 0] * np.eye(3))

    def hold(self, grasp_error: GraspError) -> None:
        """Takes the body with an error in the gripper."""
        self.offset = grasp_error.offset.tolist()
        # Damping acts in the frame that the robot believes to be that of the body.
        self.turn = quaternion_of(grasp_error.turn)
        self.impedance = self.nominal.turned(rotation_matrix(self.turn))

    def wrench(self, reference: State, pose: State, velocity: State) -> tuple[float, ...]:
        """Force (N, world) and torque about the origin (Nm, body) towards a reference."""
        body = self.body
        if self.turn[0] < 1:
            reference = turned_back(np.array(reference), self.turn).tolist()
        wrench = impedance_wrench(self.impedance, reference, pose, velocity, self.offset)
        if not self.isotropic:
            spin = gyroscopic_torque(self.inertia, velocity[3:])
            wrench = (*wrench[:3], *(torque + term for torque, term in zip(wrench[3:], spin)))
        if not self.is_centered:
            turning = np.cross(velocity[3:], np.cross(velocity[3:], body.center)) * body.mass
            force, torque = rotation_matrix(np.array(pose[3:])) @ turning, np.cross(body.center, turning)
            wrench = tuple(np.add(wrench, [*force, *torque]))
        return wrench


def displaced(reference: np.ndarray, grasp_error: GraspError) -> np.ndarray:
    """The state at rest in which the body really is when the robot believes it at the reference: `P_q^-1`."""
    state = np.zeros(13)
    state[:7] = turned_back(reference, quaternion_of(grasp_error.turn))[:7]
    state[:3] -= rotation_matrix(state[3:7]) @ grasp_error.offset
    return state


def turned_back(reference: np.ndarray, turn: np.ndarray) -> np.ndarray:
    """A reference for the believed body (13 numbers) as orientation and angular velocity of the body, from whose
    orientation the quaternion `turn` leads to the believed one."""
    state, back = reference.copy(), np.zeros(4)
    mujoco.mju_negQuat(back, turn)
    mujoco.mju_mulQuat(state[3:7], reference[3:7], back)
    mujoco.mju_rotVecQuat(state[10:], reference[10:], turn)
    return state
