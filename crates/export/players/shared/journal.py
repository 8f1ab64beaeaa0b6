"""What happened, in the CSV format of the planner: where the robot believed the part, and the wrench at the tool."""

import pathlib
import sys

import numpy as np

import rotations
from exported_plan import ExportedPlan
from guards import Measurement

HEADER = (
    "time_s,px_m,py_m,pz_m,qw,qx,qy,qz,vx_m_s,vy_m_s,vz_m_s,wx_rad_s,wy_rad_s,wz_rad_s,"
    "fx_n,fy_n,fz_n,tx_nm,ty_nm,tz_nm,phase"
)


class Journal:
    """Keeps measurements and writes them at the end, whatever the end is; says on standard error what happens."""

    def __init__(self, plan: ExportedPlan, file: pathlib.Path) -> None:
        self.plan, self.file = plan, file
        self.rows: list[str] = []
        self.phase, self.begin = "", 0.0

    def start(self, phase: str, time: float) -> None:
        """Begins a phase, whose time counts from here (s)."""
        self.phase, self.begin = phase, time
        self.say(phase)

    def say(self, text: str) -> None:
        """Tells the user."""
        print(text, file=sys.stderr, flush=True)

    def add(self, measured: Measurement) -> None:
        """A measurement: pose and velocity of the part in the world, angular velocity in its own frame, as in the tables of
        plans; force and torque as the robot says them."""
        plan, tool = self.plan, measured.tool
        part = plan.part(tool.pose)
        lever = tool.pose.rotation @ plan.grasp.position
        velocity = plan.base.rotation @ (tool.velocity + np.cross(tool.angular_velocity, lever))
        spin = part.rotation.T @ plan.base.rotation @ tool.angular_velocity
        numbers = [part.position, rotations.quaternion(part.rotation), velocity, spin, measured.force, measured.torque]
        values = ",".join(f"{number:.9g}" for number in np.concatenate(numbers))
        self.rows.append(f"{measured.time - self.begin:.6f},{values},{self.phase}")

    def write(self) -> None:
        """Writes the table."""
        self.file.parent.mkdir(parents=True, exist_ok=True)
        self.file.write_text("\n".join([HEADER, *self.rows]) + "\n")
        self.say(f"{len(self.rows)} measurements written to {self.file}")
