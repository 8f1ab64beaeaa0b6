"""The motions of a plan, played by one process or by several."""

import dataclasses
import multiprocessing
import signal
from collections.abc import Iterator

from lab.errors import InputError
from lab.mujoco import arm_world, world
from lab.mujoco.arm import ArmPlayer
from lab.mujoco.control import GraspError
from lab.mujoco.force_robot import ForceArmPlayer, ForcePlayer
from lab.mujoco.plans import Plan
from lab.mujoco.position_robot import PositionPlayer
from lab.mujoco.rollout import FreePlayer, Outcome, Player

MUJOCO, DRAKE = "mujoco", "drake"
PLANNED, STRAIGHT = "plan", "straight push"
# Time over which contact forces are averaged (s).
FORCE_WINDOW = 0.01


# Stiffness (N/m) of contacts that hardly yield on faces: 20 N are 0.02 mm.
RIGID = 1e6


@dataclasses.dataclass(frozen=True)
class Settings:
    """How motions are played: steps and rest (s) and engine; for Drake alone, the stiffness of points of contact (N/m),
    or the hydroelastic modulus of surfaces (Pa)."""

    time_step: float
    settling_time: float
    engine: str
    contact_stiffness: float = RIGID
    hydroelastic_modulus: float | None = None


class Rollouts:
    """Plays the motions of one plan; every process makes its own models."""

    def __init__(self, plan: Plan, settings: Settings) -> None:
        self.plan = plan
        self.settings = settings
        references = {PLANNED: plan.reference, STRAIGHT: plan.straight()}
        self.samples = {
            motion: reference.sample(settings.time_step, settings.settling_time).tolist()
            for motion, reference in references.items()
        }
        self.players: dict[float, Player] = {}

    def player(self, friction: float) -> Player:
        """The simulation at a friction, made on first use."""
        if friction not in self.players:
            contact = world.Contact(friction, self.settings.time_step)
            window = max(1, round(FORCE_WINDOW / self.settings.time_step))
            if self.settings.engine == DRAKE:
                self.players[friction] = self.in_drake(contact)
            elif self.plan.position_robot and self.plan.position_robot.is_force_mode:
                kind = ForceArmPlayer if self.plan.robot else ForcePlayer
                self.players[friction] = kind(world.build(self.plan, contact), self.plan, window)
            elif self.plan.robot:
                self.players[friction] = ArmPlayer(arm_world.build(self.plan, contact), self.plan, window)
            elif self.plan.position_robot:
                model = world.build(self.plan, contact)
                self.players[friction] = PositionPlayer(model, self.plan, window, self.plan.position_robot)
            else:
                self.players[friction] = FreePlayer(world.build(self.plan, contact), self.plan, window)
        return self.players[friction]

    def in_drake(self, surface: world.Contact) -> object:
        """The simulation in Drake, whose package nothing else needs."""
        from lab.drake import arm, contact, free

        if self.plan.position_robot:
            raise InputError(
                f"{self.plan.folder}: Drake has no robot that is commanded by position; use --engine mujoco"
            )
        kind = arm.ArmPlayer if self.plan.robot else free.FreePlayer
        compliance = contact.Compliance(self.settings.contact_stiffness, self.settings.hydroelastic_modulus)
        return kind(self.plan, surface, compliance, FORCE_WINDOW)

    def play(self, motion: str, friction: float, grasp_error: GraspError) -> Outcome:
        """One motion."""
        return self.player(friction).outcome(self.samples[motion], grasp_error)

    def trace(self, friction: float, grasp_error: GraspError) -> list[list[float]]:
        """Time and state at every step of the plan's motion."""
        rows: list[list[float]] = []
        player, samples = self.player(friction), self.samples[PLANNED]
        player.begin(samples, grasp_error)
        player.play(samples, lambda: rows.append([player.data.time, *player.state()]))
        return rows


# The rollouts of the current folder, in every process of a pool.
ROLLOUTS: list[Rollouts] = []


def initialise(plan: Plan, settings: Settings) -> None:
    """Prepares a process; Ctrl-C is for the one that started it."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    ROLLOUTS[:] = [Rollouts(plan, settings)]


# Motion, friction and grasp error.
Task = tuple[str, float, GraspError]


def run(task: Task) -> Outcome:
    """Plays a motion in a prepared process."""
    return ROLLOUTS[0].play(*task)


def play_all(plan: Plan, settings: Settings, jobs: int, tasks: list[Task]) -> Iterator[Outcome]:
    """Plays motions of one plan in some processes; outcomes come in the order of the tasks."""
    with multiprocessing.Pool(jobs, initialise, (plan, settings)) as pool:
        yield from pool.imap(run, tasks, chunksize=1)
