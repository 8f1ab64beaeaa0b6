"""What the parts of the search for robust plans are worth."""

import argparse
import concurrent.futures
import dataclasses
import json
import pathlib
import statistics

from lab import arm_scenes, program, toml
from lab.paths import ROOT

# Parameters that switch a part of the search off: `robust.parameters` of a result.
SEARCHES = {
    "all parts": {},
    "no push": {"time": {"push": 0.0}},
    "no drafts": {"drafts": {"most": 0}},
    "no margins": {"margins": {"friction": 1.0}},
    "no simplification": {"simplification": {"attempts": 0}},
    "no spiral": {"spiral": {"pitch": 0.0}},
    "no spread of evaluations": {"evaluation": {"spread": 0.0}},
    "no stricter force": {"training": {"force_share": 1.0}, "evaluation": {"force_share": 1.0}},
    "no failures in variants": {"portfolio": {"added_failures": 0}},
}


@dataclasses.dataclass(frozen=True)
class Case:
    """A plan of the study."""

    search: str
    scene: str
    seed: int

    def folder(self, out: pathlib.Path) -> pathlib.Path:
        """Where its files are."""
        return out / self.search.replace(" ", "-") / f"{self.scene}-{self.seed}"


def study(arguments: argparse.Namespace) -> str:
    """Plans all cases that are missing; returns the table as Markdown."""
    seeds = range(1, arguments.seeds + 1)
    cases = [Case(search, scene, seed) for seed in seeds for scene in arguments.scenes for search in arguments.search]
    with concurrent.futures.ThreadPoolExecutor(arguments.jobs) as pool:
        results = dict(zip(cases, pool.map(lambda case: plan(arguments, case), cases), strict=True))
    return table(arguments, results)


def plan(arguments: argparse.Namespace, case: Case) -> dict:
    """The result of a case."""
    folder = case.folder(arguments.out)
    if not (folder / "plan/result.json").exists():
        folder.mkdir(parents=True, exist_ok=True)
        scene, parameters = folder / "scene.toml", folder / "parameters.toml"
        text = (ROOT / f"scenes/{case.scene}.toml").read_text()
        scene.write_text(arm_scenes.with_robot(text, arm_scenes.robot_of(arguments.arm)) if arguments.arm else text)
        parameters.write_text(toml.text(SEARCHES[case.search] | {"seeds": {"first": 1000 * case.seed + 1}}))
        options = ["--friction", arguments.friction, "--time-limit", arguments.time, "--robust-parameters", parameters]
        command = ["solve", scene, "--robust", "--jobs", 1, "--out", folder / "plan", *options]
        program.measured(*command, log=folder / "log.txt", program=arguments.program)
    return json.loads((folder / "plan/result.json").read_text())


def rate(result: dict) -> float:
    """Success rate of the rollouts of the plan that were played."""
    rows = result["robust"]["after"]
    return sum(row["successes"] for row in rows) / max(1, sum(row["rollouts"] for row in rows))


def table(arguments: argparse.Namespace, results: dict[Case, dict]) -> str:
    """For each search and scene: plans that are robust, and the means of their success rates and times."""
    count = arguments.seeds
    lines = ["| search | " + " | ".join(arguments.scenes) + " |", "|---|" + "---|" * len(arguments.scenes)]
    for search in arguments.search:
        cells = []
        for scene in arguments.scenes:
            own = [results[Case(search, scene, seed)] for seed in range(1, count + 1)]
            robust = sum(result["robust"]["reached"] for result in own)
            mean = 100 * statistics.mean(map(rate, own))
            seconds = statistics.mean(result["robust"]["wall_s"] for result in own)
            cells.append(f"{robust} of {count}, {mean:.1f} %, {seconds:.0f} s")
        lines.append(f"| {search} | " + " | ".join(cells) + " |")
    return "\n".join(lines) + "\n"
