"""One motion played through MuJoCo."""

import collections
import dataclasses
from collections.abc import Callable

import mujoco
import numpy as np

from lab.mujoco.control import FreeControl, GraspError, State, displaced
from lab.mujoco.plans import Plan
from lab.mujoco.world import clearance


@dataclasses.dataclass(frozen=True)
class Outcome:
    """Final errors (m, rad), deepest overlap (m), largest force of a pair (N) and whether MuJoCo warned of anything."""

    position_error: float
    angle_error: float
    overlap: float
    force: float
    warned: bool


def final_errors(state: State, goal: np.ndarray) -> tuple[float, float]:
    """Distance (m) and angle (rad) of a body from its goal."""
    pose = np.array(state[:7])
    cosine = abs(float(pose[3:] @ goal[3:])) / float(np.linalg.norm(pose[3:]) * np.linalg.norm(goal[3:]))
    return float(np.linalg.norm(pose[:3] - goal[:3])), float(2 * np.arccos(min(1.0, cosine)))


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

    def normal_force(self) -> float:
        """Sum of the normal forces (N) of all contacts."""
        data = self.data
        # The first row of a contact is its normal, with and without friction.
        return float(data.efc_force[data.contact.efc_address].sum()) if data.ncon else 0.0

    def warned(self) -> bool:
        """Whether MuJoCo warned of anything since the start of the motion."""
        return bool(self.data.warning.number.any()) or not np.isfinite(self.data.qpos).all()

    def outcome(self, samples: list[State], grasp_error: GraspError) -> Outcome:
        """Plays a motion from rest and measures where it ends."""
        self.begin(samples, grasp_error)
        record = self.play(samples)
        position, angle = final_errors(self.state(), self.plan.goal)
        return Outcome(position, angle, record.overlap, record.force, self.warned())


class FreePlayer(Player):
    """A free body driven by the impedance wrench alone."""

    def __init__(self, model: mujoco.MjModel, plan: Plan, window: int) -> None:
        super().__init__(model, plan, window)
        self.control = FreeControl(plan)

    def begin(self, samples: list[State], grasp_error: GraspError) -> None:
        self.release(displaced(np.array(samples[0]), grasp_error), grasp_error)

    def release(self, initial: np.ndarray, grasp_error: GraspError) -> None:
        """Puts the body into a state (13 numbers) with an error in the gripper."""
        mujoco.mj_resetData(self.model, self.data)
        self.data.qpos[:], self.data.qvel[:] = initial[:7], initial[7:]
        self.control.hold(grasp_error)

    def advance(self, step: int, reference: State) -> None:
        self.push(self.control.wrench(reference, self.data.qpos.tolist(), self.data.qvel.tolist()))

    def push(self, wrench: tuple[float, ...]) -> None:
        """One step under a force (N, world) and a torque about the origin of the body (Nm, body)."""
        self.data.qfrc_applied[:] = wrench
        mujoco.mj_step(self.model, self.data)

    def state(self) -> State:
        return [*self.data.qpos.tolist(), *self.data.qvel.tolist()]

    def goal_clearance(self) -> float:
        self.data.qpos[:] = self.plan.goal
        mujoco.mj_forward(self.model, self.data)
        return clearance(self.model, self.data)
