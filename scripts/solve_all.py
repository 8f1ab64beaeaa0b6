"""Solves scenes one after the other and prints what came out as a Markdown table."""

import argparse
import json
import os
import pathlib
import resource
import subprocess
import tomllib

COLUMNS = (
    "scene | start | linear solver | iterations per stage | total | wall s | cpu s | speed | distances | model "
    "| linear solver s | rest | objective | position errors mm | penetration mm | force N | status"
)


def parse_arguments() -> argparse.Namespace:
    """Reads the command line."""
    parser = argparse.ArgumentParser(prog="scripts/solve-all", description=__doc__)
    parser.add_argument("scenes", nargs="*", type=pathlib.Path, help="scene files [default: all in scenes/]")
    parser.add_argument("--root", type=pathlib.Path, help=argparse.SUPPRESS)
    parser.add_argument("--all-starts", action="store_true", help="solve from every start, not only the first")
    parser.add_argument(
        "--linear-solvers",
        default="stage",
        metavar="NAMES",
        help="solve with each of these, separated by commas; `speed` compares with the first [default: stage]",
    )
    return parser.parse_args()


def start_names(scene: pathlib.Path) -> list[str]:
    """Names of all [[start]] tables."""
    return [start["name"] for start in tomllib.loads(scene.read_text())["start"]]


def solve(program: pathlib.Path, scene: pathlib.Path, start: str, solver: str, folder: pathlib.Path) -> dict:
    """Runs one solve; its result.json and, as `cpu_s`, the processor time it took."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    subprocess.run(
        [program, "solve", scene, "--start", start, "--linear-solver", solver, "--out", folder],
        stdout=subprocess.DEVNULL,
        check=False,
    )
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    cpu = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    return json.loads((folder / "result.json").read_text()) | {"cpu_s": cpu}


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
    return "| " + " | ".join(cells) + " |"


def main() -> None:
    """Solves all scenes named on the command line."""
    arguments = parse_arguments()
    target = pathlib.Path(os.environ.get("CARGO_TARGET_DIR", arguments.root / "target"))
    program = target / "release/assembly-plan"
    print(f"| {COLUMNS} |\n|{'---|' * (COLUMNS.count('|') + 1)}", flush=True)
    for scene in arguments.scenes or sorted((arguments.root / "scenes").glob("*.toml")):
        names = start_names(scene)
        for start in names if arguments.all_starts else names[:1]:
            reference = None
            for solver in arguments.linear_solvers.split(","):
                folder = arguments.root / "out" / f"{scene.stem}-{start}-{solver}"
                result = solve(program, scene, start, solver, folder)
                reference = reference or result
                print(row(result, reference), flush=True)


main()
