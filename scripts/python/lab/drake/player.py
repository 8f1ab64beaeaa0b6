"""Motions in Drake: discrete steps, contact solved as a convex program (SAP) between points of convex pieces."""

import collections
from collections.abc import Callable

import numpy as np
from pydrake.multibody.plant import AddMultibodyPlant, MultibodyPlantConfig
from pydrake.multibody.tree import RigidBody
from pydrake.systems.analysis import Simulator
from pydrake.systems.framework import DiagramBuilder

from lab.drake.contact import Compliance, add_parts, contacts
from lab.mujoco.control import GraspError, State
from lab.mujoco.plans import Plan
from lab.mujoco.rollout import Outcome, final_errors
from lab.mujoco.world import Contact

# Time (s) between looks at the contacts.
LOOK = 1e-3


class ContactRecord:
    """Deepest overlap (m) and largest normal force of a pair (N) during a motion, the mean over some looks, and whether
    the solver found contact forces in every step."""

    def __init__(self, window: int) -> None:
        self.overlap = 0.0
        self.force = 0.0
        self.is_solved = True
        self.window = window
        self.looks: collections.deque[collections.Counter] = collections.deque(maxlen=window)

    def add(self, deepest: float, forces: collections.Counter) -> None:
        """Reads the contacts of a look."""
        self.overlap = max(self.overlap, deepest)
        self.looks.append(forces)
        sums = sum(self.looks, collections.Counter())
        self.force = max(self.force, max(sums.values(), default=0.0) / self.window)


class DrakePlayer:
    """What a free body and an arm have in common. Forces are means over a time (s)."""

    # Acceleration (m/s^2).
    gravity = (0.0, 0.0, 0.0)

    def __init__(self, plan: Plan, contact: Contact, compliance: Compliance, window_time: float) -> None:
        self.plan, self.time_step = plan, contact.time_step
        self.stride = max(1, round(LOOK / contact.time_step))
        self.window = max(1, round(window_time / (self.stride * contact.time_step)))
        builder = DiagramBuilder()
        config = MultibodyPlantConfig(
            time_step=contact.time_step, discrete_contact_approximation="sap", contact_model=compliance.model
        )
        self.plant, _ = AddMultibodyPlant(config, builder)
        self.plant.mutable_gravity_field().set_gravity_vector(self.gravity)
        self.body = self.add_body()
        add_parts(self.plant, self.body, plan, contact.friction, compliance)
        self.plant.Finalize()
        self.simulator = Simulator(builder.Build())
        self.context = self.plant.GetMyMutableContextFromRoot(self.simulator.get_mutable_context())

    def add_body(self) -> RigidBody:
        """The body that the plan is about, with what moves it."""
        raise NotImplementedError

    def begin(self, samples: list[State], grasp_error: GraspError) -> None:
        """Puts everything at rest where the robot believes the body to be at the first sample."""
        raise NotImplementedError

    def advance(self, step: int, reference: State) -> None:
        """Applies what the controller makes of a sample of the reference, for one time step."""
        raise NotImplementedError

    def state(self) -> State:
        """Pose and velocity of the body (13 numbers, as in `reference.csv`)."""
        raise NotImplementedError

    def initialize(self) -> None:
        """Begins at time zero with the state that the context has."""
        self.simulator.get_mutable_context().SetTime(0.0)
        self.simulator.Initialize()
        self.steps = 0

    def step(self) -> None:
        """One time step."""
        self.steps += 1
        self.simulator.AdvanceTo(self.steps * self.time_step)

    def play(self, samples: list[State], observe: Callable[[], None] = lambda: None) -> ContactRecord:
        """Tracks reference samples, one per time step, after `begin`. `observe` is called before every step. Stops
        early where the solver fails."""
        record = ContactRecord(self.window)
        for step, reference in enumerate(samples):
            observe()
            try:
                self.advance(step, reference)
            except RuntimeError:
                record.is_solved = False
                return record
            if step % self.stride == 0:
                record.add(*self.contacts())
        observe()
        return record

    def outcome(self, samples: list[State], grasp_error: GraspError) -> Outcome:
        """Plays a motion from rest and measures where it ends."""
        self.begin(samples, grasp_error)
        record = self.play(samples)
        position, angle = final_errors(self.state(), self.plan.goal) if record.is_solved else (np.inf, np.inf)
        return Outcome(position, angle, record.overlap, record.force, warned=not np.isfinite(position))

    def normal_force(self) -> float:
        """Sum of the normal forces (N) of all contacts."""
        return sum(self.contacts()[1].values())

    def contacts(self) -> tuple[float, collections.Counter]:
        """Deepest overlap (m), and normal force (N) of every pair that touches."""
        return contacts(self.plant, self.context)
