"""Plans pairs of parts with `solve --robust`, plays the plans in MuJoCo and writes docs/real-parts.md."""

import argparse
import csv
import json
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

[impedance]
translational_stiffness = 400.0
rotational_stiffness = 20.0

[robustness]
offset_magnitude = {offset}
offset_directions = {directions}

[horizon]
steps = 100
time_step = 0.03
"""
PAGE = """\
# Real parts

Pairs of parts from public repositories (`scripts/real_parts/manifest.toml`), planned by `solve --robust` with nothing
but the two files, their unit, start, goal and offsets, for a body of 1 kg held with 400 N/m and 20 Nm/rad, and played in
MuJoCo by `scripts/validate_mujoco`: 81 motions at each friction, offsets as in [robustness.md](robustness.md). Pairs in
italics are not real: `generate` wrote their scenes, stiffness included. `scripts/real-parts FOLDER` repeats all of it and
writes this page. Seconds are those of `solve --robust --jobs {jobs} --time-limit {time_limit}` on a machine that others
used at the same time, so that they are upper bounds: of the optimal control problem alone, and with everything.

| part | pairs | facets, body + most of a piece | round fit: gap, lost | plan, s | robust, s | own rollouts, % | MuJoCo, friction 0 | 0.1 | 0.3 | straight push 0, 0.1, 0.3 |
|---|---|---|---|---|---|---|---|---|---|---|
{rows}

Refinement knows frictions of 0 and 0.1, its defaults; 0.3 was not asked for.

{notes}
"""


def directions(axis: str) -> list[list[float]]:
    """Three directions across an axis."""
    across = [index for index in range(3) if "xyz"[index] != axis]
    triples = [(0.7071068, -0.7071068), (-0.7071068, -0.7071068), (0.0, 1.0)]
    result = []
    for pair in triples:
        direction = [0.0, 0.0, 0.0]
        direction[across[0]], direction[across[1]] = pair
        result.append(direction)
    return result


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
            directions=directions(pair["axis"]),
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
        options = ["--jobs", str(arguments.jobs), "--time-limit", str(arguments.time_limit)]
        options += ["--turn", str(pair["turn"])] if "turn" in pair else []
        subprocess.run([program, "solve", scene, "--robust", *options, "--out", plan], check=False)
    if not (out / "mujoco.csv").exists():
        unfinished = out / "mujoco.unfinished.csv"
        options = ["--seed", "7", "--jobs", str(arguments.jobs), "--friction", ",".join(FRICTIONS), "--csv", unfinished]
        subprocess.run([arguments.root / "scripts/validate_mujoco", plan, *options], check=True)
        unfinished.rename(out / "mujoco.csv")


def successes(rows: list[dict[str, str]], motion: str, friction: str) -> str:
    """Successes of some motions, of how many."""
    chosen = [row["success"] == "1" for row in rows if (row["motion"], row["friction"]) == (motion, friction)]
    return f"{sum(chosen)}/{len(chosen)}"


def row(pair: dict, out: pathlib.Path) -> str:
    """One line of the table."""
    check = json.loads((out / "check.json").read_text())
    result = json.loads((out / "plan/result.json").read_text())
    with (out / "mujoco.csv").open(newline="") as file:
        rows = list(csv.DictReader(file))
    fit = check["fit"]
    most = [max(part["facets"] for part in check[parent]) for parent in ("body", "environment")]
    cells = [
        f"*{pair['name']}*" if "generate" in pair else pair["name"],
        str(check["pairs"]),
        f"{most[0]} + {most[1]}",
        f"{1e3 * fit['gap_m']:.3f} mm, {100 * fit['lost_m'] / fit['gap_m']:.1f} %" if fit else "-",
        f"{result['wall_s']:.1f}",
        f"{result['robust']['wall_s']:.1f}",
        f"{100 * result['robust']['rate_before']:.1f} -> {100 * result['robust']['rate_after']:.1f}",
        *[successes(rows, "plan", friction) for friction in FRICTIONS],
        ", ".join(successes(rows, "straight push", friction) for friction in FRICTIONS),
    ]
    return f"| {' | '.join(cells)} |"


def main() -> None:
    """Runs everything and writes the page."""
    parser = argparse.ArgumentParser(prog="scripts/real-parts", description=__doc__)
    parser.add_argument("folder", type=pathlib.Path, help="folder with the meshes of the manifest")
    parser.add_argument("--root", type=pathlib.Path, help=argparse.SUPPRESS)
    parser.add_argument("--jobs", type=int, default=2, help="threads of each solve, processes of MuJoCo [default: 2]")
    parser.add_argument("--time-limit", type=int, default=900, help="of each solve (s) [default: 900]")
    arguments = parser.parse_args()
    arguments.folder = arguments.folder.resolve()
    manifest = tomllib.loads((arguments.root / "scripts/real_parts/manifest.toml").read_text())
    lines = []
    for pair in manifest["pair"]:
        out = arguments.root / "out/real-parts" / pair["name"].replace(" ", "-").replace(",", "")
        run(arguments, pair, out)
        lines.append(row(pair, out))
    page = arguments.root / "docs/real-parts.md"
    settings = {"jobs": arguments.jobs, "time_limit": arguments.time_limit}
    notes = "\n".join(f"- {pair['name']}: {pair['note']}" for pair in manifest["pair"] if "note" in pair)
    page.write_text(PAGE.format(rows="\n".join(lines), notes=notes, **settings))
    print(f"written to {page}")


if __name__ == "__main__":
    main()
