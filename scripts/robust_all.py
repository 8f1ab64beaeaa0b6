"""Solves scenes with --robust, plays the plans in MuJoCo and writes docs/robustness.md."""

import argparse
import csv
import dataclasses
import json
import os
import pathlib
import resource
import subprocess
import sys
import tomllib

# Scene, offset magnitudes (m): what the page is about.
CASES = [(f"peg{number}", [0.02]) for number in range(1, 6)] + [
    ("clamp1", [0.003, 0.005]),
    ("clamp2", [0.005]),
    ("clamp3", [0.005]),
]
# Wall seconds that the paper's solver took for a plan without any refinement (Table total_comp_times).
PAPER_SECONDS = {"peg1": 86, "peg2": 171, "peg3": 391, "peg4": 380, "peg5": 344}
# The offsets in MuJoCo are not those of our own exams.
SEED = "7"
FRICTIONS = ("0.0", "0.1")

PAGE = """\
# Robust plans, played in MuJoCo

Every start of every scene, planned by `solve --robust` with its defaults and then played in MuJoCo without friction and
with friction 0.1 by `scripts/validate_mujoco --seed {seed}`: 20 random offsets in the hull of the planned ones at each of
0, 25, 50 and 75 % of delta-hat and at delta-hat less 1 mm (one without offset). Success: within 3 mm and 0.1 rad of the
goal, one second after the end of the reference. The push is an unplanned straight motion from start to goal in the same
time, frictionless. `scripts/robust-all` repeats all of it and writes this page.

In our own simulator: success in rollouts of the plain plan, and of the robust one at offsets that it was not trained on.
Times are those of `solve --robust --jobs {jobs}` with everything it does, on a shared machine; the paper's are those of a
plan without refinement, on a laptop.

{summary}

| plan | own rollouts, plain -> robust, % | changes | in MuJoCo, friction 0 | friction 0.1 | push | largest error, mm | force, N | wall s | CPU s | paper s |
|---|---|---|---|---|---|---|---|---|---|---|
{rows}

By magnitude of the offset in MuJoCo, all plans together:

| offset | friction 0 | friction 0.1 | push |
|---|---|---|---|
{magnitudes}
"""


@dataclasses.dataclass(frozen=True)
class Case:
    """A plan to make."""

    scene: str
    start: str
    delta: float
    folder: pathlib.Path

    def label(self) -> str:
        """Its name in the table."""
        return f"{self.scene}, start {self.start}, {1e3 * self.delta:g} mm"


def parse_arguments() -> argparse.Namespace:
    """Reads the command line."""
    parser = argparse.ArgumentParser(prog="scripts/robust-all", description=__doc__)
    parser.add_argument("scenes", nargs="*", help="only these scenes, by name [default: all]")
    parser.add_argument("--root", type=pathlib.Path, help=argparse.SUPPRESS)
    parser.add_argument("--jobs", type=int, default=1, help="threads of each solve, processes of MuJoCo [default: 1]")
    parser.add_argument("--no-run", action="store_true", help="only write the page, from what is in out/robust")
    return parser.parse_args()


def cases(root: pathlib.Path, scenes: list[str]) -> list[Case]:
    """All plans that the page is about."""
    unknown = set(scenes) - {scene for scene, _ in CASES}
    if unknown:
        sys.exit(f"error: no such scene: {', '.join(sorted(unknown))}; there are {', '.join(scene for scene, _ in CASES)}")
    return [
        Case(scene, start["name"], delta, root / "out/robust" / f"{scene}-{start['name']}-{1e3 * delta:g}mm")
        for scene, deltas in CASES
        if not scenes or scene in scenes
        for delta in deltas
        for start in tomllib.loads((root / f"scenes/{scene}.toml").read_text())["start"]
    ]


def run(arguments: argparse.Namespace, case: Case) -> None:
    """Makes and plays a plan, unless that is done."""
    if not (case.folder / "cpu_s").exists():
        target = pathlib.Path(os.environ.get("CARGO_TARGET_DIR", arguments.root / "target"))
        scene = arguments.root / f"scenes/{case.scene}.toml"
        options = ["--start", case.start, "--delta", str(case.delta), "--jobs", str(arguments.jobs)]
        before = resource.getrusage(resource.RUSAGE_CHILDREN)
        command = [target / "release/assembly-plan", "solve", scene, "--robust", *options, "--out", case.folder]
        # 1 says that the wanted rate is not reached: that is a result.
        if subprocess.run(command, check=False).returncode not in (0, 1):
            sys.exit(f"error: {case.label()}: no plan")
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
        (case.folder / "cpu_s").write_text(str(after.ru_utime - before.ru_utime))
    if not (case.folder / "mujoco.csv").exists():
        unfinished = case.folder / "mujoco.unfinished.csv"
        options = ["--seed", SEED, "--jobs", str(arguments.jobs), "--csv", unfinished]
        subprocess.run([arguments.root / "scripts/validate_mujoco", case.folder, *options], check=True)
        unfinished.rename(case.folder / "mujoco.csv")


def motions(case: Case) -> list[dict[str, str]]:
    """What MuJoCo made of a plan."""
    with (case.folder / "mujoco.csv").open(newline="") as file:
        return list(csv.DictReader(file))


def successes(rows: list[dict[str, str]], motion: str, friction: str) -> str:
    """Successes of some motions, of how many."""
    chosen = [row["success"] == "1" for row in rows if (row["motion"], row["friction"]) == (motion, friction)]
    return f"{sum(chosen)}/{len(chosen)}"


def shares(rows: list[dict[str, str]]) -> list[str]:
    """Successes of the plan with each friction and of the straight push."""
    heads = [("plan", friction) for friction in FRICTIONS] + [("straight push", FRICTIONS[0])]
    return [successes(rows, *head) for head in heads]


def row(case: Case) -> str:
    """One line of the table."""
    robust = json.loads((case.folder / "result.json").read_text())["robust"]
    rows = motions(case)
    kept = robust["rounds"][robust["kept_round"] - 1]
    variant = "" if len(robust["rounds"]) == 1 else f" ({kept['planned']})"
    planned = [row for row in rows if row["motion"] == "plan"]
    cells = [
        case.label(),
        f"{100 * robust['rate_before']:.1f} -> {100 * robust['rate_after']:.1f}",
        f"{kept['changes']}{variant}" if kept["changes"] else "left alone",
        *shares(rows),
        f"{1e3 * max(float(row['position_error_m']) for row in planned):.1f}",
        f"{max(float(row['force_n']) for row in planned):.0f}",
        f"{robust['wall_s']:.0f}",
        f"{float((case.folder / 'cpu_s').read_text()):.0f}",
        str(PAPER_SECONDS.get(case.scene, "-")),
    ]
    return "| " + " | ".join(cells) + " |"


def page(done: list[Case], missing: list[Case], jobs: int) -> str:
    """Everything as Markdown."""
    rows = [row for case in done for row in motions(case)]
    planned = [row["success"] == "1" for row in rows if row["motion"] == "plan"]
    summary = f"{len(done)} plans: {sum(planned)} of {len(planned)} motions in MuJoCo succeed."
    if missing:
        summary += " Missing: " + "; ".join(case.label() for case in missing) + "."
    labels = dict.fromkeys(row["offset"] for row in rows)
    magnitudes = [[label, *shares([row for row in rows if row["offset"] == label])] for label in labels]
    return PAGE.format(
        seed=SEED,
        jobs=jobs,
        summary=summary,
        rows="\n".join(row(case) for case in done),
        magnitudes="\n".join("| " + " | ".join(cells) + " |" for cells in magnitudes),
    )


def main() -> None:
    """Runs what is missing and writes the page."""
    arguments = parse_arguments()
    everything = cases(arguments.root, [])
    if not arguments.no_run:
        for case in cases(arguments.root, arguments.scenes):
            print(case.label(), file=sys.stderr)
            run(arguments, case)
    done = [case for case in everything if (case.folder / "mujoco.csv").exists()]
    file = arguments.root / "docs/robustness.md"
    file.write_text(page(done, [case for case in everything if case not in done], arguments.jobs))
    print(f"written to {file}", file=sys.stderr)


main()
