"""Receives what `plan.script` sends while the robot runs it, and writes the log: start it before the script.

A line of the script is a word and what belongs to it, behind a blank: `session` with dry run (m), factors of stiffness and
damping; a phase with a row; `stopped` with a reason; `done`."""

import argparse
import json
import pathlib
import socket
import sys
from collections.abc import Iterable
from typing import Any

import numpy as np

import rotations
from exported_plan import ExportedPlan, ToolState, load
from failures import InputError, Stopped
from guards import Measurement
from interruption import Interruption
from journal import Journal, say
from kinematics import Pose
from session import exit_code, keeping
from settings import header

# Where `plan.script` connects to.
PORT = 50042
# Numbers of a row: time (s); pose, twist, force and torque of the tool; pose and twist of its reference. Poses are position (m)
# and rotation vector (rad), everything is along the axes of the root of the URDF file.
TIME, STATE, WRENCH = 1, 12, 6
NUMBERS = TIME + STATE + WRENCH + STATE
# Phases by their words in the script.
PHASES = {
    "holding": "holding",
    "approaching": "going to the start",
    "testing": "testing the frames",
    "playing": "playing",
    "resting": "resting",
}


def receive(lines: Iterable[str], plan: ExportedPlan, journal: Journal) -> bool:
    """Keeps what the script sends until it has played the plan. Stopped says why it did not."""
    for line in lines:
        word, _, rest = line.strip().partition(" ")
        if word == "session":
            journal.log.header = session(numbers(rest, 3), plan)
        elif word in PHASES:
            row = numbers(rest, NUMBERS)
            if PHASES[word] != journal.phase:
                journal.start(PHASES[word], row[0])
            journal.add(measurement(row), tool_state(row[-STATE:]))
        elif word == "stopped":
            raise Stopped(rest)
        elif word == "done":
            return True
        else:
            raise InputError(f"`{line.strip()}` is nothing that plan.script sends: export the plan again, and load the new script")
    raise Stopped("the script or its connection ended before the plan was played")


def session(values: list[float], plan: ExportedPlan) -> dict[str, Any]:
    """The header of a log, from dry run (m) and factors of stiffness and damping."""
    dry_run, stiffness, damping = values
    return header(argparse.Namespace(dry_run=dry_run, stiffness_factor=stiffness, damping_factor=damping), plan)


def numbers(text: str, count: int) -> list[float]:
    """A list as URScript writes it."""
    try:
        values = [float(value) for value in json.loads(text)]
    except (TypeError, ValueError):
        values = []
    if len(values) != count or not np.isfinite(values).all():
        raise InputError(f"`{text}` is no list of {count} numbers: export the plan again, and load the new script")
    return values


def tool_state(values: list[float]) -> ToolState:
    """Pose and twist of the tool."""
    position, turn, velocity, spin = np.array(values).reshape(4, 3)
    return ToolState(Pose(position, rotations.of_vector(turn)), velocity, spin)


def measurement(row: list[float]) -> Measurement:
    """What the robot said of itself. Nobody asked it for its joints."""
    unknown, wrench = np.empty(0), np.array(row[TIME + STATE : -STATE])
    return Measurement(row[0], unknown, unknown, tool_state(row[TIME : TIME + STATE]), wrench[:3], wrench[3:])


def run(arguments: argparse.Namespace, _: Interruption) -> bool:
    """Waits for one run of the script and writes its log; returns whether it played the plan."""
    plan = load(pathlib.Path(__file__).resolve().parent)
    journal = Journal(plan, arguments.log, session([0.0, 1.0, 1.0], plan))
    return keeping(journal, lambda: listen(arguments, plan, journal))


def listen(arguments: argparse.Namespace, plan: ExportedPlan, journal: Journal) -> bool:
    """One run of the script."""
    with socket.create_server((arguments.address, arguments.port)) as server:
        say(f"waiting for plan.script at port {arguments.port}")
        connection, (robot, _) = server.accept()
    say(f"connected to {robot}")
    with connection, connection.makefile(encoding="ascii", errors="replace") as lines:
        return receive(lines, plan, journal)


def main() -> int:
    """Returns the exit code."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    add = parser.add_argument
    add("--address", default="", help="address of this computer at which to wait [default: all that it has]")
    add("--port", type=int, default=PORT, help="port, as in plan.script [default: %(default)s]")
    add("--log", type=pathlib.Path, metavar="FILE", help="a new file [default: executed.csv, or executed-2.csv and so on]")
    arguments = parser.parse_args()
    return exit_code(lambda interruption: run(arguments, interruption))


if __name__ == "__main__":
    sys.exit(main())
