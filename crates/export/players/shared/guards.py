"""When a robot is stopped: force, deviation, joints and time. The limits are those of plan.json unless flags say otherwise."""

import collections
import dataclasses

import numpy as np

from exported_plan import ExportedPlan, ToolState

# A force is the mean over this time (s): how high an impact peaks is a matter of the sampling, its impulse is not.
WINDOW = 0.01
# Joints stop this far from their limits (rad or m).
JOINT_MARGIN = 0.02
# Longest time between two measurements (s): a robot that is out of reach for longer is not controlled any more.
LONGEST_GAP = 0.1


class Stopped(Exception):
    """Something is not as planned: the robot has to stop."""


class ConnectionLost(Stopped):
    """The robot does not answer, or does not do any more what it is told."""


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


@dataclasses.dataclass
class Limits:
    """Values beyond which the robot is stopped: force (N), torque (Nm), deviation of the tool (m, rad)."""

    force: float
    torque: float
    distance: float
    angle: float

    @staticmethod
    def of(plan: ExportedPlan) -> "Limits":
        """Those of the plan."""
        guards = plan.document["guards"]
        return Limits(guards["force_n"], guards["torque_nm"], guards["deviation_m"], guards["deviation_rad"])


class Guards:
    """Checks every measurement. `deadline` is the time of the robot (s) at which all motion must be over."""

    def __init__(self, plan: ExportedPlan, limits: Limits, at_rest: Measurement, longest: float) -> None:
        self.arm, self.limits = plan.arm, limits
        self.rest_force, self.rest_torque = at_rest.force, at_rest.torque
        self.deadline = at_rest.time + longest
        self.last = at_rest.time
        self.window: collections.deque[tuple[float, np.ndarray, np.ndarray]] = collections.deque()

    def check(self, measured: Measurement, reference: ToolState) -> None:
        """Raises Stopped at the first thing that is not as planned."""
        self.check_time(measured)
        self.check_force(measured)
        self.check_deviation(measured, reference)
        self.check_joints(measured)

    def check_time(self, measured: Measurement) -> None:
        """No gap, and no motion without an end."""
        gap, self.last = measured.time - self.last, measured.time
        if gap > LONGEST_GAP:
            raise ConnectionLost(f"nothing was heard of the robot for {gap:.2f} s, longer than {LONGEST_GAP:g} s")
        if measured.time > self.deadline:
            raise Stopped("the motion takes longer than it can: the robot may run slower than asked for")

    def check_force(self, measured: Measurement) -> None:
        """Force and torque since the robot was at rest, as means."""
        self.window.append((measured.time, measured.force - self.rest_force, measured.torque - self.rest_torque))
        while self.window[0][0] < measured.time - WINDOW + 1e-9:
            self.window.popleft()
        for column, limit, name, unit in ((1, self.limits.force, "force", "N"), (2, self.limits.torque, "torque", "Nm")):
            size = float(np.linalg.norm(np.mean([entry[column] for entry in self.window], axis=0)))
            if not size <= limit:
                raise Stopped(f"{name} of {size:.3g} {unit} at the tool, beyond {limit:.3g} {unit}")

    def check_deviation(self, measured: Measurement, reference: ToolState) -> None:
        """The tool is where the reference is, but for what the plan expects."""
        distance, angle = measured.tool.pose.errors(reference.pose)
        if not distance <= self.limits.distance:
            raise Stopped(f"the tool is {1e3 * distance:.1f} mm from its reference, beyond {1e3 * self.limits.distance:.1f} mm")
        if not angle <= self.limits.angle:
            raise Stopped(f"the tool is turned by {angle:.3f} rad from its reference, beyond {self.limits.angle:.3f} rad")

    def check_joints(self, measured: Measurement) -> None:
        """No joint is near its limit, or faster than it can."""
        if self.arm is None:
            return
        arm, positions = self.arm, measured.positions
        beyond = (positions < arm.lower + JOINT_MARGIN) | (positions > arm.upper - JOINT_MARGIN)
        if beyond.any():
            joint = int(np.argmax(beyond))
            raise Stopped(
                f"joint `{arm.names[joint]}` is at {positions[joint]:.3f}, within {JOINT_MARGIN:g} of its limits "
                f"{arm.lower[joint]:.3f} and {arm.upper[joint]:.3f}"
            )
        fast = np.abs(measured.speeds) > arm.speed
        if fast.any():
            joint = int(np.argmax(fast))
            raise Stopped(f"joint `{arm.names[joint]}` moves at {measured.speeds[joint]:.2f}, its limit is {arm.speed[joint]:.2f}")
