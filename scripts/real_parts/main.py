"""Plans pairs of parts with `solve --robust`, plays the plans in MuJoCo and writes docs/real-parts.md."""

import argparse
import csv
import json
import math
import os
import pathlib
import subprocess
import tomllib

FRICTIONS = ("0.0", "0.1", "0.3")
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
"""
# Plans of a pair: name of the folder, and what `solve` is told besides.
PLANS = {"plan": [], "plan_friction": ["--friction", ",".join(FRICTIONS)]}
PAGE = """\
# Real parts

Pairs of parts from public repositories (`scripts/real_parts/manifest.toml`), planned by `solve --robust` with nothing
but the two files, their unit, start, goal and offsets; whatever else a part was given is said below. Stiffness, horizon,
directions of the offsets and facets are those that the program chooses. The plans were played in MuJoCo by
`scripts/validate_mujoco`: 81 motions at each friction, offsets as in [robustness.md](robustness.md). Pairs in italics are
not real: `generate` wrote their scenes. `scripts/real-parts FOLDER` repeats all of it and writes this page.

| part | pairs | facets, body + most of a piece | round fit: gap, lost | chosen stiffness | steps | straight push in MuJoCo, friction 0, 0.1, 0.3 |
|---|---|---|---|---|---|---|
{parts}

Seconds are those of `solve --robust --jobs {jobs} --time-limit {time_limit}` on a machine that others used at the same
time, so that they are upper bounds: of the optimal control problem alone, and with everything. Own rollouts are those of
the evaluation before and after refinement. Overlap is the deepest of all motions in MuJoCo, whose contacts give way when
parts hit each other. The last two columns are of the planned motions of all scenarios. First with the default, frictions
of 0 and 0.1, so that 0.3 was not asked for:

{plan}

With `--friction {frictions}`:

{plan_friction}

{notes}
"""
HEADER = """\
| part | plan, s | robust, s | own rollouts, % | MuJoCo, friction 0 | 0.1 | 0.3 | overlap, mm | off the straight way, mm | fastest, m/s |
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
        )
    )


def run(arguments: argparse.Namespace, pair: dict, out: pathlib.Path, name: str) -> None:
    """Plans and plays a pair in one way, unless that is done."""
    target = pathlib.Path(os.environ.get("CARGO_TARGET_DIR", arguments.root / "target"))
    program = target / "release/assembly-plan"
    out.mkdir(parents=True, exist_ok=True)
    scene = out / "scene.toml"
    write_scene(arguments, program, pair, scene)
    if not (out / "check.json").exists():
        check = subprocess.run([program, "check", scene, "--json"], check=True, capture_output=True, text=True)
        (out / "check.json").write_text(check.stdout)
    solve_and_play(arguments, program, pair, out / name, PLANS[name])


def solve_and_play(
    arguments: argparse.Namespace, program: pathlib.Path, pair: dict, plan: pathlib.Path, options: list[str]
) -> None:
    """Plans a pair into a folder and plays the plan, unless that is done."""
    if not (plan / "result.json").exists():
        limits = ["--jobs", str(arguments.jobs), "--time-limit", str(arguments.time_limit)]
        solve = [program, "solve", plan.parent / "scene.toml", "--robust", *limits, *options, "--out", plan]
        subprocess.run(solve, check=False)
    table = plan.parent / f"{plan.name}.mujoco.csv"
    if not table.exists():
        unfinished = table.with_suffix(".unfinished")
        play = ["--seed", "7", "--jobs", str(arguments.jobs), "--friction", ",".join(FRICTIONS), "--csv", unfinished]
        # A straight push is the same for both plans.
        play += ["--no-baseline"] if options else []
        subprocess.run([arguments.root / "scripts/validate_mujoco", plan, *play], check=True)
        unfinished.rename(table)


def successes(rows: list[dict[str, str]], motion: str, friction: str) -> str:
    """Successes of some motions, of how many."""
    chosen = [row["success"] == "1" for row in rows if (row["motion"], row["friction"]) == (motion, friction)]
    return f"{sum(chosen)}/{len(chosen)}"


def motions(out: pathlib.Path, name: str) -> list[dict[str, str]]:
    """The motions that MuJoCo played with a plan."""
    with (out / f"{name}.mujoco.csv").open(newline="") as file:
        return list(csv.DictReader(file))


def shown_name(pair: dict) -> str:
    """The name of a pair as tables show it."""
    return f"*{pair['name']}*" if "generate" in pair else pair["name"]


def part_row(pair: dict, out: pathlib.Path) -> str:
    """What a pair is, as a line of a table."""
    if not (out / "plan.mujoco.csv").exists():
        return f"| {shown_name(pair)} | not measured | | | | | |"
    check = json.loads((out / "check.json").read_text())
    resolved = tomllib.loads((out / "plan/resolved.toml").read_text())
    rows = motions(out, "plan")
    fit = check["fit"]
    most = [max(part["facets"] for part in check[parent]) for parent in ("body", "environment")]
    impedance = resolved["impedance"]
    cells = [
        shown_name(pair),
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


def plan_row(pair: dict, out: pathlib.Path, name: str) -> str:
    """What a plan of a pair achieves, as a line of a table."""
    if not (out / f"{name}.mujoco.csv").exists():
        return f"| {shown_name(pair)} | not measured | | | | | | | | |"
    result = json.loads((out / name / "result.json").read_text())
    rows = motions(out, name)
    farthest, fastest = extremes(out / name)
    overlap = max(float(row["overlap_m"]) for row in rows if row["motion"] == "plan")
    cells = [
        shown_name(pair),
        f"{result['wall_s']:.1f}",
        f"{result['robust']['wall_s']:.1f}",
        f"{100 * result['robust']['rate_before']:.1f} -> {100 * result['robust']['rate_after']:.1f}",
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
    parser.add_argument("--time-limit", type=int, default=900, help="of each solve (s) [default: 900]")
    parser.add_argument(
        "--skip", action="append", default=[], metavar="NAME", help="plan nothing new for this pair; may be repeated"
    )
    arguments = parser.parse_args()
    arguments.folder = arguments.folder.resolve()
    pairs = tomllib.loads((arguments.root / "scripts/real_parts/manifest.toml").read_text())["pair"]
    folders = [arguments.root / "out/real-parts" / pair["name"].replace(" ", "-").replace(",", "") for pair in pairs]
    for name in PLANS:
        for pair, out in zip(pairs, folders):
            if pair["name"] not in arguments.skip:
                run(arguments, pair, out, name)
    tables = {"parts": [part_row(pair, out) for pair, out in zip(pairs, folders)]}
    for name in PLANS:
        tables[name] = [plan_row(pair, out, name) for pair, out in zip(pairs, folders)]
    page = arguments.root / "docs/real-parts.md"
    settings = {"jobs": arguments.jobs, "time_limit": arguments.time_limit}
    notes = "\n".join(f"- {pair['name']}: {pair['note']}" for pair in pairs if "note" in pair)
    tables = {name: "\n".join(rows) for name, rows in tables.items()}
    tables |= {name: HEADER + tables[name] for name in PLANS}
    page.write_text(PAGE.format(**tables, frictions=",".join(FRICTIONS), notes=notes, **settings))
    print(f"written to {page}")


if __name__ == "__main__":
    main()
