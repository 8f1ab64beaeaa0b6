"""What the user may choose, and how far."""

import argparse
import dataclasses
import pathlib
from typing import Any

import numpy as np

from exported_plan import ExportedPlan
from failures import InputError
from guards import Limits
from journal import FORMAT

# Gains may be this many times those of the plan, and a guard this many times its own.
LARGEST_FACTOR, LARGEST_GUARD = 5.0, 2.0
# Guards by their flags, their names in plan.json and what they are.
GUARDS = {
    "force": ("force_n", "N", "force"),
    "torque": ("torque_nm", "NM", "torque"),
    "distance": ("deviation_m", "M", "distance from the reference"),
    "angle": ("deviation_rad", "RAD", "angle to the reference"),
}


@dataclasses.dataclass(frozen=True)
class Settings:
    """Height of a dry run (m; 0 is none), whether frames are tested, whether the user says that the path to the start is free, and
    the guards of free air and of the plan itself."""

    dry_run: float
    self_test: bool
    path_is_free: bool
    approach: Limits
    playing: Limits


def add_flags(parser: argparse.ArgumentParser) -> None:
    """Flags of all players."""
    add = parser.add_argument
    add("--dry-run", type=float, default=0.0, metavar="M", help="play this far (m) from the goal, in free air")
    add("--stiffness-factor", type=float, default=1.0, metavar="F", help="stiffness of the robot over that of the plan")
    add("--damping-factor", type=float, default=1.0, metavar="F", help="factor on damping")
    add("--skip-self-test", action="store_true", help="do not move along each axis first to test the frames")
    add("--path-is-free", action="store_true", help="the straight path to the start touches nothing: I have looked")
    for flag, (_, unit, words) in GUARDS.items():
        add(f"--{flag}-limit", type=float, metavar=unit, help=f"stop beyond this {words} [default: that of plan.json]")
    add("--log", type=pathlib.Path, metavar="FILE", help="a new file [default: executed.csv, or executed-2.csv and so on]")


def settings(arguments: argparse.Namespace, plan: ExportedPlan) -> Settings:
    """What the flags say."""
    require_between(arguments, "stiffness_factor", LARGEST_FACTOR)
    require_between(arguments, "damping_factor", LARGEST_FACTOR)
    guards = plan.document["guards"]
    free = Limits.of(guards["approach"])
    own = guards["dry_run" if arguments.dry_run else "insertion"]
    chosen = dict(own)
    for flag, (name, _, _) in GUARDS.items():
        if getattr(arguments, f"{flag}_limit") is not None:
            require_between(arguments, f"{flag}_limit", LARGEST_GUARD * own[name])
            chosen[name] = getattr(arguments, f"{flag}_limit")
    require_free(arguments.dry_run, plan)
    playing = Limits.of(chosen)
    return Settings(arguments.dry_run, not arguments.skip_self_test, arguments.path_is_free, free.within(playing), playing)


def require_free(height: float, plan: ExportedPlan) -> None:
    """Refuses a dry run that is not in free air."""
    intervals = plan.document["free"]["heights_m"]
    if height == 0 or any(low <= height <= high for low, high in intervals):
        return
    free = " or ".join(f"{low:.3f} to {high:.3f}" for low, high in intervals)
    advice = f"choose {free} m" if free else "there is no height at which it is"
    raise InputError(f"--dry-run {height:g} is not in free air, with the offset of the plan and a margin: {advice}")


def header(arguments: argparse.Namespace, plan: ExportedPlan) -> dict[str, Any]:
    """What a log says of its session: the plan, its frames, the dry run (m), and the gains as they are set. Of a law for position or
    force also whether its spring acts on the pose that is commanded or on the one that is measured."""
    document, impedance = plan.document, dict(plan.document["impedance"])
    for kind, factor in (("stiffness", arguments.stiffness_factor), ("damping", arguments.damping_factor)):
        for name in (f"translational_{kind}", f"rotational_{kind}"):
            impedance[name] = (factor * np.array(impedance[name])).tolist()
    names = ("scene", "start", "problem", "delta_m", "base", "grasp", "goal", "admittance")
    copied = {name: document[name] for name in names if document.get(name) is not None}
    if "admittance" in copied:
        copied["spring_acts_on"] = getattr(arguments, "spring_acts_on", "measured pose")
    return {"format": FORMAT, **copied, "dry_run_m": arguments.dry_run, "impedance": impedance}


def position_law(arguments: argparse.Namespace, plan: ExportedPlan) -> dict[str, Any]:
    """The admittance law of a plan for a robot that is commanded by position."""
    law = plan.document.get("admittance")
    if law is None or law["interface"] != "position":
        raise InputError('this player needs a plan for a robot that is commanded by position: robot.interface = "position" in the scene')
    if arguments.damping_factor < 1:
        raise InputError(f"--damping-factor {arguments.damping_factor:g}: with less damping than planned the law oscillates in contact")
    return law


def require_between(arguments: argparse.Namespace, name: str, largest: float) -> None:
    """Refuses a flag that is not above zero, or too large."""
    value = getattr(arguments, name)
    if not 0 < value <= largest:
        raise InputError(f"--{name.replace('_', '-')} {value:g} must lie above 0 and not above {largest:.3g}")
