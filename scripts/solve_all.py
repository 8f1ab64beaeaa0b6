"""Solves scenes one after the other and prints what came out as a Markdown table."""

import json
import os
import pathlib
import re
import subprocess
import sys

COLUMNS = (
    "scene | start | iterations per stage | total | wall s | distances | model | linear solver | rest "
    "| objective | position errors mm | penetration mm | force N | status"
)


def start_names(scene: pathlib.Path) -> list[str]:
    """Names of all [[start]] tables."""
    tables = scene.read_text().split("[[start]]")[1:]
    return [re.search(r'^name = "(.*)"', table, re.MULTILINE).group(1) for table in tables]


def solve(program: str, scene: pathlib.Path, start: str, folder: pathlib.Path) -> dict:
    """Runs one solve and reads its result.json."""
    subprocess.run(
        [program, "solve", str(scene), "--start", start, "--out", str(folder)],
        stdout=subprocess.DEVNULL,
        check=False,
    )
    return json.loads((folder / "result.json").read_text())


def row(result: dict) -> str:
    """One line of the table."""
    stages = result["stages"]
    split = [sum(stage["wall_split_s"][part] for stage in stages) for part in ("distances", "model", "linear_solver", "rest")]
    scenarios = result["scenarios"]
    cells = [
        result["scene"],
        result["start"],
        "+".join(str(stage["iterations"]) for stage in stages),
        str(result["iterations"]),
        f"{result['wall_s']:.1f}",
        *(f"{seconds:.1f}" for seconds in split),
        f"{result['objective']:.4f}",
        " ".join(f"{1e3 * scenario['position_error_m']:.2f}" for scenario in scenarios),
        f"{1e3 * max(scenario['max_penetration_m'] for scenario in scenarios):.2f}",
        f"{max(scenario['max_force_n'] for scenario in scenarios):.1f}",
        result["status"],
    ]
    return "| " + " | ".join(cells) + " |"


def main() -> None:
    """Solves all scenes named on the command line, by default every one in scenes/."""
    root = pathlib.Path(sys.argv[1])
    arguments = [argument for argument in sys.argv[2:] if argument != "--all-starts"]
    target = pathlib.Path(os.environ.get("CARGO_TARGET_DIR", root / "target"))
    scenes = [pathlib.Path(name) for name in arguments] or sorted((root / "scenes").glob("*.toml"))
    print(f"| {COLUMNS} |\n|{'---|' * (COLUMNS.count('|') + 1)}", flush=True)
    for scene in scenes:
        names = start_names(scene)
        for start in names if "--all-starts" in sys.argv else names[:1]:
            folder = root / "out" / f"{scene.stem}-{start}"
            print(row(solve(str(target / "release/assembly-plan"), scene, start, folder)), flush=True)


main()
