"""Checks that need no motion: kinematics and law of the players against MuJoCo's, and stand-ins against the makers'
packages, where these are installed."""

import ast
import dataclasses
import importlib.util
import inspect
import pathlib
import re
import shutil
import tempfile

import numpy as np

import exported_plan
import impedance
import rotations
from exported_plan import ToolState
from failures import Stopped
from guards import Guards, Limits, Measurement
from kinematics import Pose
from lab.mujoco.control import impedance_wrench
from lab.mujoco.plans import Impedance, damping_matrix
from lab.players import no_numbers
from lab.players.seal import seal
from lab.players.simulated_arm import SimulatedArm, Task

HERE = pathlib.Path(__file__).resolve().parent
RECORDED = HERE / "recorded"


def plan_of(name: str) -> exported_plan.ExportedPlan:
    """A recorded plan."""
    with tempfile.TemporaryDirectory() as work:
        folder = pathlib.Path(work) / name
        shutil.copytree(RECORDED / name, folder)
        seal(folder)
        return exported_plan.load(folder)


def kinematics_are_those_of_the_urdf_file() -> str:
    """Pose and Jacobian of the tool at random joint positions."""
    random = np.random.default_rng(1)
    for name, arm in (("corner-six", "six"), ("corner-seven", "seven")):
        plan = plan_of(name)
        simulated = SimulatedArm(Task(RECORDED / name, arm, (0.0, 0.0, 0.0), pathlib.Path()))
        for _ in range(20):
            simulated.data.qpos[:] = plan.arm.start + random.uniform(-0.5, 0.5, len(plan.arm.start))
            position, rotation, jacobian = simulated.tool()
            tool, own = plan.arm.pose_and_jacobian(simulated.data.qpos)
            if max(tool.errors(Pose(position, rotation))) > 1e-6 or np.abs(own - jacobian).max() > 1e-6:
                return f"{name}: {tool.errors(Pose(position, rotation))}"
    return ""


def the_law_is_that_of_the_plan() -> str:
    """The wrench at the tool against the law for the part that plans are tested with in MuJoCo."""
    random = np.random.default_rng(2)
    plan = plan_of("corner-six")
    record = plan.document["impedance"]
    law = Impedance(
        record["translational_stiffness"],
        record["rotational_stiffness"],
        damping_matrix(record["translational_damping"]),
        damping_matrix(record["rotational_damping"]),
    )
    players = impedance.Impedance(plan)
    for _ in range(20):
        states = [random_state(random, plan.reference(0.5).pose) for _ in range(2)]
        reference, measured = ([*values_of(plan, state)] for state in states)
        wrench = np.array(impedance_wrench(law, reference, measured[:7], measured[7:], [0.0] * 3))
        part = plan.part(states[1].pose)
        force = plan.base.rotation.T @ wrench[:3]
        torque = plan.base.rotation.T @ part.rotation @ wrench[3:]
        lever = states[1].pose.rotation @ plan.grasp.position
        expected = np.concatenate([force, torque + np.cross(lever, force)])
        difference = np.abs(players.wrench(*states) - expected).max()
        if difference > 1e-6:
            return f"differs by {difference:g}"
    return ""


def random_state(random: np.random.Generator, near: Pose) -> ToolState:
    """A state of the tool near a pose."""
    pose = Pose(
        near.position + random.uniform(-0.05, 0.05, 3),
        near.rotation @ rotations.of_vector(random.uniform(-0.2, 0.2, 3)),
    )
    return ToolState(pose, random.uniform(-0.1, 0.1, 3), random.uniform(-0.3, 0.3, 3))


def values_of(plan: exported_plan.ExportedPlan, state: ToolState) -> np.ndarray:
    """Pose and twist of the part in the world as in the tables of plans."""
    part, world = plan.part(state.pose), plan.base.rotation
    lever = state.pose.rotation @ plan.grasp.position
    velocity = world @ (state.velocity + np.cross(state.angular_velocity, lever))
    spin = part.rotation.T @ world @ state.angular_velocity
    return np.concatenate([part.position, rotations.quaternion(part.rotation), velocity, spin])


def rotations_are_inverse_to_each_other() -> str:
    """Vector, matrix and quaternion, also at half a turn."""
    random = np.random.default_rng(3)
    for angle in (0.0, 1e-9, 1e-4, 1.0, 3.0, np.pi - 1e-7, np.pi):
        axis = random.normal(size=3)
        turn = angle * axis / np.linalg.norm(axis)
        rotation = rotations.of_vector(turn)
        for again in (
            rotations.of_vector(rotations.vector(rotation)),
            rotations.matrix(rotations.quaternion(rotation)),
        ):
            if np.abs(again - rotation).max() > 1e-6:
                return f"angle {angle:g}: {np.abs(again - rotation).max():g}"
    return ""


def guards_stop_at_joints_and_times() -> str:
    """Each measurement that is wrong in one way is refused with its words, and one that is right is not."""
    plan = plan_of("corner-six")
    reference = plan.reference(0.0)
    right = Measurement(0.0, plan.arm.start, np.zeros(6), reference, np.zeros(3), np.zeros(3))
    next_ = dataclasses.replace(right, time=0.002)
    at_limit = np.where(np.arange(6) == 2, plan.arm.upper - 0.01, plan.arm.start)
    moved = dataclasses.replace(reference, pose=Pose(reference.pose.position + 1.0, reference.pose.rotation))
    beside = dataclasses.replace(
        reference, pose=Pose(reference.pose.position + np.array([0.011, 0, 0]), reference.pose.rotation)
    )
    unknown = np.full(6, np.nan)
    wrong = {
        "within 0.02 of its limits": {"positions": at_limit},
        "its limit is": {"speeds": 1.01 * plan.arm.speed},
        "longer than 0.1 s": {"time": 0.2},
        "does not go on": {"time": 0.0},
        "by -1.000 s": {"time": -1.0},
        "force of": {"force": np.full(3, 1e3)},
        "torque of": {"torque": np.full(3, 1e3)},
        "from its reference": {"tool": moved},
        "from where its joints have it": {"tool": beside},
        "joint `": {"positions": unknown},
        "moves at nan": {"speeds": unknown},
        "nan s": {"time": np.nan},
        "force of nan": {"force": np.full(3, np.nan)},
    }
    for words, change in ({"": {}} | wrong).items():
        said = stopped(plan, right, dataclasses.replace(next_, **change), reference)
        if (words not in said) or (not words and said):
            return f"{change}: {said!r}, expected {words!r}"
    slow = [dataclasses.replace(right, time=0.09 * step) for step in range(1, 20)]
    said = [stopped(plan, right, measured, reference, slow[:index]) for index, measured in enumerate(slow)]
    return "" if "takes longer" in said[-1] else f"no end of time: {said[-1]!r}"


def what_is_no_number_stops_in_every_phase() -> str:
    """Each signal, as NaN and as infinity of both signs."""
    return no_numbers.all_problems(plan_of("corner-six"))


def stopped(plan, at_rest, measured, reference, before=()) -> str:
    """Why guards that allow a second stop at a measurement, or nothing."""
    guards = Guards(plan, at_rest, 1.0)
    limits = Limits.of(plan.document["guards"]["insertion"])
    try:
        for earlier in [*before, measured]:
            guards.check(earlier, reference, limits, in_free_air=False)
    except Stopped as error:
        return str(error)
    return ""


def stand_ins_have_the_signatures_of_the_packages() -> str:
    """Names and order of parameters of every function that a stand-in has; it may leave out the last ones."""
    problems = []
    for folder, modules in (("ur", ("rtde_control", "rtde_receive", "dashboard_client")), ("franka", ("franky",))):
        for name in modules:
            known = package_signatures(name)
            if known is None:
                print(f"       {name} is not installed: its stand-in is compared with nothing")
                continue
            source = (HERE / "stand_ins" / folder / f"{name}.py").read_text()
            for function, parameters in functions_of(source):
                if function not in known:
                    problems.append(f"{name} has no {function}")
                elif known[function] is not None and not any(
                    own[: len(parameters)] == parameters for own in known[function]
                ):
                    problems.append(f"{function}: {parameters}, the package has {known[function]}")
    return "; ".join(problems)


def functions_of(source: str) -> list[tuple[str, list[str]]]:
    """Class.function and parameters of public functions in a file, but for its own helpers."""
    found = []
    for kind in [node for node in ast.parse(source).body if isinstance(node, ast.ClassDef)]:
        for function in [node for node in kind.body if isinstance(node, ast.FunctionDef)]:
            if (function.name.startswith("_") and function.name != "__init__") or function.name == "step":
                continue
            arguments = [argument.arg for argument in function.args.args[1:]]
            if kind.name not in ("Duration", "RobotState") or function.name != "__init__":
                found.append((f"{kind.name}.{function.name}", arguments))
    return found


def package_signatures(name: str) -> dict[str, list[list[str]] | None] | None:
    """All signatures of the classes of an installed package, by Class.function; none where it is not installed."""
    specification = importlib.util.find_spec(name)
    if specification is None:
        return None
    module = importlib.import_module(name)
    known: dict[str, list[list[str]] | None] = {}
    for kind, item in inspect.getmembers(module, inspect.isclass):
        for function in dir(item):
            member = getattr(item, function)
            text = getattr(member, "__doc__", None) or ""
            signatures = re.findall(rf"{function}\((.*)\) ->", text)
            known[f"{kind}.{function}"] = [parameters_of(signature) for signature in signatures] or None
    return known


def parameters_of(signature: str) -> list[str]:
    """Names of the parameters of a signature but for `self`."""
    depth, parts = 0, [""]
    for letter in signature:
        depth += {"[": 1, "(": 1, "]": -1, ")": -1}.get(letter, 0)
        if letter == "," and depth == 0:
            parts.append("")
        else:
            parts[-1] += letter
    return [part.split(":")[0].split("=")[0].strip() for part in parts if part.strip()][1:]


ALL = [
    kinematics_are_those_of_the_urdf_file,
    the_law_is_that_of_the_plan,
    rotations_are_inverse_to_each_other,
    guards_stop_at_joints_and_times,
    what_is_no_number_stops_in_every_phase,
    stand_ins_have_the_signatures_of_the_packages,
]
