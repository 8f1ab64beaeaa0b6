"""Plans of scenes for arms: what the players read of them."""

import pathlib
import shutil
import tempfile

from lab import program
from lab.arm_scenes import robot_of, with_robot
from lab.paths import ARMS, SCENES

RECORDED = pathlib.Path(__file__).resolve().parents[1] / "players/recorded"
# Scenes and arms.
PLANS = (
    ("corner", "six"),
    ("clamp1", "six"),
    ("peg1", "six"),
    ("corner", "seven"),
    ("clamp1", "seven"),
    ("peg1", "seven"),
)
FLAGS = ["--robust", "--rotation-error", "0.01", "--friction", "0,0.1", "--time-limit", "300"]
# Of `urscript`, everything that a player reads is kept.
KEPT = ("plan.json", "trajectory.csv", "plan.script")


def record(scene: str, arm: str) -> None:
    """Makes one plan and keeps its export."""
    with tempfile.TemporaryDirectory() as work:
        file, plan = pathlib.Path(work) / f"{scene}.toml", pathlib.Path(work) / "plan"
        file.write_text(with_robot((SCENES / f"{scene}.toml").read_text(), robot_of(ARMS / f"{arm}.toml")))
        # A plan that is nearly as robust as wanted will do.
        program.run("solve", file, *FLAGS, "--out", plan)
        keep(plan, RECORDED / f"{scene}-{arm}", "urscript" if arm == "six" else "csv")


def keep(plan: pathlib.Path, folder: pathlib.Path, target: str) -> None:
    """Exports a plan and keeps what players read."""
    with tempfile.TemporaryDirectory() as work:
        program.run("export", plan, "--to", target, "--rate", "100", "--anyway", "--out", work, accepted=(0,))
        shutil.rmtree(folder, ignore_errors=True)
        folder.mkdir(parents=True)
        for name in KEPT:
            if (pathlib.Path(work) / name).exists():
                shutil.copy(pathlib.Path(work) / name, folder)


def write(names: list[str]) -> None:
    """Records the plans with these names, or all."""
    for scene, arm in PLANS:
        if not names or f"{scene}-{arm}" in names:
            record(scene, arm)
