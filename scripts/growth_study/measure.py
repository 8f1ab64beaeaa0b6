"""One solve in a process of its own: what it took and what came out."""

import hashlib
import json
import os
import pathlib
import subprocess
import time

SPLIT = ("distances", "model", "linear_solver", "rest")
COLUMNS = (
    *("series", "steps", "scenarios", "pairs", "status", "iterations", "wall_s", "cpu_s", "peak_memory_mb"),
    *(f"{part}_s" for part in SPLIT),
)


def measured(program: pathlib.Path, scene: str, folder: pathlib.Path) -> dict:
    """The measurement of a scene, made now unless the same program has already made it."""
    # Not read at once: a child's peak memory is counted from what its parent had when it began.
    with program.open("rb") as content:
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
    measurement = solve(program, folder)
    record.write_text(json.dumps({"made_of": made_of} | measurement, indent=1) + "\n")
    return measurement


def solve(program: pathlib.Path, folder: pathlib.Path) -> dict:
    """Solves the scene of a folder. Times contain starting, reading and writing; the split is that of the iterations."""
    plan = folder / "plan"
    with (folder / "log").open("w") as log:
        begin = time.perf_counter()
        command = [program, "solve", folder / "scene.toml", "--out", plan]
        child = subprocess.Popen(command, stdout=log, stderr=subprocess.STDOUT)
        _, status, usage = os.wait4(child.pid, 0)
        wall = time.perf_counter() - begin
    child.returncode = os.waitstatus_to_exitcode(status)
    # 1: a plan that misses the goal, which took its time as well.
    if child.returncode not in (0, 1):
        raise SystemExit(f"error: {folder / 'scene.toml'} was not solved; see {folder / 'log'}")
    result = json.loads((plan / "result.json").read_text())
    split = {f"{part}_s": sum(stage["wall_split_s"][part] for stage in result["stages"]) for part in SPLIT}
    return {
        "status": result["status"],
        "iterations": result["iterations"],
        "wall_s": wall,
        "cpu_s": usage.ru_utime + usage.ru_stime,
        "peak_memory_mb": usage.ru_maxrss * 1024 / 1e6,
    } | split
