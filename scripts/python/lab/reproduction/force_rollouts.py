"""The same plans and offsets as in MuJoCo, in the program's own rollouts, and a straight push beside them."""

import math

from lab import program, tables
from lab.reproduction import force_scenes, studies
from lab.reproduction.force_plays import DIRECTIONS, LAST, Play, Played, finished

FOLDER = studies.RUNS / "force_mode/rollouts"
FRICTIONS = (0.0, 0.1, 0.3)
PLANNED, STRAIGHT = "plan", "straight push"


def run(jobs: int, is_quick: bool) -> None:
    """Plays all plans that are not played yet; only the first for a quick look."""
    FOLDER.mkdir(parents=True, exist_ok=True)
    offsets = FOLDER / "offsets.csv"
    injected = [
        [magnitude * part for part in direction]
        for magnitude in force_scenes.DELTAS
        for direction in (DIRECTIONS.values() if magnitude else [(0.0, 0.0, 0.0)])
    ]
    tables.write(offsets, ["x_m", "y_m", "z_m"], injected)
    frictions = ",".join(map(str, FRICTIONS))
    for clamp, cell in finished()[: 1 if is_quick else None]:
        folder = FOLDER / clamp / cell.folder.name
        if not (folder / "success.csv").exists():
            options = ["--offsets", offsets, "--friction", frictions, "--jobs", jobs, "--out", folder]
            program.run("simulate", cell.folder, *options)


def read() -> dict[str, dict[Play, Played]]:
    """The motions of the plans and of the straight push."""
    found: dict[str, dict[Play, Played]] = {PLANNED: {}, STRAIGHT: {}}
    for clamp, cell in finished():
        file = FOLDER / clamp / cell.folder.name / "rollouts.csv"
        for row in tables.read(file) if file.exists() else []:
            found[row["motion"]][play_of(clamp, cell, row)] = Played(
                position_error=float(row["position_error_m"]),
                angle_error=float(row["orientation_error_rad"]),
                force=float(row["max_force_n"]),
                success=row["success"] == "1",
            )
    return found


def play_of(clamp: str, cell: studies.Cell, row: tables.Row) -> Play:
    """What a row is of."""
    x, y = float(row["x_m"]), float(row["y_m"])
    direction = list(DIRECTIONS)[y < 0]
    # Directions are rounded.
    return Play(clamp, cell.start, cell.delta_m, LAST, direction, round(math.hypot(x, y), 5), float(row["friction"]))
