"""One motion played through MuJoCo."""

import collections
import dataclasses
from collections.abc import Callable

import mujoco
import numpy as np

from lab.mujoco.plans import Impedance, Plan
from lab.mujoco.rotations import quaternion_of, rotation_matrix
from lab.mujoco.world import clearance

State = list[float]


@dataclasses.dataclass(frozen=True)
class GraspError:
    """Where the part sits in the gripper: offset (m, body frame), and rotation vector (rad, body frame) from the part's
    orientation to the believed one."""

    offset: np.ndarray
    turn: np.ndarray


@dataclasses.dataclass(frozen=True)
class Outcome:
    """Final errors (m, rad), deepest overlap (m), largest force of a pair (N) and whether MuJoCo warned of anything."""

    position_error: float
    angle_error: float
    overlap: float
    force: float
    warned: bool


class ContactRecord:
    """Deepest overlap (m) and largest normal force of a pair (N) during a motion. The force is the mean over the steps
    of a window: how high an impact peaks is a matter of the time step, its impulse is not."""

    def __init__(self, geom_count: int, window: int) -> None:
        self.overlap = 0.0
        self.force = 0.0
        self.geom_count = geom_count
        # Pairs and forces of the last steps, and the sum of the forces of every pair.
        self.steps: collections.deque[tuple[np.ndarray, np.ndarray]] = collections.deque()
        self.window = window
        self.sums = np.zeros(geom_count**2)

    def add(self, data: mujoco.MjData) -> None:
        """Reads the contacts of a step."""
        contact = data.contact
        pairs = self.geom_count * contact.geom[:, 0] + contact.geom[:, 1]
        # The first row of a contact is its normal, with and without friction.
        forces = data.efc_force[contact.efc_address] if data.ncon else np.zeros(0)
        np.add.at(self.sums, pairs, forces)
        self.steps.append((pairs, forces))
        if len(self.steps) > self.window:
            pairs_before, forces_before = self.steps.popleft()
            np.subtract.at(self.sums, pairs_before, forces_before)
        if data.ncon:
            self.overlap = max(self.overlap, -float(contact.dist.min()))
            self.force = max(self.force, float(self.sums[pairs].max()) / self.window)


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


class Player:
    """Plays motions on one model: what a free body and an arm have in common. Forces are means over `window` steps."""

    def __init__(self, model: mujoco.MjModel, plan: Plan, window: int) -> None:
        self.model = model
        self.data = mujoco.MjData(model)
        self.plan = plan
        self.window = window
        # MuJoCo would write warnings to a file in the working directory; they are counted in `data` all the same.
        mujoco.set_mju_user_warning(lambda message: None)

    def begin(self, samples: list[State], grasp_error: GraspError) -> None:
        """Puts everything at rest where the robot believes the body to be at the first sample."""
        raise NotImplementedError

    def advance(self, step: int, reference: State) -> None:
        """Applies what the controller makes of a sample of the reference, for one time step."""
        raise NotImplementedError

    def state(self) -> State:
        """Pose and velocity of the body (13 numbers, as in `reference.csv`)."""
        raise NotImplementedError

    def goal_clearance(self) -> float:
        """Smallest distance (m) of body and environment at the goal."""
        raise NotImplementedError

    def play(self, samples: list[State], observe: Callable[[], None] = lambda: None) -> ContactRecord:
        """Tracks reference samples, one per time step, after `begin`. `observe` is called before every step. Stops
        early at a warning."""
        record = ContactRecord(self.model.ngeom, self.window)
        for step, reference in enumerate(samples):
            observe()
            self.advance(step, reference)
            record.add(self.data)
            if (step + 1) % self.window == 0 and self.warned():
                break
        observe()
        return record

    def warned(self) -> bool:
        """Whether MuJoCo warned of anything since the start of the motion."""
        return bool(self.data.warning.number.any()) or not np.isfinite(self.data.qpos).all()

    def outcome(self, samples: list[State], grasp_error: GraspError) -> Outcome:
        """Plays a motion from rest and measures where it ends."""
        self.begin(samples, grasp_error)
        record = self.play(samples)
        pose, goal = np.array(self.state()[:7]), self.plan.goal
        cosine = abs(float(pose[3:] @ goal[3:])) / float(np.linalg.norm(pose[3:]) * np.linalg.norm(goal[3:]))
        angle = 2 * np.arccos(min(1.0, cosine))
        distance = float(np.linalg.norm(pose[:3] - goal[:3]))
        return Outcome(distance, float(angle), record.overlap, record.force, self.warned())


class FreePlayer(Player):
    """A free body driven by the impedance wrench alone."""

    def __init__(self, model: mujoco.MjModel, plan: Plan, window: int) -> None:
        super().__init__(model, plan, window)
        self.body = plan.free_body
        self.inertia = self.body.inertia.tolist()
        self.is_centered = not self.body.center.any()
        # Isotropic inertia has no gyroscopic term; leaving it out saves time.
        self.isotropic = np.allclose(self.body.inertia, self.body.inertia[0, 0] * np.eye(3))

    def begin(self, samples: list[State], grasp_error: GraspError) -> None:
        self.release(displaced(np.array(samples[0]), grasp_error), grasp_error)

    def release(self, initial: np.ndarray, grasp_error: GraspError) -> None:
        """Puts the body into a state (13 numbers) with an error in the gripper."""
        mujoco.mj_resetData(self.model, self.data)
        self.data.qpos[:], self.data.qvel[:] = initial[:7], initial[7:]
        self.offset = grasp_error.offset.tolist()
        # Damping acts in the frame that the robot believes to be that of the body.
        self.turn = quaternion_of(grasp_error.turn)
        self.impedance = self.plan.impedance.turned(rotation_matrix(self.turn))

    def advance(self, step: int, reference: State) -> None:
        data, body = self.data, self.body
        pose, velocity = data.qpos.tolist(), data.qvel.tolist()
        if self.turn[0] < 1:
            reference = turned_back(np.array(reference), self.turn).tolist()
        wrench = impedance_wrench(self.impedance, reference, pose, velocity, self.offset)
        if not self.isotropic:
            # The model of the plan has no gyroscopic term, MuJoCo has: it is cancelled.
            spin = gyroscopic_torque(self.inertia, velocity[3:])
            wrench = (*wrench[:3], *(torque + term for torque, term in zip(wrench[3:], spin)))
        if not self.is_centered:
            # Likewise what the centre of mass does as it goes around the origin.
            turning = np.cross(velocity[3:], np.cross(velocity[3:], body.center)) * body.mass
            force, torque = rotation_matrix(np.array(pose[3:])) @ turning, np.cross(body.center, turning)
            wrench = tuple(np.add(wrench, [*force, *torque]))
        data.qfrc_applied[:] = wrench
        mujoco.mj_step(self.model, data)

    def state(self) -> State:
        return [*self.data.qpos.tolist(), *self.data.qvel.tolist()]

    def goal_clearance(self) -> float:
        self.data.qpos[:] = self.plan.goal
        mujoco.mj_forward(self.model, self.data)
        return clearance(self.model, self.data)


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
