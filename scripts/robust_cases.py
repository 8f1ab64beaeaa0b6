"""Robust plans of all scenes, made and played: what the pages about them have in common."""

import argparse
import csv
import dataclasses
import os
import pathlib
import resource
import subprocess
import sys
import tomllib

# Scene, offset magnitudes (m).
CASES = [(f"peg{number}", [0.02]) for number in range(1, 6)] + [
    ("clamp1", [0.003, 0.005]),
    ("clamp2", [0.005]),
    ("clamp3", [0.005]),
]
# The offsets in MuJoCo are not those of our own exams.
SEED = "7"
# Random offsets of each magnitude in MuJoCo.
COUNT = "10"


@dataclasses.dataclass(frozen=True)
class Case:
    """A plan to make."""

    scene: str
    start: str
    delta: float
    folder: pathlib.Path

    def label(self) -> str:
        """Its name in tables."""
        return f"{self.scene}, start {self.start}, {1e3 * self.delta:g} mm"

    def is_played(self) -> bool:
        """Whether all is done."""
        return (self.folder / "mujoco.csv").exists()

    def motions(self) -> list[dict[str, str]]:
        """What MuJoCo made of the plan."""
        with (self.folder / "mujoco.csv").open(newline="") as file:
            return list(csv.DictReader(file))


def cases(root: pathlib.Path, scenes: list[str], out: str) -> list[Case]:
    """The plans of some scenes, or of all if none is named, in a folder below the root."""
    unknown = set(scenes) - {scene for scene, _ in CASES}
    if unknown:
        sys.exit(f"error: no such scene: {', '.join(sorted(unknown))}; there are {', '.join(scene for scene, _ in CASES)}")
    return [
        Case(scene, start["name"], delta, root / out / f"{scene}-{start['name']}-{1e3 * delta:g}mm")
        for scene, deltas in CASES
        if not scenes or scene in scenes
        for delta in deltas
        for start in tomllib.loads((root / f"scenes/{scene}.toml").read_text())["start"]
    ]


def run(
    arguments: argparse.Namespace, case: Case, scene: pathlib.Path, to_solve: list[str], to_play: list[str]
) -> None:
    """Makes a plan of a scene file and plays it, each with further flags, unless that is done."""
    if not (case.folder / "cpu_s").exists():
        target = pathlib.Path(os.environ.get("CARGO_TARGET_DIR", arguments.root / "target"))
        options = ["--start", case.start, "--delta", str(case.delta), "--jobs", str(arguments.jobs), *to_solve]
        before = resource.getrusage(resource.RUSAGE_CHILDREN)
        command = [target / "release/assembly-plan", "solve", scene, "--robust", *options, "--out", case.folder]
        # 1 says that the wanted rate is not reached: that is a result.
        if subprocess.run(command, check=False).returncode not in (0, 1):
            sys.exit(f"error: {case.label()}: no plan")
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
        (case.folder / "cpu_s").write_text(str(after.ru_utime - before.ru_utime))
    if not case.is_played():
        unfinished = case.folder / "mujoco.unfinished.csv"
        options = ["--seed", SEED, "--random", arguments.count, "--jobs", str(arguments.jobs), "--csv", unfinished, *to_play]
        subprocess.run([arguments.root / "scripts/validate_mujoco", case.folder, *options], check=True)
        unfinished.rename(case.folder / "mujoco.csv")


def successes(rows: list[dict[str, str]], motion: str, friction: str) -> str:
    """Successes of some motions, of how many."""
    chosen = [row["success"] == "1" for row in rows if (row["motion"], row["friction"]) == (motion, friction)]
    return f"{sum(chosen)}/{len(chosen)}"


def shares(rows: list[dict[str, str]], frictions: tuple[str, ...]) -> list[str]:
    """Successes of the plan with each friction and of the straight push with the first."""
    heads = [("plan", friction) for friction in frictions] + [("straight push", frictions[0])]
    return [successes(rows, *head) for head in heads]


def table_row(cells: list[str]) -> str:
    """One line of a Markdown table."""
    return "| " + " | ".join(cells) + " |"


def succeeded(done: list[Case]) -> str:
    """How many motions of the plans succeed."""
    planned = [row["success"] == "1" for case in done for row in case.motions() if row["motion"] == "plan"]
    return f"{sum(planned)} of {len(planned)} motions in MuJoCo succeed."


def summary(done: list[Case], missing: list[Case]) -> str:
    """How many plans there are, how many of their motions succeed, and which plans are missing."""
    text = f"{len(done)} plans: {succeeded(done)}"
    return text + (f" Missing: {'; '.join(case.label() for case in missing)}." if missing else "")


def by_offset(done: list[Case], frictions: tuple[str, ...]) -> str:
    """Rows of successes by magnitude of the offset, all plans together."""
    rows = [row for case in done for row in case.motions()]
    labels = dict.fromkeys(row["offset"] for row in rows)
    return "\n".join(
        table_row([label, *shares([row for row in rows if row["offset"] == label], frictions)]) for label in labels
    )
