"""Keeps what players log of an arm that is not what its scene says, for the tests of `calibration`: `record_logs.py FOLDER`."""

import pathlib
import sys
import tempfile

from main import Case, run

# What MuJoCo is given. The scene says rotor inertia 0.1 kg m^2, joint friction 0.5 Nm and no delay.
TRUTH = {"rotor_inertia": 0.14, "joint_friction": 0.8, "delay": 0.004, "damping": 0.85, "friction": 0.25}
# A grasp error that the plan tolerates with this friction.
OFFSET, TURN = (0.003, 0.003, 0.0), (0.0, 0.005, 0.0)
FLAGS = ("--message", "motion-update", "--rate", "100")
CASES = {
    "free_air": Case("free air", "ros2", "clamp1", flags=(*FLAGS, "--dry-run", "0.05")),
    "contact": Case("contact", "ros2", "clamp1", flags=(*FLAGS, "--skip-self-test"), simulation={"offset": OFFSET, "turn": TURN}),
}
# Decimals that are kept, fewer of measured velocities, which fits do not need.
DECIMALS, FEW = 6, 2
VELOCITIES = ("vx_m_s", "vy_m_s", "vz_m_s", "wx_rad_s", "wy_rad_s", "wz_rad_s")
DROPPED = ("fx_n", "fy_n", "fz_n", "tx_nm", "ty_nm", "tz_nm")


def shortened(text: str) -> str:
    """A log with fewer rows, columns and decimals."""
    header, names, *rows = text.splitlines()
    columns = names.split(",")
    kept = [index for index, name in enumerate(columns) if name not in DROPPED]

    def cell(row: list[str], index: int) -> str:
        if columns[index] == "phase":
            return row[index]
        return f"{round(float(row[index]), FEW if columns[index] in VELOCITIES else DECIMALS) + 0.0:g}"

    lines = [",".join(cell(row.split(","), index) for index in kept) for row in rows]
    return "\n".join([header, ",".join(columns[index] for index in kept), *lines]) + "\n"


def main() -> int:
    """Records all logs; returns the exit code."""
    folder = pathlib.Path(sys.argv[1])
    folder.mkdir(parents=True, exist_ok=True)
    for name, case in CASES.items():
        with tempfile.TemporaryDirectory() as work:
            case.simulation["truth"] = TRUTH
            if problem := run(case, "", pathlib.Path(work)):
                print(f"error: {case.name}: {problem}", file=sys.stderr)
                return 3
            log = (pathlib.Path(work) / case.name.replace(" ", "-") / "executed.csv").read_text()
            (folder / f"{name}.csv").write_text(shortened(log))
    return 0


if __name__ == "__main__":
    sys.exit(main())
