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
# Everything that a player reads is kept.
KEPT = ("plan.json", "trajectory.csv", "plan.script", "controllers.yaml")
# Those for the arm with six joints that is commanded by position or force, with a soft contact, so that motions are
# short. In front of the corner it stands closer, where no joint has to move fast.
COMMANDED_PLANS = (("corner", "position"), ("corner", "force"))
COMMANDED = {"control_period": 0.002, "contact_stiffness": 2e4}
# Rotations that a spring on the measured pose does not make swing.
SOFT = {"stiffness_range": {"rotational": [1.0, 50.0]}}
CLOSER = {"base": {"position": [-0.45, -0.1, -0.1], "orientation": [1.0, 0.0, 0.0, 0.0]}}
GAINS = {"translational_gain": 8e-4, "rotational_gain": 0.16, "force_deadband": 0.5}
# What they are commanded, and the target of their exports.
INTERFACES = {
    "position": ({"interface": "position"} | SOFT, "ros2-control"),
    "force": ({"interface": "force", "force_mode": GAINS}, "urscript"),
}


def record(name: str, scene: str, robot: dict, target: str) -> None:
    """Makes one plan and keeps its export."""
    with tempfile.TemporaryDirectory() as work:
        file, plan = pathlib.Path(work) / f"{scene}.toml", pathlib.Path(work) / "plan"
        file.write_text(with_robot((SCENES / f"{scene}.toml").read_text(), robot))
        # A plan that is nearly as robust as wanted will do.
        program.run("solve", file, *FLAGS, "--out", plan)
        keep(plan, RECORDED / name, target)


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
    plans = {
        f"{scene}-{arm}": (scene, robot_of(ARMS / f"{arm}.toml"), "urscript" if arm == "six" else "csv")
        for scene, arm in PLANS
    }
    for scene, interface in COMMANDED_PLANS:
        more, target = INTERFACES[interface]
        robot = robot_of(ARMS / "six.toml") | COMMANDED | more | (CLOSER if scene == "corner" else {})
        plans[f"{scene}-{interface}"] = (scene, robot, target)
    for name, plan in plans.items():
        if not names or name in names:
            record(name, *plan)
