"""Robust plans for arms, played by the whole arms, and the page about them."""

import argparse
import json
import pathlib
import statistics
import sys

from lab import notebook, tables
from lab.arm_scenes import LARGEST_FORCE, robot_of, with_robot
from lab.paths import SCENES
from lab.robust.cases import SEED, Case, by_offset, cases, chosen, run, shares, succeeded

FRICTIONS = ("0.0", "0.1", "0.3")
MAGNITUDES = "0,0.5,0.95"
TURN = "0.02"

# Seconds after which the best plan so far is kept.
TIME_LIMIT = "60"

PAGE = """\
Starts of the scenes, planned by `solve --robust --friction {frictions} --rotation-error {turn} --time-limit {limit}`
for an arm with a contact force of at most 60 N (`[limits]`), with gains that the program chose for it, and then
played in MuJoCo by the whole arm: rotor inertia, gravity, joint friction, torques held for a control period. Each
plan is played with {count} random offsets in the hull of the planned ones at each of 0, 50 and 95 % of delta-hat,
the part turned in the gripper by up to {turn} rad about any axis (`scripts/lab validate --arm --seed {seed}`:
[validation.md](../guide/validation.md#the-whole-arm)). The push is an unplanned straight motion with the same gains
and in the same time, without contact friction. `scripts/lab robust{arms}` repeats all of it and writes this page.

Own rollouts are those of the evaluation, of all plans of a scene together. Forces are the largest of all motions of a
scene's plans, as means over 10 ms, and how many of the motions stay below 60 N. Seconds are the median of
`solve --robust --jobs {jobs}` with everything it does, on a shared machine.

{sections}
"""

COLUMNS = ["scene", "plans", "own rollouts, %", *(f"friction {float(friction):g}" for friction in FRICTIONS)]
COLUMNS += ["push", "force, N", "below 60 N", "wall s"]

SECTION = """\
## The arm of `{robot}`

Joint friction of {joint_friction} Nm, torques held for {control_period:g} ms.

{plans} of {all_plans} plans were made. {succeeded}

{rows}

By magnitude of the offset, all plans together:

{magnitudes}
"""


def make_one(arguments: argparse.Namespace, arm: pathlib.Path, case: Case) -> None:
    """Makes a plan for the arm and lets the arm play it, unless that is done."""
    scene = case.folder.parent / f"{case.scene}.toml"
    scene.parent.mkdir(parents=True, exist_ok=True)
    text = (SCENES / f"{case.scene}.toml").read_text()
    scene.write_text(with_robot(text, robot_of(arm)))
    frictions = ",".join(FRICTIONS)
    to_play = ["--arm", "--magnitude", MAGNITUDES]
    run(
        arguments,
        case,
        scene,
        ["--friction", frictions, "--rotation-error", TURN, "--time-limit", TIME_LIMIT],
        ["--friction", frictions, "--rotation-error", TURN, *to_play],
    )


def row(scene: str, done: list[Case]) -> list[str]:
    """Cells of the table: all plans of a scene."""
    rows = [row for case in done for row in case.motions()]
    forces = [float(row["force_n"]) for row in rows if row["motion"] == "plan"]
    results = [json.loads((case.folder / "result.json").read_text())["robust"] for case in done]
    return [
        scene,
        str(len(done)),
        f"{100 * statistics.fmean(result['rate_after'] for result in results):.1f}",
        *shares(rows, FRICTIONS),
        f"{max(forces):.0f}",
        f"{sum(force <= LARGEST_FORCE for force in forces)}/{len(forces)}",
        f"{statistics.median(result['wall_s'] for result in results):.0f}",
    ]


def section(arm: pathlib.Path, cases: list[Case]) -> str:
    """What one arm does."""
    robot, done = robot_of(arm), [case for case in cases if case.is_played()]
    scenes: dict[str, list[Case]] = {}
    for case in done:
        scenes.setdefault(f"{case.scene}, {1e3 * case.delta:g} mm", []).append(case)
    return SECTION.format(
        robot=arm.name,
        joint_friction=robot.get("joint_friction", 0),
        control_period=1e3 * robot.get("control_period", 0.002),
        plans=len(done),
        all_plans=len(cases),
        succeeded=succeeded(done),
        rows=tables.markdown(COLUMNS, (row(scene, plans) for scene, plans in scenes.items())),
        magnitudes=by_offset(done, FRICTIONS),
    )


def page(arguments: argparse.Namespace, cases: dict[pathlib.Path, list[Case]]) -> str:
    """Everything as Markdown."""
    return PAGE.format(
        arms="".join(f" --arm {arm}" for arm in cases),
        frictions=",".join(FRICTIONS),
        limit=TIME_LIMIT,
        turn=TURN,
        seed=SEED,
        count=arguments.count,
        jobs=arguments.jobs,
        sections="\n".join(section(arm, of_arm) for arm, of_arm in cases.items()),
    )


def make(arguments: argparse.Namespace) -> None:
    """Plans and plays what is missing, and writes the page."""
    for arm in arguments.arm:
        for case in [] if arguments.no_run else chosen(arguments, f"robust-arm/{arm.stem}"):
            print(f"{arm.stem}: {case.label()}", file=sys.stderr)
            make_one(arguments, arm, case)
    everything = {arm: cases([], f"robust-arm/{arm.stem}") for arm in arguments.arm}
    notebook.write("robustness-arm", "Robust plans, played by whole arms", page(arguments, everything))
