"""Measures how time and memory of `solve` grow with steps, scenarios and pairs.

Draws one figure each, and writes a table. It can be stopped at any moment and resumes where it was. For times
that mean something, nothing else should run on the machine.
"""

import argparse
import pathlib
import sys
from collections.abc import Callable

from lab import notebook, program, tables, toml
from lab.growth import chart, measure, scenes
from lab.paths import OUT, SCENES

SERIES = {"steps": scenes.with_steps, "scenarios": scenes.with_scenarios, "pairs": scenes.with_pairs}
FIXED = {"steps": "3 scenarios, 6 pairs, 4 s", "scenarios": "100 steps, 6 pairs", "pairs": "100 steps, 3 scenarios"}
VALUES = {
    "steps": (50, 100, 200, 300, 500, 1000),
    "scenarios": (1, 2, 3, 6, 9, 14, 27),
    "pairs": (1, 2, 3, 6, 12, 24, 36, 60),
}
QUICK = {"steps": (50, 100, 200), "scenarios": (1, 3, 6), "pairs": (1, 6, 12)}


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Adds its arguments."""
    parser.add_argument(
        "--quick", action="store_true", help="three small solves each, with figures in out/growth-quick"
    )
    parser.add_argument("--no-run", action="store_true", help="draw the figures of the table that is there")


def measure_all(out: pathlib.Path, values: dict) -> list[dict]:
    """Rows of the table, series by series."""
    scene = scenes.load(SCENES / "peg1.toml")
    own = {"steps": scenes.STEPS, "scenarios": scenes.SCENARIOS, "pairs": scenes.PAIRS}
    rows = []
    for series, change in SERIES.items():
        for value in values[series]:
            changed = toml.text(change(scene, value))
            row = {"series": series} | own | {series: value}
            row |= measure.measured(changed, out / f"{series}-{value}")
            print(
                f"{value} {series}: {row['iterations']} iterations, {row['wall_s']:.1f} s", file=sys.stderr, flush=True
            )
            rows.append(row)
    return rows


def write_table(rows: list[dict], file: pathlib.Path) -> None:
    """The table as CSV, with numbers as exact as they mean something."""
    cells = ([row[column] for column in measure.COLUMNS] for row in rows)
    shown = ([f"{cell:.4g}" if isinstance(cell, float) else cell for cell in row] for row in cells)
    tables.write(file, measure.COLUMNS, shown)


def read_table(file: pathlib.Path) -> list[dict]:
    """Rows of a written table."""
    texts = ("series", "status")
    return [{key: cell if key in texts else float(cell) for key, cell in row.items()} for row in tables.read(file)]


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


def run(arguments: argparse.Namespace) -> None:
    """Measures what is missing and writes everything."""
    out = OUT / ("growth-quick" if arguments.quick else "growth")
    folder = out / "figures" if arguments.quick else notebook.FOLDER / "growth"
    folder.mkdir(parents=True, exist_ok=True)
    table = folder / "growth.csv"
    if not arguments.no_run:
        program.build()
        write_table(measure_all(out, QUICK if arguments.quick else VALUES), table)
    rows = read_table(table)
    for series, fixed in FIXED.items():
        of_series = [row for row in rows if row["series"] == series]
        drawing = chart.draw(f"Growth with {series}: peg1, {fixed}", f"number of {series}", panels(of_series, series))
        (folder / f"{series}.svg").write_text(drawing)
    notebook.said_to(folder)
