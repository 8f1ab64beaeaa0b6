"""Command line of the validation in other simulators."""

import argparse
import functools
import pathlib

from lab.errors import InputError

# Magnitudes of offsets in a hull, and in a disc or a ball, which hold all smaller ones.
HULL_MAGNITUDES, ROUND_MAGNITUDES = "0,0.25,0.5,0.75,-1mm", "1"


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Adds its arguments."""
    add = parser.add_argument
    add("folders", nargs="*", type=pathlib.Path, metavar="SCENE_OUT_DIR", help="folders that `solve` wrote")
    add(
        "--friction",
        default="0,0.1,0.3",
        metavar="MU,MU,...",
        help="Coulomb friction coefficients [default: %(default)s]",
    )
    add(
        "--magnitude",
        metavar="LIST",
        help="offset magnitudes: fractions of delta-hat, lengths (2mm), or delta-hat less a length (-1mm) "
        f"[default: {HULL_MAGNITUDES} in a hull, {ROUND_MAGNITUDES} in a disc or a ball]; "
        "write --magnitude=-1mm if the list starts with a minus sign",
    )
    add("--random", type=positive(int), default=20, metavar="N", help="random offsets per magnitude [default: 20]")
    add("--seed", type=int, default=1, metavar="N", help="seed of the random offsets [default: 1]")
    add(
        "--offsets",
        default="random",
        metavar="planned|random|hull|disc|ball|FILE",
        help="the planned offsets scaled to the magnitude; random ones of those that the plan covers [default], or of "
        "the hull, disc or ball; or those of a CSV file with the header x_m,y_m,z_m",
    )
    add(
        "--rotation-error",
        type=not_negative,
        metavar="RAD",
        help="the part is also rotated in the gripper, at random, by up to this [default: the plan's, else 0]",
    )
    add(
        "--position-tolerance",
        type=positive(float),
        metavar="M",
        help="largest final position error [default: that with which `solve` judges its scenarios]",
    )
    add("--angle-tolerance", type=positive(float), metavar="RAD", help="largest final angle [default: that of `solve`]")
    add("--settling-time", type=positive(float), default=1.0, metavar="S", help="rest before judging [default: 1 s]")
    add(
        "--engine",
        choices=("mujoco", "drake"),
        default="mujoco",
        help="simulator; drake plays free bodies and arms with torques [default: %(default)s]",
    )
    add(
        "--time-step",
        type=positive(float),
        metavar="S",
        help="of the simulation [default: 0.0005 s in MuJoCo, 0.00025 s in Drake]",
    )
    add(
        "--contact-stiffness",
        type=positive(float),
        default=1e6,
        metavar="N/M",
        help="of each point of contact in Drake [default: 1e6; 1e7 is rigid at edges, too]",
    )
    add(
        "--hydroelastic-modulus",
        type=positive(float),
        metavar="PA",
        help="contact over surfaces in Drake, not at points: pressure in the middle of the body's pieces",
    )
    add(
        "--baseline",
        action=argparse.BooleanOptionalAction,
        default=True,
        help="also play an unplanned straight push from start to goal in the plan's time [default: yes]",
    )
    add_arm(parser.add_argument_group("whole arm"))
    add("--scene", type=pathlib.Path, metavar="FILE", help="take shapes from this scene file, not from resolved.toml")
    add("--jobs", type=positive(int), default=1, metavar="N", help="processes [default: 1]")
    add("--csv", type=pathlib.Path, metavar="FILE", help="also write every motion's outcome")
    add(
        "--trace",
        type=pathlib.Path,
        metavar="FILE",
        help="instead of tables write one motion, with the columns of reference.csv: the first folder's plan at the "
        "first friction and the first offset",
    )
    add(
        "--compare",
        type=pathlib.Path,
        metavar="FILE",
        help="instead of tables play what is in the rollouts.csv of `assembly-plan simulate` and compare the outcomes",
    )
    add("--self-test", action="store_true", help="compare the simulation with known solutions")


def check(arguments: argparse.Namespace) -> None:
    """Refuses arguments that do not go together."""
    if not arguments.folders and not arguments.self_test:
        raise InputError("name at least one folder, or --self-test")
    if arguments.engine == "drake" and arguments.trace:
        raise InputError("--trace needs --engine mujoco")
    if arguments.hydroelastic_modulus and arguments.engine != "drake":
        raise InputError("--hydroelastic-modulus needs --engine drake")
    optional = (arguments.robot, arguments.joint_friction)
    is_given = optional != (None, None) or arguments.gain_factor != 1 or arguments.delay > 0
    if is_given and not arguments.arm:
        raise InputError("--robot, --gain-factor, --joint-friction and --delay need --arm")


def add_arm(group: argparse._ArgumentGroup) -> None:
    """Flags of the whole arm."""
    add = group.add_argument
    add("--arm", action="store_true", help="play with the arm of the plan's [robot] table and the plan's gains")
    add("--robot", type=pathlib.Path, metavar="FILE", help="take the [robot] table of this TOML file")
    add(
        "--gain-factor",
        type=positive(float),
        default=1.0,
        metavar="F",
        help="stiffness and damping times this, for plans of a body that is lighter than the arm seems [default: 1]",
    )
    add("--joint-friction", type=not_negative, metavar="NM", help="of every joint [default: the robot's]")
    add("--delay", type=not_negative, default=0.0, metavar="S", help="of the torques [default: 0 s]")


def positive(kind: type) -> functools.partial:
    """Parser of numbers above zero."""
    return functools.partial(parse_positive, kind)


def parse_positive(kind: type, text: str) -> float:
    """A number above zero."""
    number = kind(text)
    if not 0 < number < float("inf"):
        raise argparse.ArgumentTypeError(f"{text} is not above zero")
    return number


def not_negative(text: str) -> float:
    """A number that is not below zero."""
    number = float(text)
    if not 0 <= number < float("inf"):
        raise argparse.ArgumentTypeError(f"{text} is below zero or no finite number")
    return number
