"""Solves scenes one after the other and prints what came out as a Markdown table.

Iterations per homotopy stage, times and their split, objective and errors. Results go to out/.
"""

import argparse
import json
import pathlib
import tomllib

from lab import program, tables
from lab.paths import OUT, SCENES

COLUMNS = [
    "scene",
    "start",
    "linear solver",
    "iterations per stage",
    "total",
    "wall s",
    "cpu s",
    "speed",
    "distances",
    "model",
    "linear solver s",
    "rest",
    "objective",
    "position errors mm",
    "penetration mm",
    "force N",
    "status",
]


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Adds its arguments."""
    parser.add_argument("scenes", nargs="*", type=pathlib.Path, help="scene files [default: all in scenes/]")
    parser.add_argument("--all-starts", action="store_true", help="solve from every start, not only the first")
    parser.add_argument(
        "--linear-solvers",
        default="stage",
        metavar="NAMES",
        help="solve with each of these, separated by commas; `speed` compares with the first [default: stage]",
    )


def start_names(scene: pathlib.Path) -> list[str]:
    """Names of all [[start]] tables."""
    return [start["name"] for start in tomllib.loads(scene.read_text())["start"]]


def solve(scene: pathlib.Path, start: str, solver: str) -> dict:
    """Runs one solve; its result.json and, as `cpu_s`, the processor time it took."""
    folder = OUT / f"{scene.stem}-{start}-{solver}"
    OUT.mkdir(exist_ok=True)
    options = ["--start", start, "--linear-solver", solver, "--out", folder]
    usage = program.measured("solve", scene, *options, log=folder.with_suffix(".log"))
    return json.loads((folder / "result.json").read_text()) | {"cpu_s": usage.cpu_s}


def row(result: dict, reference: dict) -> str:
    """One line of the table."""
    stages = result["stages"]
    parts = ("distances", "model", "linear_solver", "rest")
    split = [sum(stage["wall_split_s"][part] for stage in stages) for part in parts]
    scenarios = result["scenarios"]
    cells = [
        result["scene"],
        result["start"],
        result["linear_solver"],
        "+".join(str(stage["iterations"]) for stage in stages),
        str(result["iterations"]),
        f"{result['wall_s']:.1f}",
        f"{result['cpu_s']:.1f}",
        f"{reference['cpu_s'] / result['cpu_s']:.1f}",
        *(f"{seconds:.1f}" for seconds in split),
        f"{result['objective']:.4f}",
        " ".join(f"{1e3 * scenario['position_error_m']:.2f}" for scenario in scenarios),
        f"{1e3 * max(scenario['max_penetration_m'] for scenario in scenarios):.2f}",
        f"{max(scenario['max_force_n'] for scenario in scenarios):.1f}",
        result["status"],
    ]
    return tables.line(cells)


def run(arguments: argparse.Namespace) -> None:
    """Solves all scenes named on the command line."""
    program.build()
    print(tables.head(COLUMNS), flush=True)
    for scene in arguments.scenes or sorted(SCENES.glob("*.toml")):
        names = start_names(scene)
        for start in names if arguments.all_starts else names[:1]:
            reference = None
            for solver in arguments.linear_solvers.split(","):
                result = solve(scene, start, solver)
                reference = reference or result
                print(row(result, reference), flush=True)
