"""A robot of Universal Robots over RTDE, by the package ur-rtde."""

import argparse
import time

import numpy as np
from dashboard_client import DashboardClient
from rtde_control import RTDEControlInterface
from rtde_receive import RTDEReceiveInterface

import rotations
from exported_plan import ExportedPlan, ToolState
from failures import ConnectionLost, InputError
from guards import Measurement, require_command, require_later
from impedance import Impedance
from kinematics import Pose
from settings import Settings, require_between

FREQUENCY = 500.0
# What is heard of the robot: no more than is needed, 500 times per second.
HEARD = ["timestamp", "actual_q", "actual_qd", "actual_TCP_pose", "actual_TCP_force", "robot_status_bits", "safety_status_bits"]
# The control script of ur-rtde 1.6.5 knows joint torques from this version of PolyScope on.
TORQUE_VERSION = (5, 26)
# The robot stops by itself when it hears less often from the player (Hz).
WATCHDOG = 10.0
# Longest wait (s) for a new measurement.
PATIENCE = 0.1
# Deceleration of joints at the end (rad/s^2).
STOPPING = 2.0
# Fastest motion in force mode (m/s, rad/s).
FORCE_MODE_SPEEDS = [0.25] * 3 + [1.0] * 3
# The base of the controller may be turned by half a turn about z against the root of the URDF file.
HALF_TURN = np.diag([-1.0, -1.0, 1.0])
# Largest part by which the robot's Jacobian may differ from that of the URDF file.
SAME_JACOBIAN = 0.05
# The package may return what its registers held before.
JACOBIAN_TRIES = 5
# Bits of the safety status in which a robot does not move.
SAFETY_STOPS = {
    2: "protective stop",
    3: "recovery mode",
    4: "safeguard stop",
    5: "emergency stop of the system",
    6: "emergency stop of the robot",
    7: "emergency stop",
    8: "violation of a safety limit",
    9: "fault of the safety system",
}
ALL_AXES, FRAME_AS_GIVEN = [1] * 6, 2
# Connections live until the program exits: to delete one to a robot that does not answer would never return.
connections: list["Connection"] = []


class Connection:
    """What all modes share: measurements, the control period, the end."""

    def __init__(self, host: str, plan: ExportedPlan) -> None:
        self.plan, self.arm = plan, plan.arm
        self.receive = RTDEReceiveInterface(host, FREQUENCY, HEARD)
        self.control = RTDEControlInterface(host, FREQUENCY)
        self.period = self.control.initPeriod()
        self.time, self.root, self.is_lost = -1.0, None, False
        connections.append(self)

    def read(self) -> Measurement:
        """Waits for the end of the control period and measures."""
        self.control.waitPeriod(self.period)
        self.period = self.control.initPeriod()
        self.wait_for_news()
        self.require_running()
        receive = self.receive
        positions, speeds = np.array(receive.getActualQ()), np.array(receive.getActualQd())
        expected, self.jacobian = self.arm.pose_and_jacobian(positions)
        tool = self.in_root(receive.getActualTCPPose(), expected)
        twist = self.jacobian @ speeds
        wrench = np.array(receive.getActualTCPForce())
        return Measurement(self.time, positions, speeds, ToolState(tool, twist[:3], twist[3:]), wrench[:3], wrench[3:])

    def in_root(self, numbers: list[float], expected: Pose) -> Pose:
        """A pose of the controller (position, rotation vector) in the root frame of the URDF file. How the two are turned is
        seen at the first pose."""
        pose = Pose(np.array(numbers[:3]), rotations.of_vector(np.array(numbers[3:])))
        if self.root is None:
            turned = Pose(HALF_TURN @ pose.position, HALF_TURN @ pose.rotation)
            is_turned = sum(turned.errors(expected)) < sum(pose.errors(expected))
            self.root = HALF_TURN if is_turned else np.eye(3)
        return Pose(self.root @ pose.position, self.root @ pose.rotation)

    def to_controller(self, vectors: np.ndarray) -> np.ndarray:
        """Force and torque, or the rows of a Jacobian, along the axes of the controller's base."""
        return np.concatenate([self.root.T @ vectors[:3], self.root.T @ vectors[3:]])

    def wait_for_news(self) -> None:
        """Until the robot has measured again."""
        deadline = time.monotonic() + PATIENCE
        while (now := self.receive.getTimestamp()) == self.time:
            if time.monotonic() > deadline:
                self.is_lost = True
                raise ConnectionLost(f"the robot has sent nothing for {PATIENCE:g} s; its watchdog stops it")
            time.sleep(1e-4)
        require_later(now, self.time)
        self.time = now

    def require_running(self) -> None:
        """The robot obeys."""
        if not (self.control.isConnected() and self.receive.isConnected()):
            self.is_lost = True
            raise ConnectionLost("the connection to the robot is lost; its watchdog stops it")
        for bit, name in SAFETY_STOPS.items():
            if self.receive.getSafetyStatusBits() >> bit & 1:
                raise ConnectionLost(f"the robot has stopped by itself: {name}")
        if not self.control.isProgramRunning():
            raise ConnectionLost("the control script does not run on the robot any more")

    def begin(self, hold: ToolState) -> None:
        """Compares the kinematics, and lets the robot stop by itself if the player falls silent."""
        expected = self.to_controller(self.jacobian)
        for _ in range(JACOBIAN_TRIES):
            # It comes column by column.
            own = np.array(self.control.getJacobian()).reshape(6, 6).T
            difference = float(np.abs(own - expected).max())
            if difference <= SAME_JACOBIAN:
                break
        else:
            raise InputError(
                f"the Jacobian of the robot differs by {difference:.2g} from that of the URDF file: tool point or base of the "
                "robot are not those of the scene"
            )
        if not self.control.setWatchdog(WATCHDOG):
            raise ConnectionLost("the robot does not take a watchdog, which stops it when the player falls silent")

    def end(self) -> None:
        """Stops the joints. A command to a robot that does not answer would never return."""
        if not self.is_lost:
            self.control.stopJ(STOPPING)

    def close(self) -> None:
        """Ends the script and the connection."""
        if self.is_lost:
            return
        self.control.stopScript()
        self.control.disconnect()
        self.receive.disconnect()

    def send(self, is_accepted: bool) -> None:
        """Checks that the robot took a command."""
        if not is_accepted:
            raise ConnectionLost("the robot does not take commands any more")
        self.control.kickWatchdog()


class TorqueRobot(Connection):
    """The impedance law of the plan as joint torques, 500 times per second. The robot carries its own weight."""

    def __init__(self, host: str, plan: ExportedPlan, impedance: Impedance) -> None:
        super().__init__(host, plan)
        self.impedance = impedance

    def track(self, reference: ToolState, measured: Measurement) -> None:
        """Torques J' wrench, within the limits of the joints."""
        torques = self.jacobian.T @ self.impedance.wrench(reference, measured.tool)
        limited = np.clip(torques, -self.arm.torque, self.arm.torque)
        require_command("torque", limited)
        self.send(self.control.directTorque(limited.tolist()))


class ForceRobot(Connection):
    """The impedance law of the plan as the wrench of force mode: how the robot moves under it is its own affair. The force mode
    for which a plan was made damps the measured velocity itself, with the damping of the law."""

    def __init__(self, host: str, plan: ExportedPlan, impedance: Impedance, gain: float, damping: float) -> None:
        super().__init__(host, plan)
        self.impedance, self.gain, self.damping = impedance, gain, damping
        self.damps_itself = is_planned_for_force(plan)

    def begin(self, hold: ToolState) -> None:
        """Also zeroes the sensor and sets the robot's own gains."""
        super().begin(hold)
        for accepted in (
            self.control.zeroFtSensor(),
            self.control.forceModeSetGainScaling(self.gain),
            self.control.forceModeSetDamping(self.damping),
        ):
            self.send(accepted)

    def track(self, reference: ToolState, measured: Measurement) -> None:
        """The wrench at the tool point."""
        frame = [*(self.root.T @ measured.tool.pose.position).tolist(), 0.0, 0.0, 0.0]
        tool = ToolState.at_rest(measured.tool.pose) if self.damps_itself else measured.tool
        wrench = self.to_controller(self.impedance.wrench(reference, tool))
        require_command("wrench", wrench)
        self.send(self.control.forceMode(frame, ALL_AXES, wrench.tolist(), FRAME_AS_GIVEN, FORCE_MODE_SPEEDS))

    def end(self) -> None:
        """Leaves force mode before all else."""
        try:
            if not self.is_lost:
                self.control.forceModeStop()
        finally:
            super().end()


def connect(arguments: argparse.Namespace, plan: ExportedPlan, _: Settings) -> Connection:
    """The robot in the mode that is asked for, or that it can."""
    require_between(arguments, "force_mode_gain", 2.0)
    require_between(arguments, "force_mode_damping", 1.0)
    impedance = Impedance(plan, arguments.stiffness_factor, arguments.damping_factor)
    try:
        version = polyscope_version(arguments.host)
        can_torque = version >= TORQUE_VERSION
        if arguments.mode == "torque" and not can_torque:
            newest = ".".join(map(str, TORQUE_VERSION))
            raise InputError(f"PolyScope {'.'.join(map(str, version))} takes no joint torques: {newest} does; use --mode force")
        if is_planned_for_force(plan) and arguments.damping_factor != 1.0:
            raise InputError("the plan was made for force mode, which has a damping of its own: leave --damping-factor out")
        if arguments.mode == "torque" and is_planned_for_force(plan):
            raise InputError("the plan was made for force mode: use --mode force, or plan with robot.interface = \"torque\"")
        if arguments.mode == "force" or not can_torque or is_planned_for_force(plan):
            return ForceRobot(arguments.host, plan, impedance, arguments.force_mode_gain, arguments.force_mode_damping)
        return TorqueRobot(arguments.host, plan, impedance)
    except RuntimeError as error:
        raise InputError(f"{arguments.host}: the robot cannot be reached ({error}); is it on, and in remote control?") from error


def is_planned_for_force(plan: ExportedPlan) -> bool:
    """Whether the plan was made for force mode."""
    return plan.document.get("admittance") is not None


def polyscope_version(host: str) -> tuple[int, ...]:
    """Major and minor version of the robot's software."""
    dashboard = DashboardClient(host)
    dashboard.connect()
    try:
        text = dashboard.polyscopeVersion()
    finally:
        dashboard.disconnect()
    words = [word for word in text.replace("URSoftware", " ").split() if word[:1].isdigit()]
    if not words:
        raise InputError(f"{host}: the robot does not say its version: {text!r}")
    return tuple(int(number) for number in words[0].split(".")[:2])
