"""Whether a case ended as it should."""

import csv
import json
import pathlib
import signal

from lab.players.case import Case

# What the players say of success: distance (m) and angle (rad) to the goal.
POSITION_TOLERANCE, ANGLE_TOLERANCE = 0.003, 0.1
# Largest force (N) on something that stands in free air: that of the guard, and what a millisecond of an impact adds.
LARGEST_TOUCH = 200.0


def judge(case: Case, code: int, said: str, folder: pathlib.Path) -> str:
    """What is wrong with the end of a case."""
    if code != case.code or case.says not in said or "Traceback" in said:
        return f"exit code {code}, expected {case.code} and `{case.says}`:\n{said}"
    if problem := problem_of_outcome(case, code, folder) or problem_of_log(case, code, folder):
        return f"{problem}\n{said}"
    return ""


def problem_of_outcome(case: Case, code: int, folder: pathlib.Path) -> str:
    """How the robot was left, as the simulation knows it."""
    outcome = folder / "outcome.json"
    if not outcome.exists():
        return "" if code in (2, 3, -signal.SIGKILL) else "the robot was not left"
    left = json.loads(outcome.read_text())
    if left["mode"] != "position":
        return f"the robot was left in mode {left['mode']}"
    if code == 2 and left["commands"] and "gains" not in case.says:
        return f"a player that refuses has sent {left['commands']} commands"
    if left["obstacle_force_n"] > LARGEST_TOUCH:
        return f"the tool pressed an obstacle with {left['obstacle_force_n']:.0f} N"
    is_inside = left["position_error_m"] <= POSITION_TOLERANCE and left["angle_error_rad"] <= ANGLE_TOLERANCE
    return f"the part is not at its goal: {left}" if case.inserts and not is_inside else ""


def problem_of_log(case: Case, code: int, folder: pathlib.Path) -> str:
    """Whether the log tells what was said."""
    log = folder / case.log
    if not case.has_receiver or code not in (0, 1, 130, -signal.SIGKILL):
        return ""
    with log.open(newline="") as file:
        header = json.loads(file.readline().removeprefix("#"))
        rows = list(csv.DictReader(file))
    # Faults from the beginning and a script that refuses leave no rows.
    is_empty = not rows and (code == 0 or case.interrupted_at != "")
    if is_empty or any(len(row) != len(rows[0]) or None in row.values() for row in rows):
        return "the log is empty or broken"
    reason = header.get("stopped", "")
    if (code != 0) != bool(reason) or (
        case.target != "urscript" and code in (1, 130) and case.says.removeprefix("stopped: ") not in reason
    ):
        return f"the log does not say why the robot was stopped: {header}"
    return ""
