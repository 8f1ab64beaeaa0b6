"""Runs the batches behind tables and figures, and reads what they left."""

import dataclasses
import json
import pathlib
import subprocess
import sys

from lab import program
from lab.paths import OUT

MATRICES = pathlib.Path(__file__).resolve().parent / "studies"
RUNS = OUT / "reproduction"


@dataclasses.dataclass
class Cell:
    """One planning problem and what has become of it."""

    scene: str
    start: str
    delta_m: float
    homotopy: str | None
    state: str
    failure: str | None
    result: dict | None
    folder: pathlib.Path

    @property
    def is_finished(self) -> bool:
        """Whether a solve has run to its end, good or bad."""
        return self.result is not None

    @property
    def is_done(self) -> bool:
        """Whether the plan converged and every scenario reaches the goal."""
        return self.state == "planned"

    @property
    def stages(self) -> list[dict]:
        """Its homotopy steps."""
        return self.result["stages"]

    @property
    def error_mm(self) -> float:
        """Largest final position error of all scenarios."""
        return 1e3 * max(scenario["position_error_m"] for scenario in self.result["scenarios"])

    @property
    def penetration_mm(self) -> float:
        """Deepest overlap of the exact shapes in any scenario."""
        return 1e3 * max(scenario["max_penetration_m"] for scenario in self.result["scenarios"])

    def seconds(self, part: str) -> float:
        """Wall time of one part of all stages."""
        return sum(stage["wall_split_s"][part] for stage in self.stages)


def run(study: str, jobs: int, is_quick: bool, matrix: pathlib.Path | None = None) -> None:
    """Solves what is not finished of a study, that of its own matrix unless one is given; only its first cell for a
    quick look."""
    folder, matrix = RUNS / study, matrix or MATRICES / f"{study}.toml"
    print(f"{study}:", file=sys.stderr, flush=True)
    program.run("batch", "expand", "--matrix", matrix, "--out", folder, output=subprocess.DEVNULL)
    first = ["--index", "0"] if is_quick else []
    program.run("batch", "run", folder, "--jobs", jobs, *first, output=subprocess.DEVNULL)


def load(study: str) -> list[Cell]:
    """All cells of a study, finished or not; none when it was never begun."""
    folder = RUNS / study
    if not (folder / "manifest.jsonl").exists():
        return []
    program.run("batch", "collect", folder, output=subprocess.DEVNULL)
    return [
        Cell(
            scene=pathlib.Path(element["cell"]["scene"]).stem,
            start=element["cell"]["start"],
            delta_m=element["cell"]["delta_m"],
            homotopy=pathlib.Path(element["cell"]["homotopy"]).name if element["cell"]["homotopy"] else None,
            state=element["state"],
            failure=element["failure"],
            result=element["result"],
            folder=folder / element["cell"]["folder"],
        )
        for element in json.loads((folder / "cells.json").read_text())
    ]
