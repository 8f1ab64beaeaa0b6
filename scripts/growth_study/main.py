"""Measures how wall time, processor time and peak memory of `assembly-plan solve` grow with steps, scenarios and pairs,
and writes one figure each and a table. Needs nothing but Python 3.11. For times that mean something, nothing else should
run on the machine."""

import argparse
import csv
import os
import pathlib
import sys
from collections.abc import Callable

import chart
import measure
import scenes

SERIES = {"steps": scenes.with_steps, "scenarios": scenes.with_scenarios, "pairs": scenes.with_pairs}
FIXED = {"steps": "3 scenarios, 6 pairs, 4 s", "scenarios": "100 steps, 6 pairs", "pairs": "100 steps, 3 scenarios"}
VALUES = {
    "steps": (50, 100, 200, 300, 500, 1000),
    "scenarios": (1, 2, 3, 6, 9, 14, 27),
    "pairs": (1, 2, 3, 6, 12, 24, 36, 60),
}
QUICK = {"steps": (50, 100, 200), "scenarios": (1, 3, 6), "pairs": (1, 6, 12)}


def parse_arguments() -> argparse.Namespace:
    """Reads the command line."""
    parser = argparse.ArgumentParser(prog="scripts/growth", description=__doc__)
    parser.add_argument("--root", type=pathlib.Path, help=argparse.SUPPRESS)
    parser.add_argument("--quick", action="store_true", help="three small solves each, with figures in out/growth-quick")
    parser.add_argument("--no-run", action="store_true", help="draw the figures of the table that is there")
    return parser.parse_args()


def measure_all(root: pathlib.Path, out: pathlib.Path, values: dict) -> list[dict]:
    """Rows of the table, series by series."""
    program = pathlib.Path(os.environ.get("CARGO_TARGET_DIR", root / "target")) / "release/assembly-plan"
    scene = scenes.load(root / "scenes/peg1.toml")
    own = {"steps": scenes.STEPS, "scenarios": scenes.SCENARIOS, "pairs": scenes.PAIRS}
    rows = []
    for series, change in SERIES.items():
        for value in values[series]:
            changed = scenes.text(change(scene, value))
            row = {"series": series} | own | {series: value}
            row |= measure.measured(program, changed, out / f"{series}-{value}")
            print(f"{value} {series}: {row['iterations']} iterations, {row['wall_s']:.1f} s", file=sys.stderr, flush=True)
            rows.append(row)
    return rows


def write_table(rows: list[dict], file: pathlib.Path) -> None:
    """The table as CSV, with numbers as exact as they mean something."""
    with file.open("w", newline="") as lines:
        writer = csv.writer(lines, lineterminator="\n")
        writer.writerow(measure.COLUMNS)
        for row in rows:
            cells = (row[column] for column in measure.COLUMNS)
            writer.writerow([f"{cell:.4g}" if isinstance(cell, float) else cell for cell in cells])


def read_table(file: pathlib.Path) -> list[dict]:
    """Rows of a written table."""
    with file.open(newline="") as lines:
        texts = ("series", "status")
        return [
            {key: cell if key in texts else float(cell) for key, cell in row.items()} for row in csv.DictReader(lines)
        ]


def panels(rows: list[dict], series: str) -> list[chart.Panel]:
    """Whole solve, one iteration, memory."""

    def line(name: str, height: Callable[[dict], float]) -> chart.Line:
        return chart.Line(name, [(row[series], height(row)) for row in rows])

    def per_iteration(name: str, parts: tuple[str, ...]) -> chart.Line:
        return line(name, lambda row: 1e3 * sum(row[f"{part}_s"] for part in parts) / row["iterations"])

    solve_lines = [line("wall", lambda row: row["wall_s"]), line("processor", lambda row: row["cpu_s"])]
    solve = chart.Panel("Whole solve", "time (s)", solve_lines)
    solve.notes = [f"{row['iterations']:.0f}" + ("" if row["status"] == "planned, not tested" else "*") for row in rows]
    solve.remark = "numbers: iterations; *: the goal is not reached"
    parts = [per_iteration(part.replace("_", " "), (part,)) for part in measure.SPLIT]
    all_parts = per_iteration("all", measure.SPLIT)
    iteration = chart.Panel("One iteration of Ipopt", "wall time (ms)", [all_parts, *parts])
    memory = chart.Panel("Peak memory", "memory (MB)", [line("", lambda row: row["peak_memory_mb"])])
    return [solve, iteration, memory]


def main() -> None:
    """Measures what is missing and writes everything."""
    arguments = parse_arguments()
    root = arguments.root
    out = root / "out" / ("growth-quick" if arguments.quick else "growth")
    folder = out / "figures" if arguments.quick else root / "docs/experiments/growth"
    folder.mkdir(parents=True, exist_ok=True)
    table = folder / "growth.csv"
    if not arguments.no_run:
        write_table(measure_all(root, out, QUICK if arguments.quick else VALUES), table)
    rows = read_table(table)
    for series, fixed in FIXED.items():
        of_series = [row for row in rows if row["series"] == series]
        drawing = chart.draw(f"Growth with {series}: peg1, {fixed}", f"number of {series}", panels(of_series, series))
        (folder / f"{series}.svg").write_text(drawing)


main()
