"""The page about all pairs."""

import argparse
import json
import math
import pathlib
import tomllib

from lab import tables
from lab.real_parts.make import FRICTIONS, MOTIONS

PAGE = """\
Pairs of parts from public repositories (`scripts/python/lab/real_parts/manifest.toml`), planned by `solve --robust`
with nothing but the two files, their unit, start, goal, offsets and turns; other settings of a part are listed below.
Stiffness, horizon, directions of the offsets and facets are those that the program chooses. The plans were played in
MuJoCo by `scripts/lab validate`: {count} random offsets per magnitude and friction, as in
[robustness.md](robustness.md), each with a random turn. Pairs in italics are not real: `generate` wrote their scenes.
`scripts/lab real-parts FOLDER` repeats all of it and writes this page.

{parts}

Seconds are wall time of `solve --robust --jobs {jobs} --time-limit {time_limit}` with the default frictions of 0, 0.1
and 0.3: of the optimal control problem alone, and with everything, on a machine that others used at the same time. Own
rollouts are those of the evaluation before and after refinement; `(short)` where the target was not reached in time.
Overlap is the deepest of all motions in MuJoCo, whose contacts give way when parts hit each other. The last two columns
are of the planned motions of all scenarios.

{plans}

{notes}
"""
PART_COLUMNS = [
    *("part", "offsets, turns", "pairs", "facets, body + most of a piece", "round fit: gap, lost", "chosen stiffness"),
    *("steps", "straight push in MuJoCo, friction 0, 0.1, 0.3"),
]
PLAN_COLUMNS = [
    *("part", "plan, s", "robust, s", "own rollouts, %", "MuJoCo, friction 0", "0.1", "0.3", "overlap, mm"),
    *("off the straight path, mm", "fastest, m/s"),
]


def page(arguments: argparse.Namespace, made: list[tuple[dict, pathlib.Path]]) -> str:
    """Everything as Markdown, of pairs and the folders of their results."""
    return PAGE.format(
        jobs=arguments.jobs,
        time_limit=arguments.time_limit,
        count=arguments.count,
        parts=tables.markdown(PART_COLUMNS, (part_row(*each) for each in made)),
        plans=tables.markdown(PLAN_COLUMNS, (plan_row(*each) for each in made)),
        notes="\n".join(f"- {pair['name']}: {pair['note']}" for pair, _ in made if "note" in pair),
    )


def shown_name(pair: dict) -> str:
    """The name of a pair as tables show it."""
    return f"*{pair['name']}*" if "generate" in pair else pair["name"]


def not_measured(pair: dict, columns: list[str]) -> list[str]:
    """Cells of a pair without results."""
    return [shown_name(pair), "not measured"] + [""] * (len(columns) - 2)


def part_row(pair: dict, out: pathlib.Path) -> list[str]:
    """What a pair is, as cells of a table."""
    if not (out / MOTIONS).exists():
        return not_measured(pair, PART_COLUMNS)
    check = json.loads((out / "check.json").read_text())
    resolved = tomllib.loads((out / "plan/resolved.toml").read_text())
    rows = tables.read(out / MOTIONS)
    robustness = resolved["robustness"]
    fit = check["fit"]
    most = [max(part["facets"] for part in check[parent]) for parent in ("body", "environment")]
    impedance = resolved["impedance"]
    return [
        shown_name(pair),
        f"{1e3 * robustness['offset_magnitude']:g} mm, {robustness.get('rotation_error', 0.0):g} rad",
        str(check["pairs"]),
        f"{most[0]} + {most[1]}",
        f"{1e3 * fit['gap_m']:.3f} mm, {100 * fit['lost_m'] / fit['gap_m']:.1f} %" if fit else "-",
        f"{impedance['translational_stiffness']:.0f} N/m, {impedance['rotational_stiffness']:.1f} Nm/rad",
        f"{check['size']['steps']} of {check['size']['time_step_s']:.3f} s",
        ", ".join(tables.successes(rows, "straight push", friction) for friction in FRICTIONS),
    ]


def extremes(plan: pathlib.Path) -> tuple[float, float]:
    """How far the body is from the straight line between start and goal (m) and how fast it is (m/s), at most."""
    resolved = tomllib.loads((plan / "resolved.toml").read_text())
    start, goal = resolved["start"][0]["position"], resolved["goal"]["position"]
    length = math.dist(start, goal)
    along = [(one - other) / length for one, other in zip(start, goal)]
    farthest = fastest = 0.0
    for row in tables.read(plan / "scenarios.csv"):
        position = [float(row[f"p{axis}_m"]) for axis in "xyz"]
        ahead = sum(step * (one - other) for step, one, other in zip(along, position, goal))
        nearest = [other + step * min(max(ahead, 0.0), length) for step, other in zip(along, goal)]
        farthest = max(farthest, math.dist(position, nearest))
        fastest = max(fastest, math.hypot(*(float(row[f"v{axis}_m_s"]) for axis in "xyz")))
    return farthest, fastest


def plan_row(pair: dict, out: pathlib.Path) -> list[str]:
    """What the plan of a pair achieves, as cells of a table."""
    if not (out / MOTIONS).exists():
        return not_measured(pair, PLAN_COLUMNS)
    result, rows = json.loads((out / "plan/result.json").read_text()), tables.read(out / MOTIONS)
    robust = result["robust"]
    farthest, fastest = extremes(out / "plan")
    overlap = max(float(row["overlap_m"]) for row in rows if row["motion"] == "plan")
    return [
        shown_name(pair),
        f"{result['wall_s']:.1f}",
        f"{robust['wall_s']:.1f}",
        tables.rates(robust),
        *[tables.successes(rows, "plan", friction) for friction in FRICTIONS],
        f"{1e3 * overlap:.2f}",
        f"{1e3 * farthest:.0f}",
        f"{fastest:.2f}",
    ]
