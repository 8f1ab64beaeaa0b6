"""How robust plans do when their start is measured again."""

import argparse
import dataclasses
import json
import math
import pathlib
import statistics
import tomllib
import zlib

import matplotlib.pyplot as plt
import numpy as np

from lab import program, tables, toml
from lab.mujoco.rotations import product, quaternion_of
from lab.paths import SCENES

COLUMNS = ["scene", "mm and degrees", "robust", "moved plan as it is", "refined", "solved", "median, s", "largest, s"]


@dataclasses.dataclass(frozen=True)
class Case:
    """A start of a scene that is off by some millimetres and as many degrees."""

    scene: str
    distance: float
    number: int


@dataclasses.dataclass(frozen=True)
class Moved:
    """What became of a plan there."""

    is_robust: bool
    # Iterations of the solver, and perturbations that refinement kept.
    iterations: int
    perturbations: int
    wall_s: float


def study(arguments: argparse.Namespace) -> str:
    """Does all that is missing, draws the figure; returns the table as Markdown."""
    distances = [float(text) for text in arguments.distances.split(",")]
    results: dict[Case, Moved] = {}
    for scene in arguments.scenes:
        first = arguments.out / scene / "plan"
        solve(arguments, SCENES / f"{scene}.toml", first)
        for distance in distances:
            for number in range(1, arguments.count + 1):
                case = Case(scene, distance, number)
                results[case] = replanned(arguments, first, case)
    draw(arguments, distances, results)
    return tables.markdown(COLUMNS, rows(arguments, distances, results))


def replanned(arguments: argparse.Namespace, earlier: pathlib.Path, case: Case) -> Moved:
    """The plan for a start that is off."""
    folder = arguments.out / case.scene / f"{case.distance:g}-{case.number}"
    folder.mkdir(parents=True, exist_ok=True)
    scene = folder / "scene.toml"
    content = tomllib.loads((earlier / "resolved.toml").read_text())
    content["start"][0] |= off(content["start"][0], case, arguments.seed)
    scene.write_text(toml.text(content))
    record = solve(arguments, scene, folder / "plan", "--from", earlier)
    result = json.loads((folder / "plan/result.json").read_text())
    perturbations = sum(entry["perturbations"] for entry in result["robust"]["rounds"])
    return Moved(result["done"], result["iterations"], perturbations, record["wall_s"])


def solve(arguments: argparse.Namespace, scene: pathlib.Path, out: pathlib.Path, *options: object) -> dict:
    """Plans robustly unless that was done; what it took."""
    record = out.with_suffix(".json")
    if not record.exists():
        out.parent.mkdir(parents=True, exist_ok=True)
        limits = ["--friction", arguments.friction, "--time-limit", arguments.time, "--jobs", arguments.jobs]
        command = ["solve", scene, "--robust", *limits, *options, "--out", out]
        usage = program.measured(*command, log=out.with_suffix(".log"), program=arguments.program)
        record.write_text(json.dumps(dataclasses.asdict(usage)))
    return json.loads(record.read_text())


def off(start: dict, case: Case, seed: int) -> dict:
    """The start of a case: another position, and another orientation about a random axis."""
    random = np.random.default_rng([seed, zlib.crc32(case.scene.encode()), case.number])
    shift, axis = (vector / np.linalg.norm(vector) for vector in random.normal(size=(2, 3)))
    position = np.array(start["position"]) + 1e-3 * case.distance * shift
    orientation = product(quaternion_of(math.radians(case.distance) * axis), np.array(start["orientation"]))
    return {"position": position.tolist(), "orientation": orientation.tolist()}


def rows(arguments: argparse.Namespace, distances: list[float], results: dict[Case, Moved]) -> list[list[object]]:
    """A row for each scene and distance."""
    lines: list[list[object]] = []
    for scene in arguments.scenes:
        for distance in distances:
            own = of(results, scene, distance)
            as_it_is = sum(moved.iterations + moved.perturbations == 0 for moved in own)
            solved = sum(moved.iterations > 0 for moved in own)
            seconds = [moved.wall_s for moved in own]
            counts = [sum(moved.is_robust for moved in own), as_it_is, len(own) - as_it_is - solved, solved]
            shown = [f"{count} of {len(own)}" for count in counts]
            lines.append([scene, f"{distance:g}", *shown, f"{statistics.median(seconds):.1f}", f"{max(seconds):.1f}"])
    return lines


def draw(arguments: argparse.Namespace, distances: list[float], results: dict[Case, Moved]) -> None:
    """Time, and plans that are robust, over the distance from the old start."""
    drawn, (time, success) = plt.subplots(1, 2, figsize=(9, 3.2), layout="constrained")
    for scene in arguments.scenes:
        per_distance = [of(results, scene, distance) for distance in distances]
        time.plot(
            distances, [statistics.median(moved.wall_s for moved in own) for own in per_distance], "o-", label=scene
        )
        shares = [100 * statistics.mean(moved.is_robust for moved in own) for own in per_distance]
        success.plot(distances, shares, "o-", label=scene)
    time.set(xlabel="start is off by (mm and degrees)", ylabel="median time (s)", ylim=(0, None))
    success.set(xlabel="start is off by (mm and degrees)", ylabel="robust plans (%)", ylim=(0, 105))
    success.legend()
    drawn.savefig(arguments.out / "replan.svg")
    plt.close(drawn)


def of(results: dict[Case, Moved], scene: str, distance: float) -> list[Moved]:
    """The results of a scene at a distance."""
    return [moved for case, moved in results.items() if (case.scene, case.distance) == (scene, distance)]
