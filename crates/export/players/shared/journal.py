"""What happened, in the CSV format of the planner: where the robot believed the part, the wrench at the tool, and the reference
that was followed. The first line says for which plan and with which gains, so that a log needs no other file."""

import contextlib
import pathlib
import sys
from typing import Any

import numpy as np

import rotations
from exported_plan import ANGULAR_VELOCITY, POSITION, QUATERNION, VELOCITY, ExportedPlan, ToolState
from guards import Measurement
from log_file import LogFile

# Version of the log; readers refuse others.
FORMAT = 1

STATE = POSITION + QUATERNION + VELOCITY + ANGULAR_VELOCITY
WRENCH = ("fx_n", "fy_n", "fz_n", "tx_nm", "ty_nm", "tz_nm")
COLUMNS = ("time_s", *STATE, *WRENCH, "elapsed_s", *(f"reference_{name}" for name in STATE), "phase")


class Journal:
    """Writes measurements as they come; says on standard error what happens."""

    def __init__(self, plan: ExportedPlan, file: pathlib.Path | None, header: dict[str, Any]) -> None:
        self.plan, self.log = plan, LogFile(file, header, ",".join(COLUMNS))
        self.phase, self.begin, self.first, self.count = "", 0.0, None, 0

    def start(self, phase: str, time: float) -> None:
        """Begins a phase, whose time counts from here (s)."""
        self.phase, self.begin = phase, time
        say(phase)

    def add(self, measured: Measurement, reference: ToolState) -> None:
        """A measurement and the reference that answers it; force and torque as the robot says them."""
        if self.first is None:
            self.first = measured.time
        numbers = [
            *self.state(measured.tool), measured.force, measured.torque, [measured.time - self.first], *self.state(reference)
        ]
        values = ",".join(f"{number:.9g}" for number in np.concatenate(numbers).tolist())
        self.log.add(f"{measured.time - self.begin:.6f},{values},{self.phase}")
        self.count += 1

    def state(self, tool: ToolState) -> list[np.ndarray]:
        """Pose and velocity of the part in the world, angular velocity in its own frame, as in the tables of plans."""
        plan, part = self.plan, self.plan.part(tool.pose)
        lever = tool.pose.rotation @ plan.grasp.position
        velocity = plan.base.rotation @ (tool.velocity + rotations.cross(tool.angular_velocity, lever))
        spin = part.rotation.T @ plan.base.rotation @ tool.angular_velocity
        return [part.position, rotations.quaternion(part.rotation), velocity, spin]

    def close(self, stopped: str | None) -> None:
        """Writes the end of the log, with why the session was stopped, if it was. What goes wrong with that hides no reason."""
        try:
            self.log.close(stopped)
            say(f"{self.count} measurements written to {self.log.path}")
        except OSError as error:
            say(f"the end of {self.log.path} cannot be written: {error.strerror}")


def say(text: str) -> None:
    """Tells the user, who may have gone."""
    with contextlib.suppress(OSError, ValueError):
        print(text, file=sys.stderr, flush=True)
