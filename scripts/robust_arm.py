"""Robust plans for arms, played by the whole arms: docs/experiments/robustness-arm.md."""

import argparse
import datetime
import json
import pathlib
import re
import statistics
import sys
import tomllib

from robust_cases import SEED, Case, by_offset, run, shares, succeeded, table_row

FRICTIONS = ("0.0", "0.1", "0.3")
MAGNITUDES = "0,0.5,0.95"
TURN = "0.02"

# Seconds after which the best plan so far is kept.
TIME_LIMIT = "60"
# Largest force of a contact (N).
LARGEST_FORCE = 60.0
LIMITS = f"[limits]\ncontact_force = {LARGEST_FORCE}\n"

# What the arm replaces in a scene: the inertia of a free body, and the gains, which are chosen for the arm.
REPLACED = re.compile(r"(mass|inertia|(translational|rotational)_(stiffness|damping))\s*=")

PAGE = """\
# Robust plans, played by whole arms

*Lab notebook, written on {date}.*

Starts of the scenes, planned by `solve --robust --friction {frictions} --turn {turn} --time-limit {limit}` for an arm with a
contact force of at most 60 N (`[limits]`), with gains that the program chose for it, and then played in MuJoCo by the whole
arm: rotor inertia, gravity, joint friction, torques held for a control period. Each plan is played with {count} random offsets in
the hull of the planned ones at each of 0, 50 and 95 % of delta-hat, the part turned in the gripper by up to {turn} rad about any
axis (`scripts/validate_mujoco --arm --seed {seed}`: [validation.md](../guide/validation.md#the-whole-arm)). The
push is an unplanned straight motion with the same gains and in the same time, without contact friction.
`scripts/robust-all{arms}` repeats all of it and writes this page.

Own rollouts are those of the evaluation, of all plans of a scene together. Forces are the largest of all motions of a scene's
plans, as means over 10 ms, and how many of the motions stay below 60 N. Seconds are the median of `solve --robust --jobs {jobs}`
with everything it does, on a shared machine.

{sections}
"""

SECTION = """\
## The arm of `{robot}`

Joint friction of {joint_friction} Nm, torques held for {control_period:g} ms.

{plans} of {all_plans} plans were made. {succeeded}

| scene | plans | own rollouts, % | friction 0 | friction 0.1 | friction 0.3 | push | force, N | below 60 N | wall s |
|---|---|---|---|---|---|---|---|---|---|
{rows}

By magnitude of the offset, all plans together:

| offset | friction 0 | friction 0.1 | friction 0.3 | push |
|---|---|---|---|---|
{magnitudes}
"""


def robot_of(file: pathlib.Path) -> dict:
    """The [robot] table of a file, its URDF as an absolute path."""
    try:
        table = tomllib.loads(file.read_text())["robot"]
        return table | {"urdf": str((file.parent / table["urdf"]).resolve())}
    except (OSError, KeyError, ValueError) as error:
        sys.exit(f"error: --arm {file}: no TOML file with a [robot] table that names its urdf: {error}")


def toml(value: object) -> str:
    """A value as TOML, on one line."""
    if isinstance(value, dict):
        return "{ " + ", ".join(f"{key} = {toml(entry)}" for key, entry in value.items()) + " }"
    # Strings, numbers and lists of numbers are written as in JSON.
    return json.dumps(value)


def with_robot(scene: str, robot: dict) -> str:
    """The text of a scene for a robot instead of a free body, which may push with a limited force."""
    kept = [line for line in scene.splitlines() if not REPLACED.match(line)]
    return "\n".join([*kept, "", LIMITS, "[robot]", *(f"{key} = {toml(value)}" for key, value in robot.items())]) + "\n"


def make(arguments: argparse.Namespace, arm: pathlib.Path, case: Case) -> None:
    """Makes a plan for the arm and lets the arm play it, unless that is done."""
    scene = case.folder.parent / f"{case.scene}.toml"
    scene.parent.mkdir(parents=True, exist_ok=True)
    text = (arguments.root / f"scenes/{case.scene}.toml").read_text()
    scene.write_text(with_robot(text, robot_of(arm)))
    frictions = ",".join(FRICTIONS)
    to_play = ["--arm", "--magnitude", MAGNITUDES]
    run(
        arguments,
        case,
        scene,
        ["--friction", frictions, "--turn", TURN, "--time-limit", TIME_LIMIT],
        ["--friction", frictions, "--turn", TURN, *to_play],
    )


def row(scene: str, done: list[Case]) -> str:
    """One line of the table: all plans of a scene."""
    rows = [row for case in done for row in case.motions()]
    forces = [float(row["force_n"]) for row in rows if row["motion"] == "plan"]
    results = [json.loads((case.folder / "result.json").read_text())["robust"] for case in done]
    cells = [
        scene,
        str(len(done)),
        f"{100 * statistics.fmean(result['rate_after'] for result in results):.1f}",
        *shares(rows, FRICTIONS),
        f"{max(forces):.0f}",
        f"{sum(force <= LARGEST_FORCE for force in forces)}/{len(forces)}",
        f"{statistics.median(result['wall_s'] for result in results):.0f}",
    ]
    return table_row(cells)


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
        rows="\n".join(row(scene, plans) for scene, plans in scenes.items()),
        magnitudes=by_offset(done, FRICTIONS),
    )


def page(arguments: argparse.Namespace, cases: dict[pathlib.Path, list[Case]]) -> str:
    """Everything as Markdown."""
    return PAGE.format(
        date=datetime.date.today().isoformat(),
        arms="".join(f" --arm {arm}" for arm in cases),
        frictions=",".join(FRICTIONS),
        limit=TIME_LIMIT,
        turn=TURN,
        seed=SEED,
        count=arguments.count,
        jobs=arguments.jobs,
        sections="\n".join(section(arm, of_arm) for arm, of_arm in cases.items()),
    )
