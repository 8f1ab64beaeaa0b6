"""Receives what `plan.script` sends while the robot runs it, and writes the log: start it before the script.

A line of the script is a word and what belongs to it, behind a blank: `session` with dry run (m), factors of stiffness and
damping; `playing` or `resting` with a row; `stopped` with a reason; `done`."""

import argparse
import json
import pathlib
import signal
import socket
import sys
from collections.abc import Iterable

import numpy as np

import rotations
from exported_plan import ExportedPlan, InputError, ToolState, load
from guards import Measurement
from journal import Journal
from kinematics import Pose
from session import DONE, FAILED, INTERRUPTED, MISSED, WRONG_INPUT, header, interrupt

# Where `plan.script` connects to.
PORT = 50042
# Numbers of a row: time (s); pose, twist, force and torque of the tool; pose and twist of its reference. Poses are position (m)
# and rotation vector (rad), everything is along the axes of the root of the URDF file.
TIME, STATE, WRENCH = 1, 12, 6
NUMBERS = TIME + STATE + WRENCH + STATE


def receive(lines: Iterable[str], plan: ExportedPlan, journal: Journal) -> bool:
    """Keeps what the script sends until it ends; returns whether it played the plan."""
    begin = last = 0.0
    for line in lines:
        word, _, rest = line.strip().partition(" ")
        if word == "session":
            dry_run, stiffness, damping = numbers(rest, 3)
            factors = {"stiffness_factor": stiffness, "damping_factor": damping}
            journal.header = header(argparse.Namespace(dry_run=dry_run, **factors), plan)
        elif word in ("playing", "resting"):
            row = numbers(rest, NUMBERS)
            if word != journal.phase:
                begin = row[0] if word == "playing" else last
                journal.start(word, begin)
            last = row[0]
            journal.add(measurement(row), tool_state(row[-STATE:]))
        elif word == "stopped":
            journal.header["stopped"] = rest
            journal.say(f"stopped: {rest}")
            return False
        elif word == "done":
            return True
        else:
            raise InputError(f"`{line.strip()}` is nothing that plan.script sends: export the plan again, and load the new script")
    journal.header["stopped"] = "the script or its connection ended"
    journal.say("stopped: the script or its connection ended before the plan was played")
    return False


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


def main() -> int:
    """Waits for one run of the script; returns the exit code."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    add = parser.add_argument
    add("--address", default="", help="address of this computer at which to wait [default: all that it has]")
    add("--port", type=int, default=PORT, help="port, as in plan.script [default: %(default)s]")
    add("--log", type=pathlib.Path, default=pathlib.Path("executed.csv"), metavar="FILE", help="[default: %(default)s]")
    arguments = parser.parse_args()
    signal.signal(signal.SIGTERM, interrupt)
    try:
        plan = load(pathlib.Path(__file__).resolve().parent)
        with socket.create_server((arguments.address, arguments.port)) as server:
            print(f"waiting for plan.script at port {arguments.port}", file=sys.stderr, flush=True)
            connection, (robot, _) = server.accept()
        journal = Journal(plan, arguments.log, {})
        journal.say(f"connected to {robot}")
        with connection, connection.makefile(encoding="ascii", errors="replace") as lines:
            try:
                return DONE if receive(lines, plan, journal) else MISSED
            except KeyboardInterrupt:
                journal.header["stopped"] = "the receiver was interrupted"
                raise
            finally:
                journal.write()
    except KeyboardInterrupt:
        print("interrupted; the robot goes on", file=sys.stderr)
        return INTERRUPTED
    except InputError as error:
        print(f"error: {error}", file=sys.stderr)
        return WRONG_INPUT
    except OSError as error:
        print(f"error: {error}", file=sys.stderr)
        return FAILED


if __name__ == "__main__":
    sys.exit(main())
