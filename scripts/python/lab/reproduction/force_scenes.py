"""The clamps as tasks of a robot in force mode: scenes and batches of plans."""

import pathlib
import re

from lab import toml
from lab.paths import SCENES
from lab.reproduction import studies

CLAMPS = ("clamp1", "clamp2", "clamp3")
# Of the clamps' own scenes: what the robot's force mode replaces, and an inertia that only the paper's model has.
REPLACED = re.compile(r"^(inertia|(translational|rotational)_stiffness) = .*\n", re.MULTILINE)
# kg m^2: of gripper and clamp, which weigh 1 kg together.
INERTIA = 2.5e-3
# The stiffness (N/m, Nm/rad) that the paper commands, 15 and 20 times that of its plans. The gains of force mode, which
# the paper does not name, give the damping the same factors. They are stable against this contact stiffness (N/m).
STIFFNESS = {"translational_stiffness": 1500.0, "rotational_stiffness": 200.0}
FORCE_MODE = {"translational_gain": 1 / 300, "rotational_gain": 1 / 40}
CONTACT_STIFFNESS = 1e4
DELTAS = [0.0, 0.001, 0.002, 0.003, 0.004, 0.005]
HOMOTOPY = studies.MATRICES / "homotopies/force_mode.toml"


def study(clamp: str) -> str:
    """The name of a clamp's batch."""
    return f"force_{clamp}"


def scene(clamp: str) -> str:
    """The text of a clamp's scene for force mode."""
    text = REPLACED.sub("", (SCENES / f"{clamp}.toml").read_text())
    text = text.replace("[body]\n", f"[body]\ninertia = {[INERTIA] * 3}\n", 1)
    text = text.replace("[impedance]\n", "[impedance]\n" + toml.text(STIFFNESS), 1)
    robot = {"interface": "force", "contact_stiffness": CONTACT_STIFFNESS, "force_mode": FORCE_MODE}
    return text + "\n" + toml.text({"robot": robot})


def write(clamp: str) -> pathlib.Path:
    """Writes a clamp's scene and the matrix of its plans, which is returned."""
    folder = studies.RUNS / "force_mode"
    folder.mkdir(parents=True, exist_ok=True)
    (folder / f"{clamp}.toml").write_text(scene(clamp))
    matrix = folder / f"{study(clamp)}.toml"
    matrix.write_text(
        toml.text({"scenes": [f"{clamp}.toml"], "starts": "all", "deltas": DELTAS, "homotopies": [str(HOMOTOPY)]})
    )
    return matrix
