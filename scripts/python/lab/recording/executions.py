"""What players log of an arm that is not what its scene says, for the tests of the crate `calibration`."""

import json
import pathlib
import tempfile

from lab.errors import Failure
from lab.players.case import Case
from lab.players.play import run

# What MuJoCo is given. The scene says rotor inertia 0.1 kg m^2, joint friction 0.5 Nm and no delay.
TRUTH = {"rotor_inertia": 0.14, "joint_friction": 0.8, "delay": 0.004, "damping": 0.85, "friction": 0.25}
OTHERS = {
    "light": {"rotor_inertia": 0.08, "joint_friction": 0.3, "delay": 0.001, "stiffness": 1.2, "damping": 1.2},
    "late": {"rotor_inertia": 0.28, "joint_friction": 1.0, "delay": 0.008, "stiffness": 0.9, "damping": 0.8},
    "stiff": {"rotor_inertia": 0.3, "joint_friction": 3.0, "delay": 0.005, "stiffness": 0.8, "damping": 1.1},
}
# The scene of the robot that is commanded by position says 20 Hz, 4 ms and no bias.
COMMANDED = {"position": {"bandwidth": 12.0, "delay": 0.009, "bias": (0.8, -0.5, 1.2, 0.03, 0.02, -0.04)}}
# A grasp error that the plan tolerates with this friction.
OFFSET, TURN = (0.003, 0.003, 0.0), (0.0, 0.005, 0.0)
FLAGS = ("--message", "motion-update", "--rate", "100")
DRY = (*FLAGS, "--dry-run", "0.05")
# Joints with much friction turn with higher gains only.
GAINS = ("--stiffness-factor", "2", "--damping-factor", "1.4")
CASES = {
    "free_air": Case("free air", "ros2", "clamp1", flags=DRY),
    "contact": Case(
        "contact", "ros2", "clamp1", flags=(*FLAGS, "--skip-self-test"), simulation={"offset": OFFSET, "turn": TURN}
    ),
    "light": Case("light", "ros2", "clamp1", flags=DRY),
    "late": Case("late", "ros2", "clamp1", flags=DRY),
    "stiff": Case("stiff", "ros2", "clamp1", flags=(*DRY, *GAINS)),
    "position": Case("position", "ros2-control", "corner", flags=("--dry-run", "0.05", "--path-is-free")),
}
# Time between two rows that are kept (s): rollouts are compared no more often.
APART = 0.0099
# Decimals that are kept, fewer of measured velocities, which fits do not need.
DECIMALS, FEW = 6, 2
VELOCITIES = ("vx_m_s", "vy_m_s", "vz_m_s", "wx_rad_s", "wy_rad_s", "wz_rad_s")
DROPPED = ("fx_n", "fy_n", "fz_n", "tx_nm", "ty_nm", "tz_nm")


def shortened(log: str) -> str:
    """A log with fewer rows, columns and decimals."""
    header, names, *rows = log.splitlines()
    columns = names.split(",")
    kept = [index for index, name in enumerate(columns) if name not in DROPPED]

    def cell(row: list[str], index: int) -> str:
        if columns[index] == "phase":
            return row[index]
        return f"{round(float(row[index]), FEW if columns[index] in VELOCITIES else DECIMALS) + 0.0:g}"

    lines, last = [], -APART
    for text in rows:
        row = text.split(",")
        time = float(row[columns.index("elapsed_s")])
        if time >= last + APART or text is rows[-1]:
            lines.append(",".join(cell(row, index) for index in kept))
            last = time
    return "\n".join([header, ",".join(columns[index] for index in kept), *lines]) + "\n"


def write(folder: pathlib.Path, names: list[str]) -> None:
    """Records the logs that are named, or all, and what MuJoCo was given."""
    (folder / "truths.json").write_text(json.dumps(OTHERS, indent=2) + "\n")
    (folder / "commanded.json").write_text(json.dumps(COMMANDED, indent=2) + "\n")
    for name, case in CASES.items():
        if names and name not in names:
            continue
        with tempfile.TemporaryDirectory() as work:
            case.simulation["truth"] = COMMANDED.get(name) or OTHERS.get(name, TRUTH)
            if problem := run(case, "", pathlib.Path(work)):
                raise Failure(f"{case.name}: {problem}")
            log = (pathlib.Path(work) / case.folder / "executed.csv").read_text()
            (folder / f"{name}.csv").write_text(shortened(log))
