"""Robust plans of all scenes, made and played: what the pages about them have in common."""

import argparse
import dataclasses
import pathlib
import tomllib

from lab import program, tables
from lab.errors import InputError
from lab.paths import OUT, SCENES

# Scene, offset magnitudes (m).
CASES = [(f"peg{number}", [0.02]) for number in range(1, 6)] + [
    ("clamp1", [0.003, 0.005]),
    ("clamp2", [0.005]),
    ("clamp3", [0.005]),
]
# The offsets in MuJoCo are not those of our own exams.
SEED = "7"
# Random offsets of each magnitude in MuJoCo.
COUNT = 10


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

    def motions(self) -> list[tables.Row]:
        """What MuJoCo made of the plan."""
        return tables.read(self.folder / "mujoco.csv")


def cases(scenes: list[str], out: str) -> list[Case]:
    """The plans of some scenes, or of all if none is named, in a folder below `out/`."""
    unknown = set(scenes) - {scene for scene, _ in CASES}
    if unknown:
        there = ", ".join(scene for scene, _ in CASES)
        raise InputError(f"no such scene: {', '.join(sorted(unknown))}; there are {there}")
    return [
        Case(scene, start["name"], delta, OUT / out / f"{scene}-{start['name']}-{1e3 * delta:g}mm")
        for scene, deltas in CASES
        if not scenes or scene in scenes
        for delta in deltas
        for start in tomllib.loads((SCENES / f"{scene}.toml").read_text())["start"]
    ]


def chosen(arguments: argparse.Namespace, out: str) -> list[Case]:
    """What is to be planned, in a folder below `out/`: the first starts of each scene and offset."""
    starts: dict[tuple[str, float], list[Case]] = {}
    for case in cases(arguments.scenes, out):
        starts.setdefault((case.scene, case.delta), []).append(case)
    return [case for group in starts.values() for case in group[: arguments.starts]]


def run(
    arguments: argparse.Namespace, case: Case, scene: pathlib.Path, to_solve: list[str], to_play: list[str]
) -> None:
    """Makes a plan of a scene file and plays it, each with further flags, unless that is done."""
    jobs = ["--jobs", arguments.jobs]
    if not (case.folder / "cpu_s").exists():
        options = ["--robust", "--start", case.start, "--delta", case.delta, *jobs, *to_solve]
        usage = program.measured("solve", scene, *options, "--out", case.folder)
        (case.folder / "cpu_s").write_text(str(usage.cpu_s))
    program.validate(
        case.folder, case.folder / "mujoco.csv", "--seed", SEED, "--random", arguments.count, *jobs, *to_play
    )


def shares(rows: list[tables.Row], frictions: tuple[str, ...]) -> list[str]:
    """Successes of the plan with each friction and of the straight push with the first."""
    heads = [("plan", friction) for friction in frictions] + [("straight push", frictions[0])]
    return [tables.successes(rows, *head) for head in heads]


def succeeded(done: list[Case]) -> str:
    """How many motions of the plans succeed."""
    planned = [row["success"] == "1" for case in done for row in case.motions() if row["motion"] == "plan"]
    return f"{sum(planned)} of {len(planned)} motions in MuJoCo succeed."


def summary(done: list[Case], missing: list[Case]) -> str:
    """How many plans there are, how many of their motions succeed, and which plans are missing."""
    text = f"{len(done)} plans: {succeeded(done)}"
    return text + (f" Missing: {'; '.join(case.label() for case in missing)}." if missing else "")


def by_offset(done: list[Case], frictions: tuple[str, ...]) -> str:
    """Successes by magnitude of the offset, all plans together."""
    rows = [row for case in done for row in case.motions()]
    labels = dict.fromkeys(row["offset"] for row in rows)
    columns = [f"friction {float(friction):g}" for friction in frictions]
    return tables.markdown(
        ["offset", *columns, "push"],
        ([label, *shares([row for row in rows if row["offset"] == label], frictions)] for label in labels),
    )
