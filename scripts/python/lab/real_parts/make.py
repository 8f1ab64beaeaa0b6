"""Makes and plays the plan of a pair."""

import argparse
import pathlib
import subprocess

from lab import program, toml

HERE = pathlib.Path(__file__).resolve().parent
FRICTIONS = ("0.0", "0.1", "0.3")
# The motions of a pair in MuJoCo.
MOTIONS = "mujoco.csv"


def part(keys: dict, folder: pathlib.Path) -> dict:
    """A part with these keys. Its file is in a folder or here."""
    files = {key: keys[key] for key in ("mesh", "model") if key in keys}
    found = {
        key: next(place / file for place in (folder, HERE) if (place / file).exists()) for key, file in files.items()
    }
    return keys | {key: str(file) for key, file in found.items()}


def scene_of(pair: dict, folder: pathlib.Path) -> dict:
    """The scene of a pair of files."""

    def pose(numbers: list[float]) -> dict:
        return {"position": numbers[:3], "orientation": numbers[3:]}

    return {
        "title": pair["name"],
        "body": {"part": [{"name": "body"} | part(pair["body"], folder)]},
        "environment": {"part": [{"name": "socket"} | part(pair["environment"], folder)]},
        "start": [{"name": "1"} | pose(pair["start"])],
        "goal": pose(pair["goal"]),
        "robustness": {"offset_magnitude": pair["offset"], "rotation_error": pair.get("rotation_error", 0.0)},
    }


def run(arguments: argparse.Namespace, pair: dict, out: pathlib.Path) -> None:
    """Plans and plays a pair, unless that is done."""
    out.mkdir(parents=True, exist_ok=True)
    scene, plan, check = out / "scene.toml", out / "plan", out / "check.json"
    if "generate" in pair:
        program.run("generate", *pair["generate"], "--out", scene, "--force", accepted=(0,))
    else:
        scene.write_text(toml.text(scene_of(pair, arguments.folder)))
    if not check.exists():
        check.write_text(program.run("check", scene, "--json", output=subprocess.PIPE, accepted=(0,)))
    jobs = ["--jobs", arguments.jobs]
    if not (plan / "result.json").exists():
        program.run("solve", scene, "--robust", *jobs, "--time-limit", arguments.time_limit, "--out", plan)
    options = ["--seed", 7, *jobs, "--friction", ",".join(FRICTIONS), "--random", arguments.count]
    program.validate(plan, out / MOTIONS, *options)
