"""Plays plans in MuJoCo: what the command line asks for."""

import argparse
import multiprocessing
import signal
import sys

import mujoco
import numpy as np

import comparison
import matrix
import offsets
import plans
import results
import selftest
import world
from arguments import parse_arguments
from plans import InputError, Plan
from rollout import Outcome, Player, displaced

PLANNED, STRAIGHT = "plan", "straight push"


def parse_frictions(text: str) -> list[float]:
    """A list of coefficients."""
    try:
        frictions = [float(entry) for entry in text.split(",")]
    except ValueError as error:
        raise InputError(f"--friction {text}: not a list of numbers") from error
    if not all(0 <= friction < float("inf") for friction in frictions):
        raise InputError(f"--friction {text}: coefficients must not be negative")
    return frictions


class Rollouts:
    """Plays the motions of one plan; every process makes its own models."""

    def __init__(self, plan: Plan, time_step: float, settling_time: float) -> None:
        self.plan = plan
        self.time_step = time_step
        references = {PLANNED: plan.reference, STRAIGHT: plan.straight()}
        self.samples = {
            motion: reference.sample(time_step, settling_time).tolist() for motion, reference in references.items()
        }
        self.players: dict[float, Player] = {}

    def player(self, friction: float) -> Player:
        """The simulation at a friction, made on first use."""
        if friction not in self.players:
            model = world.build(self.plan, world.Contact(friction, self.time_step))
            window = max(1, round(self.plan.reference.interval() / self.time_step))
            self.players[friction] = Player(model, self.plan, window)
        return self.players[friction]

    def play(self, motion: str, friction: float, offset: np.ndarray) -> Outcome:
        """One motion."""
        return self.player(friction).outcome(self.samples[motion], offset, self.plan.goal)

    def trace(self, friction: float, offset: np.ndarray) -> list[list[float]]:
        """Time and state at every step of the plan's motion."""
        rows: list[list[float]] = []
        player, samples = self.player(friction), self.samples[PLANNED]
        player.play(
            samples,
            offset.tolist(),
            displaced(np.array(samples[0]), offset),
            lambda data: rows.append([data.time, *data.qpos.tolist(), *data.qvel.tolist()]),
        )
        return rows


# The rollouts of the current folder, in every process of a pool.
ROLLOUTS: list[Rollouts] = []


def initialise(plan: Plan, time_step: float, settling_time: float) -> None:
    """Prepares a process; Ctrl-C is for the one that started it."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    ROLLOUTS[:] = [Rollouts(plan, time_step, settling_time)]


# Motion, friction and offset.
Task = tuple[str, float, np.ndarray]


def run(task: Task) -> Outcome:
    """Plays a motion in a prepared process."""
    return ROLLOUTS[0].play(*task)


def play_all(arguments: argparse.Namespace, plan: Plan, tasks: list[Task]) -> list[Outcome]:
    """Plays motions of one plan."""
    settings = (plan, arguments.time_step, arguments.settling_time)
    with multiprocessing.Pool(arguments.jobs, initialise, settings) as pool:
        return pool.map(run, tasks, chunksize=1)


def validate(arguments: argparse.Namespace, plan: Plan, cells: list[offsets.Cell]) -> list[results.Column]:
    """Plays a plan at all frictions and offsets."""
    motions = [PLANNED, STRAIGHT] if arguments.baseline else [PLANNED]
    heads = [(motion, friction) for friction in parse_frictions(arguments.friction) for motion in motions]
    tasks = [(*head, offset) for head in heads for cell in cells for offset in cell.offsets]
    outcomes = iter(play_all(arguments, plan, tasks))
    return [results.Column(*head, [[next(outcomes) for _ in cell.offsets] for cell in cells]) for head in heads]


def cells_of(arguments: argparse.Namespace, plan: Plan) -> list[offsets.Cell]:
    """Offsets that the arguments ask for."""
    return offsets.cells(plan, arguments.offsets, arguments.magnitudes, arguments.count, arguments.seed)


def write_trace(arguments: argparse.Namespace) -> None:
    """`--trace`."""
    plan = plans.load(arguments.folders[0], arguments.scene)
    offset = cells_of(arguments, plan)[0].offsets[0]
    friction = parse_frictions(arguments.friction)[0]
    rows = Rollouts(plan, arguments.time_step, arguments.settling_time).trace(friction, offset)
    results.write_csv(arguments.trace, [plans.TIME_COLUMN, *plans.STATE_COLUMNS], rows)
    x, y, z = 1e3 * offset
    print(f"{arguments.trace}: {plan.title}, friction {friction:g}, offset ({x:g} {y:g} {z:g}) mm")


def compare(arguments: argparse.Namespace) -> None:
    """`--compare`: plays what `assembly-plan simulate` played."""
    loaded = [plans.load(folder, arguments.scene) for folder in arguments.folders]
    known = [comparison.read(arguments.compare, plan) for plan in loaded]
    for plan, theirs in zip(loaded, known):
        ours = play_all(arguments, plan, [(other.motion, other.friction, other.offset) for other in theirs])
        print(f"### {plan.title}, start {plan.start_name}: {len(theirs)} motions in both simulators\n")
        print(comparison.table(theirs, ours, tolerance_of(arguments, loaded)) + "\n", flush=True)


def tolerance_of(arguments: argparse.Namespace, loaded: list[Plan]) -> results.Tolerance:
    """What counts as success: what the arguments say, else the narrowest of the plans' own tolerances."""
    position = arguments.position_tolerance or min(plan.position_tolerance for plan in loaded)
    angle = arguments.angle_tolerance or min(plan.angle_tolerance for plan in loaded)
    return results.Tolerance(position, angle)


def print_tables(arguments: argparse.Namespace) -> None:
    """Plays every folder and prints its table, then the success of all of them together."""
    # What is wrong is to be said once and before hours of work.
    if arguments.csv and not arguments.csv.absolute().parent.is_dir():
        raise InputError(f"--csv {arguments.csv}: the folder {arguments.csv.parent} does not exist; make it first")
    loaded = [plans.load(folder, arguments.scene) for folder in arguments.folders]
    models = [world.build(plan, world.Contact(0.0, arguments.time_step)) for plan in loaded]
    tolerance = tolerance_of(arguments, loaded)
    print(
        f"Success: within {1e3 * tolerance.position:g} mm and {tolerance.angle:g} rad of the goal, "
        f"{arguments.settling_time:g} s after the end of the reference; intervals of 95 % (Wilson). "
        f"MuJoCo {mujoco.__version__}, steps of {1e3 * arguments.time_step:g} ms.\n"
    )
    played = []
    for plan, model in zip(loaded, models):
        cells = cells_of(arguments, plan)
        result = results.Result(plan, cells, validate(arguments, plan, cells))
        print(results.table(result, tolerance, world.goal_clearance(model, plan)) + "\n", flush=True)
        played.append(result)
    if len(played) > 1:
        print(matrix.tables(played, tolerance))
    if arguments.csv:
        rows = [row for result in played for row in results.csv_rows(result, tolerance)]
        results.write_csv(arguments.csv, results.CSV_COLUMNS, rows)


def main() -> int:
    """Runs what the command line asks for; returns the exit code."""
    arguments = parse_arguments()
    try:
        if arguments.self_test:
            return 0 if selftest.run() else 1
        if arguments.trace:
            write_trace(arguments)
        elif arguments.compare:
            compare(arguments)
        else:
            print_tables(arguments)
    except InputError as error:
        print(f"error: {error}", file=sys.stderr)
        return 2
    except OSError as error:
        print(f"error: {error}", file=sys.stderr)
        return 3
    except KeyboardInterrupt:
        return 130
    return 0


if __name__ == "__main__":
    sys.exit(main())
