"""Plans scenes for arms and keeps what the players read of them: `record.py PROGRAM [NAME...]`."""

import pathlib
import shutil
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[1]
sys.path.insert(0, str(ROOT / "scripts"))

from robust_arm import robot_of, with_robot

# Scenes and arms.
PLANS = (("corner", "six"), ("clamp1", "six"), ("peg1", "six"), ("corner", "seven"), ("clamp1", "seven"), ("peg1", "seven"))
FLAGS = ["--robust", "--turn", "0.01", "--friction", "0,0.1", "--time-limit", "300"]
# Of `urscript`, everything that a player reads is kept.
KEPT = ("plan.json", "trajectory.csv", "plan.script")


def record(program: pathlib.Path, scene: str, arm: str) -> None:
    """Makes one plan and exports it."""
    robot = robot_of(ROOT / f"scripts/mujoco_validation/arms/{arm}.toml")
    with tempfile.TemporaryDirectory() as work:
        file, plan = pathlib.Path(work) / f"{scene}.toml", pathlib.Path(work) / "plan"
        file.write_text(with_robot((ROOT / f"scenes/{scene}.toml").read_text(), robot))
        # A plan that is nearly as robust as wanted will do.
        if subprocess.run([program, "solve", file, *FLAGS, "--out", plan], check=False).returncode > 1:
            sys.exit(f"error: {scene} has no plan for {arm}")
        keep(program, plan, HERE / f"recorded/{scene}-{arm}", "urscript" if arm == "six" else "csv")


def keep(program: pathlib.Path, plan: pathlib.Path, folder: pathlib.Path, target: str) -> None:
    """Exports a plan and keeps what players read."""
    with tempfile.TemporaryDirectory() as work:
        subprocess.run([program, "export", plan, "--to", target, "--rate", "100", "--anyway", "--out", work], check=True)
        shutil.rmtree(folder, ignore_errors=True)
        folder.mkdir(parents=True)
        for name in KEPT:
            if (pathlib.Path(work) / name).exists():
                shutil.copy(pathlib.Path(work) / name, folder)


def main() -> None:
    """Records what the command line names, or all."""
    program, *names = sys.argv[1:]
    for scene, arm in PLANS:
        if not names or f"{scene}-{arm}" in names:
            record(pathlib.Path(program), scene, arm)


if __name__ == "__main__":
    main()
