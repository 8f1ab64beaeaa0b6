"""Command line of the validation in MuJoCo."""

import argparse
import functools
import pathlib

DESCRIPTION = """\
Plays plans of `assembly-plan solve` through MuJoCo and prints how often they succeed.

The body moves freely, driven by the impedance wrench alone, at offsets (errors of the part in the gripper, body frame)
that are injected as in the plan: the body starts displaced by the offset and the controller never learns of it. After
the last knot the reference rests for the settling time, then the final pose is judged."""

EPILOG = """\
Exit codes: 0 done, 1 the self-test failed, 2 wrong input or usage, 3 anything else, 130 interrupted.

Examples:
  scripts/validate_mujoco out/peg1-1 --position-tolerance 0.005 --friction 0,0.1,0.3
  scripts/validate_mujoco out/clamp1-* --magnitudes 0mm,2mm,4mm,5mm --jobs 2 --csv clamp1.csv"""


def parse_arguments() -> argparse.Namespace:
    """Reads the command line."""
    parser = argparse.ArgumentParser(
        prog="scripts/validate_mujoco",
        description=DESCRIPTION,
        epilog=EPILOG,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    add = parser.add_argument
    add("folders", nargs="*", type=pathlib.Path, metavar="SCENE_OUT_DIR", help="folders that `solve` wrote")
    add("--friction", default="0,0.1", metavar="LIST", help="Coulomb friction coefficients [default: %(default)s]")
    add(
        "--magnitudes",
        default="0,0.25,0.5,0.75,-1mm",
        metavar="LIST",
        help="offset magnitudes: fractions of delta-hat, lengths (2mm), or delta-hat less a length (-1mm) "
        "[default: %(default)s]; write --magnitudes=-1mm if the list starts with a minus sign",
    )
    add("--count", type=positive(int), default=20, metavar="N", help="random offsets per magnitude [default: 20]")
    add("--seed", type=int, default=1, metavar="N", help="seed of the random offsets [default: 1]")
    add(
        "--offsets",
        default="random",
        metavar="planned|random|FILE",
        help="the planned offsets scaled to the magnitude, random convex combinations of them [default], or those of a "
        "CSV file with the header x_m,y_m,z_m",
    )
    add(
        "--position-tolerance",
        type=positive(float),
        metavar="M",
        help="largest final position error [default: that with which `solve` judges its scenarios]",
    )
    add(
        "--angle-tolerance", type=positive(float), metavar="RAD", help="largest final angle [default: likewise]"
    )
    add("--settling-time", type=positive(float), default=1.0, metavar="S", help="rest before judging [default: 1 s]")
    add("--time-step", type=positive(float), default=0.0005, metavar="S", help="of the simulation [default: 0.0005 s]")
    add(
        "--baseline",
        action=argparse.BooleanOptionalAction,
        default=True,
        help="also play an unplanned straight push from start to goal in the plan's time [default: yes]",
    )
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
    arguments = parser.parse_args()
    if not arguments.folders and not arguments.self_test:
        parser.error("name at least one folder, or --self-test")
    return arguments


def positive(kind: type) -> functools.partial:
    """Parser of numbers above zero."""
    return functools.partial(parse_positive, kind)


def parse_positive(kind: type, text: str) -> float:
    """A number above zero."""
    number = kind(text)
    if not 0 < number < float("inf"):
        raise argparse.ArgumentTypeError(f"{text} is not above zero")
    return number
