"""Records what tests compare with.

Only to be run when what is recorded changes: the records are kept in git.
"""

import argparse
import pathlib

from lab import program
from lab.errors import InputError
from lab.paths import ROOT

PACKAGES = ("mujoco", "numpy")
ARMS = ROOT / "crates/robot/tests/arms"


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Adds a command for every kind of record."""
    kinds = parser.add_subparsers(metavar="KIND", required=True)

    def kind(name: str, run: object, text: str) -> argparse.ArgumentParser:
        added = kinds.add_parser(name, help=text, description=text)
        added.set_defaults(run=run)
        return added

    arm = kind("arm", record_arm, "kinematics and dynamics of arms in MuJoCo, for the tests of the crate `robot`")
    arm.epilog = "`cargo run -p robot --example compare_arm -- URDF FILE` prints how the crate differs from a record."
    arm.add_argument("other", nargs="*", metavar="URDF TIP FILE", help="another arm, and the file of its record")
    kind("motions", record_motions, "motions of arms in MuJoCo, for the tests of the crate `simulation`")
    kind("mujoco", record_traces, "motions of the plans in tests/mujoco, for the tests of `simulate`")
    executions = kind(
        "executions", record_executions, "what players log of arms in MuJoCo, for the tests of `calibration`"
    )
    executions.add_argument("names", nargs="*", help="only these logs [default: all]")
    plans = kind(
        "player-plans", record_plans, "plans and exports of scenes for the arms in examples/arms, for `players`"
    )
    plans.add_argument("names", nargs="*", help="only these plans, corner-six for example [default: all]")
    plans.set_defaults(packages=())


def record_arm(arguments: argparse.Namespace) -> None:
    """Records the arms of the tests, or another."""
    from lab.recording import dynamics

    if arguments.other:
        if len(arguments.other) != 3:
            raise InputError("give URDF, TIP and FILE of one arm, or nothing")
        urdf, tip, file = arguments.other
        dynamics.write(urdf, tip, pathlib.Path(file))
    else:
        for name in ("six", "seven", "gantry"):
            dynamics.write(str(ARMS / f"{name}.urdf"), "tip", ARMS / f"{name}.json")


def record_motions(arguments: argparse.Namespace) -> None:
    """Records motions of arms."""
    from lab.recording import motions

    motions.write(ARMS, ROOT / "crates/simulation/tests/arms")


def record_traces(arguments: argparse.Namespace) -> None:
    """Records motions of plans."""
    from lab.recording import traces

    traces.write(ROOT / "tests/mujoco")


def record_executions(arguments: argparse.Namespace) -> None:
    """Records logs of players."""
    from lab.recording import executions

    executions.write(ROOT / "crates/calibration/tests/logs", arguments.names)


def record_plans(arguments: argparse.Namespace) -> None:
    """Records plans."""
    from lab.recording import player_plans

    program.build()
    player_plans.write(arguments.names)
