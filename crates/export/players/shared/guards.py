"""When a robot is stopped: force, deviation, frames, joints and time. The limits are those of plan.json unless flags say otherwise.
Every comparison is written so that what is no number stops."""

import collections
import dataclasses
import math
from typing import Any

import numpy as np

from exported_plan import ExportedPlan, ToolState
from failures import ConnectionLost, Stopped
from kinematics import Arm

# A force is the mean over this time (s): how high an impact peaks is a matter of the sampling, its impulse is not.
WINDOW = 0.01
# Joints stop this far from their limits (rad or m).
JOINT_MARGIN = 0.02
# Longest time between two measurements (s): a robot that is out of reach for longer is not controlled any more.
LONGEST_GAP = 0.1
# The pose that the robot says and the one that follows from its joints may differ by this much (m, rad) at rest, as arms are
# calibrated, and in motion, as the two are not measured at one time.
SAME_POSITION, SAME_ANGLE = 0.005, 0.02
MOVING_POSITION, MOVING_ANGLE = 0.010, 0.04
# In free air, a tool swings by itself that is faster than its reference and these (m/s, rad/s), as a mean over this time (s).
SWING_TIME, SWING_SPEED, SWING_TURNING = 0.2, 0.08, 0.4


@dataclasses.dataclass(frozen=True)
class Measurement:
    """What a robot says of itself: its time (s), joint positions (rad or m) and speeds, the state of its tool in its base, and
    force (N) and torque (Nm) at the tool. Signs of the latter differ between makers; guards use their size alone."""

    time: float
    positions: np.ndarray
    speeds: np.ndarray
    tool: ToolState
    force: np.ndarray
    torque: np.ndarray

    def require_whole(self, arm: Arm | None) -> None:
        """Stops where a value is missing or no number."""
        joints = 0 if arm is None else len(arm.names)
        sizes = (("joint positions", self.positions, joints), ("joint speeds", self.speeds, joints))
        for name, values, size in (*sizes, ("force", self.force, 3), ("torque", self.torque, 3)):
            if np.shape(values) != (size,) or not np.isfinite(values).all():
                raise Stopped(f"the robot says no numbers for its {name}: {np.array2string(np.asarray(values), precision=4)}")
        rotation = self.tool.pose.rotation
        if not (self.tool.is_finite() and np.abs(rotation @ rotation.T - np.eye(3)).max() <= 1e-3):
            raise Stopped("the robot says no numbers, or no rotation, for the pose or velocity of its tool")
        require_later(self.time, -np.inf)


@dataclasses.dataclass(frozen=True)
class Limits:
    """Values beyond which the robot is stopped: force (N), torque (Nm), deviation of the tool (m, rad)."""

    force: float
    torque: float
    distance: float
    angle: float

    @staticmethod
    def of(guards: dict[str, Any]) -> "Limits":
        """Those of a phase in plan.json."""
        return Limits(guards["force_n"], guards["torque_nm"], guards["deviation_m"], guards["deviation_rad"])

    def within(self, other: "Limits") -> "Limits":
        """The tighter ones of both."""
        pairs = zip(dataclasses.astuple(self), dataclasses.astuple(other))
        return Limits(*(min(pair) for pair in pairs))


class Guards:
    """Checks every measurement. `deadline` is the time of the robot (s) at which all motion must be over."""

    def __init__(self, plan: ExportedPlan, at_rest: Measurement, longest: float) -> None:
        self.arm = plan.arm
        self.rest_force, self.rest_torque = at_rest.force, at_rest.torque
        self.deadline = at_rest.time + longest
        self.last = at_rest.time
        self.window: collections.deque[tuple[float, np.ndarray, np.ndarray]] = collections.deque()
        # By how much the tool is faster than its reference (m/s, rad/s).
        self.swing = [0.0, 0.0]

    def check(self, measured: Measurement, reference: ToolState, limits: Limits, in_free_air: bool) -> None:
        """Raises Stopped at the first thing that is not as planned."""
        if in_free_air:
            self.check_swing(measured, reference)
        self.check_time(measured)
        self.check_force(measured, limits)
        self.check_deviation(measured, reference, limits)
        self.check_joints(measured)
        self.check_frames(measured)

    def check_time(self, measured: Measurement) -> None:
        """No gap, no time that runs backwards, and no motion without an end."""
        gap, self.last = measured.time - self.last, measured.time
        if not gap <= LONGEST_GAP:
            raise ConnectionLost(f"nothing was heard of the robot for {gap:.2f} s, longer than {LONGEST_GAP:g} s")
        if not gap > 0:
            raise Stopped(f"the time of the robot does not go on: it steps by {gap:.3f} s")
        if not measured.time <= self.deadline:
            raise Stopped("the motion takes longer than it can: the robot may run slower than asked for")

    def check_swing(self, measured: Measurement, reference: ToolState) -> None:
        """Nothing but its controller moves a tool in free air: one whose torques come late swings."""
        share = min(1.0, max(0.0, measured.time - self.last) / SWING_TIME)
        pairs = ((measured.tool.velocity, reference.velocity), (measured.tool.angular_velocity, reference.angular_velocity))
        excess = [math.dist(one, other) - math.hypot(*other) for one, other in pairs]
        self.swing = [(1 - share) * before + share * now for before, now in zip(self.swing, excess)]
        if not (self.swing[0] <= SWING_SPEED and self.swing[1] <= SWING_TURNING):
            raise Stopped(
                f"the tool swings by itself, at {1e3 * self.swing[0]:.0f} mm/s and {self.swing[1]:.2f} rad/s: torques come too late for "
                "the damping; try --damping-factor 0.7, then also --stiffness-factor 0.7"
            )

    def check_force(self, measured: Measurement, limits: Limits) -> None:
        """Force and torque since the robot was at rest, as means."""
        self.window.append((measured.time, measured.force - self.rest_force, measured.torque - self.rest_torque))
        while self.window[0][0] < measured.time - WINDOW + 1e-9:
            self.window.popleft()
        for column, limit, name, unit in ((1, limits.force, "force", "N"), (2, limits.torque, "torque", "Nm")):
            size = float(np.linalg.norm(np.mean([entry[column] for entry in self.window], axis=0)))
            if not size <= limit:
                raise Stopped(f"{name} of {size:.3g} {unit} at the tool, beyond {limit:.3g} {unit}")

    def check_deviation(self, measured: Measurement, reference: ToolState, limits: Limits) -> None:
        """The tool is where the reference is, but for what the plan expects."""
        distance, angle = measured.tool.pose.errors(reference.pose)
        if not distance <= limits.distance:
            raise Stopped(f"the tool is {1e3 * distance:.1f} mm from its reference, beyond {1e3 * limits.distance:.1f} mm")
        if not angle <= limits.angle:
            raise Stopped(f"the tool is turned by {angle:.3f} rad from its reference, beyond {limits.angle:.3f} rad")

    def check_joints(self, measured: Measurement) -> None:
        """No joint is near its limit, or faster than it can."""
        if self.arm is None:
            return
        arm, positions = self.arm, measured.positions
        inside = (positions >= arm.lower + JOINT_MARGIN) & (positions <= arm.upper - JOINT_MARGIN)
        if not inside.all():
            joint = int(np.argmin(inside))
            raise Stopped(
                f"joint `{arm.names[joint]}` is at {positions[joint]:.3f}, within {JOINT_MARGIN:g} of its limits "
                f"{arm.lower[joint]:.3f} and {arm.upper[joint]:.3f}"
            )
        slow = np.abs(measured.speeds) <= arm.speed
        if not slow.all():
            joint = int(np.argmin(slow))
            raise Stopped(f"joint `{arm.names[joint]}` moves at {measured.speeds[joint]:.2f}, its limit is {arm.speed[joint]:.2f}")

    def check_frames(self, measured: Measurement) -> None:
        """The pose of the tool is still that of its joints."""
        if self.arm is None:
            return
        distance, angle = measured.tool.pose.errors(self.arm.forward(measured.positions))
        if not (distance <= MOVING_POSITION and angle <= MOVING_ANGLE):
            raise Stopped(
                f"the robot says its tool {1e3 * distance:.1f} mm and {angle:.3f} rad from where its joints have it: one of the two "
                "is measured wrongly, or late"
            )


def require_later(time: float, last: float) -> None:
    """The time of a robot (s) goes on."""
    if not np.isfinite(time):
        raise Stopped("the robot says no number for its time")
    if not time > last:
        raise Stopped(f"the time of the robot runs backwards: from {last:.3f} to {time:.3f} s")


def require_command(name: str, values: Any) -> None:
    """Nothing is sent to a robot that is no number."""
    if not np.isfinite(values).all():
        raise Stopped(f"the {name} that would be sent is no number")
