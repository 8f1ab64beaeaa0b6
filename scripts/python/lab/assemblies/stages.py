"""The stages of an assembly, each of which adds to what is known of it."""

import argparse
import dataclasses
import json
import math
import pathlib
import re
import zlib

from lab import program, tables
from lab.errors import Failure

FRICTIONS = ("0.1", "0.3", "0.5")
OFFSET_M, TURN_RAD = 0.002, math.radians(5.0)
# A pair is active that pushes with more at some time (N).
PUSHING_N = 0.01


def run(arguments: argparse.Namespace, name: str) -> dict:
    """What is known of an assembly after all stages that are asked for."""
    record = arguments.out / f"{name}.json"
    known = json.loads(record.read_text()) if record.exists() else {}
    for stage in (read, plan, play):
        if stage.__name__ not in known and known.get("read", {"outcome": "read"})["outcome"] == "read":
            known[stage.__name__] = stage(arguments, name, known)
            unfinished = record.with_suffix(".unfinished")
            unfinished.write_text(json.dumps(known, indent=1))
            unfinished.rename(record)
        if stage.__name__ == arguments.only:
            break
    return known


def read(arguments: argparse.Namespace, name: str, _: dict) -> dict:
    """Makes the scene, checks it and says how both went."""
    folder, out = arguments.folder / name, arguments.out / name
    out.mkdir(exist_ok=True)
    scene, log = out / "scene.toml", out / "new.log"
    files = ["--body", folder / "plug.obj", "--environment", folder / "socket.obj"]
    options = ["--unit", arguments.unit, "--axis", arguments.axis, "--offset", OFFSET_M]
    made = measured(arguments, log, "new", "--force", scene, *files, *options)
    usage = {"new": dataclasses.asdict(made)}
    if made.code != 0:
        return usage | refused(log)
    log = out / "check.log"
    checked = measured(arguments, log, "check", scene, "--json")
    usage["check"] = dataclasses.asdict(checked)
    if checked.code not in program.RESULTS:
        return usage | refused(log)
    report = report_in(log)
    if report["refusal"]:
        return usage | {"outcome": "refused", "reason": report["refusal"]}
    kept = {key: report[key] for key in ("pairs", "gaps", "engagement", "position_tolerance_m")}
    return usage | kept | {"outcome": "read", "pieces": [len(report[side]) for side in ("body", "environment")]}


def plan(arguments: argparse.Namespace, name: str, known: dict) -> dict:
    """Plans from a start that is turned."""
    out = arguments.out / name
    scene, folder, log = out / "turned.toml", out / "plan", out / "plan.log"
    out_of_socket = known["read"]["engagement"]["out"]
    scene.write_text(with_turned_start((out / "scene.toml").read_text(), turn(name, out_of_socket)))
    options = ["--friction", ",".join(FRICTIONS), "--time-limit", arguments.time, "--jobs", arguments.jobs]
    used = measured(arguments, log, "solve", scene, "--robust", *options, "--out", folder)
    if used.code not in program.RESULTS or not (folder / "result.json").exists():
        return {"solve": dataclasses.asdict(used), "status": "no plan", "reason": last_line(log)}
    result = json.loads((folder / "result.json").read_text())
    robust = result.get("robust") or {}
    rates = {}
    for row in robust.get("after", []):
        counts = rates.setdefault(f"{row['friction']:g}", [0, 0])
        counts[0] += row["successes"]
        counts[1] += row["rollouts"]
    forces = [row["max_force_n"] for row in robust.get("after", [])]
    return {
        "solve": dataclasses.asdict(used),
        "status": result["status"],
        "optimal_control_s": result["wall_s"],
        "active_pairs": active_pairs(folder),
        "rates": {friction: good / count for friction, (good, count) in rates.items() if count},
        "largest_force_n": max(forces, default=None),
    }


def play(arguments: argparse.Namespace, name: str, known: dict) -> dict:
    """Plays the plan, and the straight push, in MuJoCo."""
    folder = arguments.out / name / "plan"
    if known["plan"]["status"] == "no plan":
        return {}
    motions = arguments.out / name / "mujoco.csv"
    options = ["--seed", 7, "--jobs", arguments.jobs, "--friction", ",".join(FRICTIONS), "--random", arguments.count]
    program.validate(folder, motions, *options)
    rows = tables.read(motions)
    successes = {
        motion: {friction: tables.successes(rows, motion, friction) for friction in FRICTIONS}
        for motion in ("plan", "straight push")
    }
    return {"successes": successes}


def measured(arguments: argparse.Namespace, log: pathlib.Path, *command: object) -> program.Usage:
    """Runs the program; what it says is in a log. A refusal is a result."""
    return program.measured(*command, log=log, program=arguments.program, accepted=(0, 1, 2))


def refused(log: pathlib.Path) -> dict:
    """Why there is no scene, from what the program said."""
    reason = last_line(log)
    reason = reason.removeprefix("error: ").partition(": ")[2] or reason
    kinds = [kind for kind in ("press fit", "snap fit") if reason.startswith(f"a {kind}: ")]
    return {"outcome": kinds[0] if kinds else "refused", "reason": reason}


def last_line(log: pathlib.Path) -> str:
    """The error in a log, or else its last line."""
    lines = log.read_text().splitlines() or [""]
    return next((line for line in lines if line.startswith("error: ")), lines[-1])


def report_in(log: pathlib.Path) -> dict:
    """The report of `check --json` in a log, behind what was said before."""
    text = log.read_text()
    begin = text.find("{")
    if begin < 0:
        raise Failure(f"{log}: no report")
    return json.JSONDecoder().raw_decode(text, begin)[0]


def turn(name: str, out: list[float]) -> list[float]:
    """A turn (quaternion w x y z) about an axis across the way out that follows from the name."""
    smallest = min(range(3), key=lambda axis: abs(out[axis]))
    across = cross(out, [float(axis == smallest) for axis in range(3)])
    length = math.sqrt(sum(component**2 for component in across))
    across = [component / length for component in across]
    angle = math.tau * zlib.crc32(name.encode()) / 2**32
    axis = [math.cos(angle) * u + math.sin(angle) * v for u, v in zip(across, cross(out, across))]
    return [math.cos(TURN_RAD / 2), *(math.sin(TURN_RAD / 2) * component for component in axis)]


def cross(one: list[float], other: list[float]) -> list[float]:
    """The cross product."""
    (a, b, c), (x, y, z) = one, other
    return [b * z - c * y, c * x - a * z, a * y - b * x]


def with_turned_start(scene: str, quaternion: list[float]) -> str:
    """The text of a scene whose first start has another orientation."""
    orientation = re.compile(r"(\[\[start\]\][^\[]*position = \[[^\]]*\]\s*orientation = )\[[^\]]*\]")
    text, count = orientation.subn(lambda found: found[1] + json.dumps(quaternion), scene, count=1)
    if count != 1:
        raise Failure("the scene has no start with an orientation")
    return text


def active_pairs(folder: pathlib.Path) -> int:
    """Number of pairs that push in the plan."""
    rows = tables.read(folder / "contacts.csv")
    return len({row["pair"] for row in rows if float(row["force_n"]) > PUSHING_N})
