"""Plays plans in MuJoCo: what the command line asks for."""

import argparse
import dataclasses
import importlib.metadata
from collections.abc import Iterator

import numpy as np

from lab import tables
from lab.errors import InputError
from lab.mujoco import plans, robots
from lab.mujoco.plans import Plan
from lab.mujoco.rollout import Outcome
from lab.validation import comparison, matrix, offsets, results, selftest
from lab.validation.rollouts import DRAKE, FORCE_WINDOW, MUJOCO, PLANNED, STRAIGHT, Rollouts, Settings, Task, play_all

# Time steps (s) of the engines.
TIME_STEPS = {MUJOCO: 0.0005, DRAKE: 0.00025}


def parse_frictions(text: str) -> list[float]:
    """A list of coefficients."""
    try:
        frictions = [float(entry) for entry in text.split(",")]
    except ValueError as error:
        raise InputError(f"--friction {text}: not a list of numbers") from error
    if not all(0 <= friction < float("inf") for friction in frictions):
        raise InputError(f"--friction {text}: coefficients must not be negative")
    return frictions


def load(arguments: argparse.Namespace) -> list[Plan]:
    """The plans of all folders, with the arm that plays them if one is asked for."""
    loaded = [plans.load(folder, arguments.scene) for folder in arguments.folders]
    if arguments.rotation_error is not None:
        loaded = [dataclasses.replace(plan, turn=arguments.rotation_error) for plan in loaded]
    return [with_arm(arguments, plan) for plan in loaded] if arguments.arm else loaded


def with_arm(arguments: argparse.Namespace, plan: Plan) -> Plan:
    """The plan with its robot, or that of `--robot`, and with what the arguments say instead of the plan."""
    file = arguments.robot or plan.folder / "resolved.toml"
    try:
        robot = robots.read(file)
    except OSError as error:
        raise InputError(f"--robot {file} cannot be read: {error}") from error
    except ValueError as error:
        raise InputError(f"{file}: {error}") from error
    if plan.position_robot and plan.position_robot.is_force_mode:
        if arguments.gain_factor != 1 or arguments.delay > 0 or arguments.joint_friction is not None:
            raise InputError(
                f"{plan.folder}: the plan is for force mode, with the gains and the delay of its [robot] table: leave "
                "--gain-factor, --delay and --joint-friction out"
            )
        return dataclasses.replace(plan, robot=robot)
    robot = dataclasses.replace(robot, delay=arguments.delay)
    if arguments.joint_friction is not None:
        robot = dataclasses.replace(robot, joint_friction=np.full(len(robot.configuration), arguments.joint_friction))
    return dataclasses.replace(plan, robot=robot, impedance=plan.impedance.scaled(arguments.gain_factor))


def settings_of(arguments: argparse.Namespace) -> Settings:
    """How the arguments say to play."""
    time_step = arguments.time_step or TIME_STEPS[arguments.engine]
    compliance = arguments.contact_stiffness, arguments.hydroelastic_modulus
    return Settings(time_step, arguments.settling_time, arguments.engine, *compliance)


def engine_line(arguments: argparse.Namespace) -> str:
    """Name and version of the engine."""
    version = importlib.metadata.version(arguments.engine)
    if arguments.engine == MUJOCO:
        return f"MuJoCo {version}"
    if arguments.hydroelastic_modulus:
        return f"Drake {version}, hydroelastic contact of {arguments.hydroelastic_modulus:g} Pa"
    return f"Drake {version}, contacts of {arguments.contact_stiffness:g} N/m"


def play_asked(arguments: argparse.Namespace, plan: Plan, tasks: list[Task]) -> Iterator[Outcome]:
    """Plays motions of one plan as the arguments say."""
    return play_all(plan, settings_of(arguments), arguments.jobs, tasks)


def validate(
    arguments: argparse.Namespace, plan: Plan, cells: list[offsets.Cell], tolerance: results.Tolerance
) -> results.Result:
    """Plays a plan at all frictions and offsets, and prints a row of its table as soon as it is known."""
    motions = [PLANNED, STRAIGHT] if arguments.baseline else [PLANNED]
    frictions = parse_frictions(arguments.friction)
    columns = [results.Column(motion, friction, []) for friction in frictions for motion in motions]
    tasks = [
        (column.motion, column.friction, grasp_error)
        for cell in cells
        for column in columns
        for grasp_error in cell.grasp_errors()
    ]
    print(results.heading(plan, columns), flush=True)
    outcomes = play_asked(arguments, plan, tasks)
    for cell in cells:
        for column in columns:
            column.outcomes.append([next(outcomes) for _ in cell.offsets])
        print(results.success_row(cell, columns, tolerance), flush=True)
    return results.Result(plan, cells, columns)


def cells_of(arguments: argparse.Namespace, plan: Plan) -> list[offsets.Cell]:
    """Grasp errors that the arguments ask for."""
    return offsets.cells(plan, arguments.offsets, arguments.magnitude, arguments.random, arguments.seed)


def write_trace(arguments: argparse.Namespace) -> None:
    """`--trace`."""
    plan = load(arguments)[0]
    grasp_error = cells_of(arguments, plan)[0].grasp_errors()[0]
    friction = parse_frictions(arguments.friction)[0]
    rows = Rollouts(plan, settings_of(arguments)).trace(friction, grasp_error)
    tables.write(arguments.trace, [plans.TIME_COLUMN, *plans.STATE_COLUMNS], rows)
    x, y, z = 1e3 * grasp_error.offset
    print(f"{arguments.trace}: {plan.title}, friction {friction:g}, offset ({x:g} {y:g} {z:g}) mm")


def compare(arguments: argparse.Namespace) -> None:
    """`--compare`: plays what `assembly-plan simulate` played."""
    loaded = load(arguments)
    known = [comparison.read(arguments.compare, plan) for plan in loaded]
    for plan, theirs in zip(loaded, known):
        tasks = [(other.motion, other.friction, other.grasp_error) for other in theirs]
        ours = list(play_asked(arguments, plan, tasks))
        print(f"### {plan.title}, start {plan.start_name}: {len(theirs)} motions in both simulators\n")
        print(comparison.table(theirs, ours, tolerance_of(arguments, loaded)) + "\n", flush=True)


def tolerance_of(arguments: argparse.Namespace, loaded: list[Plan]) -> results.Tolerance:
    """What counts as success: what the arguments say, else the narrowest of the plans' own tolerances."""
    position = arguments.position_tolerance or min(plan.position_tolerance for plan in loaded)
    angle = arguments.angle_tolerance or min(plan.angle_tolerance for plan in loaded)
    return results.Tolerance(position, angle)


def print_tables(arguments: argparse.Namespace) -> None:
    """Plays every folder and prints its table, then the success of all of them together."""
    # Wrong input is reported before hours of work.
    if arguments.csv and not arguments.csv.absolute().parent.is_dir():
        raise InputError(f"--csv {arguments.csv}: the folder {arguments.csv.parent} does not exist; make it first")
    loaded = load(arguments)
    # Distances are those of MuJoCo in any case.
    measuring = dataclasses.replace(settings_of(arguments), engine=MUJOCO)
    clearances = [Rollouts(plan, measuring).player(0.0).goal_clearance() for plan in loaded]
    tolerance = tolerance_of(arguments, loaded)
    print(
        f"Success: within {1e3 * tolerance.position:g} mm and {tolerance.angle:g} rad of the goal, "
        f"{arguments.settling_time:g} s after the end of the reference; intervals of 95 % (Wilson). "
        f"{engine_line(arguments)}, steps of {1e3 * settings_of(arguments).time_step:g} ms.\n",
        flush=True,
    )
    for plan in loaded if arguments.arm else []:
        print(arm_line(plan))
    played = []
    for plan, clearance in zip(loaded, clearances):
        cells = cells_of(arguments, plan)
        result = validate(arguments, plan, cells, tolerance)
        print(results.extremes(result, tolerance, clearance) + "\n", flush=True)
        played.append(result)
    if len(played) > 1:
        print(matrix.by_plan(played, tolerance))
    if arguments.csv:
        rows = [row for result in played for row in results.csv_rows(result, tolerance)]
        tables.write(arguments.csv, results.CSV_COLUMNS, rows)


def arm_line(plan: Plan) -> str:
    """What arm plays a plan, and how."""
    robot, gains = plan.robot, plan.impedance
    mode = plan.position_robot
    if mode and mode.is_force_mode:
        return (
            f"{plan.folder}: arm {robot.urdf.name} in force mode, {gains.translational_stiffness:g} N/m and "
            f"{gains.rotational_stiffness:g} Nm/rad, damping {mode.damping[0]:g} Ns/m and {mode.damping[1]:g} Nms/rad, "
            f"every {1e3 * mode.period:g} ms after {1e3 * mode.delay:g} ms; forces are means over "
            f"{1e3 * FORCE_WINDOW:g} ms.\n"
        )
    frictions = " ".join(f"{friction:g}" for friction in dict.fromkeys(robot.joint_friction.tolist()))
    return (
        f"{plan.folder}: whole arm {robot.urdf.name}, {gains.translational_stiffness:g} N/m and "
        f"{gains.rotational_stiffness:g} Nm/rad, joint friction {frictions} Nm, turns up to {plan.turn:g} rad, torques "
        f"every {1e3 * robot.control_period:g} ms after {1e3 * robot.delay:g} ms; forces are means over "
        f"{1e3 * FORCE_WINDOW:g} ms.\n"
    )


def run(arguments: argparse.Namespace) -> int:
    """Runs what the command line asks for; returns the exit code."""
    if arguments.self_test:
        return 0 if selftest.run(arguments.engine) else 1
    if arguments.trace:
        write_trace(arguments)
    elif arguments.compare:
        compare(arguments)
    else:
        print_tables(arguments)
    return 0
