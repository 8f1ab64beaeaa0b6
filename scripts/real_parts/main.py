"""Plans pairs of parts with `solve --robust`, plays the plans in MuJoCo and writes docs/experiments/real-parts.md."""

import argparse
import csv
import datetime
import json
import math
import os
import pathlib
import subprocess
import tomllib

FRICTIONS = ("0.0", "0.1", "0.3")
# The motions of a pair in MuJoCo.
MOTIONS = "mujoco.csv"
SCENE = """\
title = "{name}"

[[body.part]]
name = "body"
{body}

[[environment.part]]
name = "socket"
{environment}

[[start]]
name = "1"
position = {start_position}
orientation = {start_orientation}

[goal]
position = {goal_position}
orientation = {goal_orientation}

[robustness]
offset_magnitude = {offset}
turn = {turn}
"""
PAGE = """\
# Real parts

*Lab notebook, written on {date}.*

Pairs of parts from public repositories (`scripts/real_parts/manifest.toml`), planned by `solve --robust` with nothing
but the two files, their unit, start, goal, offsets and turns; other settings of a part are listed below. Stiffness, horizon,
directions of the offsets and facets are those that the program chooses. The plans were played in MuJoCo by
`scripts/validate_mujoco`: {count} random offsets per magnitude and friction, as in [robustness.md](robustness.md), each with a
random turn. Pairs in italics are not real: `generate` wrote their scenes. `scripts/real-parts FOLDER` repeats all of it and
writes this page.

| part | offsets, turns | pairs | facets, body + most of a piece | round fit: gap, lost | chosen stiffness | steps | straight push in MuJoCo, friction 0, 0.1, 0.3 |
|---|---|---|---|---|---|---|---|
{parts}

Seconds are wall time of `solve --robust --jobs {jobs} --time-limit {time_limit}` with the default frictions of 0, 0.1 and 0.3: of
the optimal control problem alone, and with everything, on a machine that others used at the same time. Own rollouts are
those of the evaluation before and after refinement; `(short)` where the target was not reached in time. Overlap is the deepest of all motions in MuJoCo, whose contacts give way when
parts hit each other. The last two columns are of the planned motions of all scenarios.

{plans}

{notes}
"""
HEADER = """\
| part | plan, s | robust, s | own rollouts, % | MuJoCo, friction 0 | 0.1 | 0.3 | overlap, mm | off the straight path, mm | fastest, m/s |
|---|---|---|---|---|---|---|---|---|---|
"""


def part(keys: dict, folders: list[pathlib.Path]) -> str:
    """The lines of a part with these keys. Its file is in one of the folders."""
    lines = []
    for key, value in keys.items():
        if key in ("mesh", "model"):
            value = str(next(folder / value for folder in folders if (folder / value).exists()))
        lines.append(f"{key} = {json.dumps(value)}")
    return "\n".join(lines)


def write_scene(arguments: argparse.Namespace, program: pathlib.Path, pair: dict, scene: pathlib.Path) -> None:
    """Writes the scene of a pair, which is generated or has two files."""
    if "generate" in pair:
        subprocess.run([program, "generate", *pair["generate"], "--out", scene, "--force"], check=True)
        return
    folders = [arguments.folder, arguments.root / "scripts/real_parts"]
    scene.write_text(
        SCENE.format(
            name=pair["name"],
            body=part(pair["body"], folders),
            environment=part(pair["environment"], folders),
            start_position=pair["start"][:3],
            start_orientation=pair["start"][3:],
            goal_position=pair["goal"][:3],
            goal_orientation=pair["goal"][3:],
            offset=pair["offset"],
            turn=pair.get("turn", 0.0),
        )
    )


def run(arguments: argparse.Namespace, pair: dict, out: pathlib.Path) -> None:
    """Plans and plays a pair, unless that is done."""
    target = pathlib.Path(os.environ.get("CARGO_TARGET_DIR", arguments.root / "target"))
    program = target / "release/assembly-plan"
    out.mkdir(parents=True, exist_ok=True)
    scene = out / "scene.toml"
    write_scene(arguments, program, pair, scene)
    if not (out / "check.json").exists():
        check = subprocess.run([program, "check", scene, "--json"], check=True, capture_output=True, text=True)
        (out / "check.json").write_text(check.stdout)
    plan = out / "plan"
    if not (plan / "result.json").exists():
        limits = ["--jobs", str(arguments.jobs), "--time-limit", str(arguments.time_limit)]
        subprocess.run([program, "solve", scene, "--robust", *limits, "--out", plan], check=False)
    table = out / MOTIONS
    if not table.exists():
        unfinished = table.with_suffix(".unfinished")
        settings = {"seed": 7, "jobs": arguments.jobs, "friction": ",".join(FRICTIONS), "random": arguments.count}
        play = [f"--{name}={value}" for name, value in settings.items()]
        subprocess.run([arguments.root / "scripts/validate_mujoco", plan, *play, "--csv", unfinished], check=True)
        unfinished.rename(table)


def successes(rows: list[dict[str, str]], motion: str, friction: str) -> str:
    """Successes of some motions, of how many."""
    chosen = [row["success"] == "1" for row in rows if (row["motion"], row["friction"]) == (motion, friction)]
    return f"{sum(chosen)}/{len(chosen)}"


def motions(out: pathlib.Path) -> list[dict[str, str]]:
    """The motions that MuJoCo played."""
    with (out / MOTIONS).open(newline="") as file:
        return list(csv.DictReader(file))


def shown_name(pair: dict) -> str:
    """The name of a pair as tables show it."""
    return f"*{pair['name']}*" if "generate" in pair else pair["name"]


def part_row(pair: dict, out: pathlib.Path) -> str:
    """What a pair is, as a line of a table."""
    if not (out / MOTIONS).exists():
        return f"| {shown_name(pair)} | not measured | | | | | | |"
    check = json.loads((out / "check.json").read_text())
    resolved = tomllib.loads((out / "plan/resolved.toml").read_text())
    rows = motions(out)
    robustness = resolved["robustness"]
    fit = check["fit"]
    most = [max(part["facets"] for part in check[parent]) for parent in ("body", "environment")]
    impedance = resolved["impedance"]
    cells = [
        shown_name(pair),
        f"{1e3 * robustness['offset_magnitude']:g} mm, {robustness.get('turn', 0.0):g} rad",
        str(check["pairs"]),
        f"{most[0]} + {most[1]}",
        f"{1e3 * fit['gap_m']:.3f} mm, {100 * fit['lost_m'] / fit['gap_m']:.1f} %" if fit else "-",
        f"{impedance['translational_stiffness']:.0f} N/m, {impedance['rotational_stiffness']:.1f} Nm/rad",
        f"{check['size']['steps']} of {check['size']['time_step_s']:.3f} s",
        ", ".join(successes(rows, "straight push", friction) for friction in FRICTIONS),
    ]
    return f"| {' | '.join(cells)} |"


def extremes(plan: pathlib.Path) -> tuple[float, float]:
    """How far the body is from the straight line between start and goal (m) and how fast it is (m/s), at most."""
    resolved = tomllib.loads((plan / "resolved.toml").read_text())
    start, goal = resolved["start"][0]["position"], resolved["goal"]["position"]
    length = math.dist(start, goal)
    along = [(one - other) / length for one, other in zip(start, goal)]
    farthest = fastest = 0.0
    with (plan / "scenarios.csv").open(newline="") as file:
        for row in csv.DictReader(file):
            position = [float(row[f"p{axis}_m"]) for axis in "xyz"]
            ahead = sum(step * (one - other) for step, one, other in zip(along, position, goal))
            nearest = [other + step * min(max(ahead, 0.0), length) for step, other in zip(along, goal)]
            farthest = max(farthest, math.dist(position, nearest))
            fastest = max(fastest, math.hypot(*(float(row[f"v{axis}_m_s"]) for axis in "xyz")))
    return farthest, fastest


def plan_row(pair: dict, out: pathlib.Path) -> str:
    """What the plan of a pair achieves, as a line of a table."""
    if not (out / MOTIONS).exists():
        return f"| {shown_name(pair)} | not measured | | | | | | | | |"
    result, rows = json.loads((out / "plan/result.json").read_text()), motions(out)
    robust = result["robust"]
    farthest, fastest = extremes(out / "plan")
    overlap = max(float(row["overlap_m"]) for row in rows if row["motion"] == "plan")
    cells = [
        shown_name(pair),
        f"{result['wall_s']:.1f}",
        f"{robust['wall_s']:.1f}",
        f"{100 * robust['rate_before']:.1f} -> {100 * robust['rate_after']:.1f}" + ("" if robust["reached"] else " (short)"),
        *[successes(rows, "plan", friction) for friction in FRICTIONS],
        f"{1e3 * overlap:.2f}",
        f"{1e3 * farthest:.0f}",
        f"{fastest:.2f}",
    ]
    return f"| {' | '.join(cells)} |"


def main() -> None:
    """Runs everything and writes the page."""
    parser = argparse.ArgumentParser(prog="scripts/real-parts", description=__doc__)
    parser.add_argument("folder", type=pathlib.Path, help="folder with the meshes of the manifest")
    parser.add_argument("--root", type=pathlib.Path, help=argparse.SUPPRESS)
    parser.add_argument("--jobs", type=int, default=2, help="threads of each solve, processes of MuJoCo [default: 2]")
    parser.add_argument("--time-limit", type=int, default=180, help="of each solve (s) [default: 180]")
    parser.add_argument("--count", type=int, default=20, help="random offsets per magnitude in MuJoCo [default: 20]")
    parser.add_argument(
        "--skip", action="append", default=[], metavar="NAME", help="plan nothing new for this pair; may be repeated"
    )
    arguments = parser.parse_args()
    arguments.folder = arguments.folder.resolve()
    pairs = tomllib.loads((arguments.root / "scripts/real_parts/manifest.toml").read_text())["pair"]
    folders = [arguments.root / "out/real-parts" / pair["name"].replace(" ", "-").replace(",", "") for pair in pairs]
    for pair, out in zip(pairs, folders):
        if pair["name"] not in arguments.skip:
            run(arguments, pair, out)
    parts = "\n".join(part_row(pair, out) for pair, out in zip(pairs, folders))
    plans = HEADER + "\n".join(plan_row(pair, out) for pair, out in zip(pairs, folders))
    page = arguments.root / "docs/experiments/real-parts.md"
    settings = {"jobs": arguments.jobs, "time_limit": arguments.time_limit, "count": arguments.count}
    notes = "\n".join(f"- {pair['name']}: {pair['note']}" for pair in pairs if "note" in pair)
    page.write_text(PAGE.format(date=datetime.date.today().isoformat(), parts=parts, plans=plans, notes=notes, **settings))
    print(f"written to {page}")


if __name__ == "__main__":
    main()
