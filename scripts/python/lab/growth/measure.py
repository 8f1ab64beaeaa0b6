"""One solve in a process of its own: what it took and what came out."""

import dataclasses
import hashlib
import json
import pathlib

from lab import program
from lab.paths import PROGRAM

SPLIT = ("distances", "model", "linear_solver", "rest")
COLUMNS = (
    *("series", "steps", "scenarios", "pairs", "status", "iterations", "wall_s", "cpu_s", "peak_memory_mb"),
    *(f"{part}_s" for part in SPLIT),
)


def measured(scene: str, folder: pathlib.Path) -> dict:
    """The measurement of a scene, made now unless the same program has already made it."""
    # Not read at once: a child's peak memory is counted from what its parent had when it began.
    with PROGRAM.open("rb") as content:
        digest = hashlib.file_digest(content, "sha256")
    digest.update(scene.encode())
    made_of = digest.hexdigest()
    record = folder / "measurement.json"
    if record.exists():
        earlier = json.loads(record.read_text())
        if earlier.pop("made_of") == made_of:
            return earlier
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "scene.toml").write_text(scene)
    measurement = solve(folder)
    record.write_text(json.dumps({"made_of": made_of} | measurement, indent=1) + "\n")
    return measurement


def solve(folder: pathlib.Path) -> dict:
    """Solves the scene of a folder. The split is that of the iterations."""
    plan = folder / "plan"
    usage = program.measured("solve", folder / "scene.toml", "--out", plan, log=folder / "log")
    result = json.loads((plan / "result.json").read_text())
    split = {f"{part}_s": sum(stage["wall_split_s"][part] for stage in result["stages"]) for part in SPLIT}
    return {"status": result["status"], "iterations": result["iterations"]} | dataclasses.asdict(usage) | split
