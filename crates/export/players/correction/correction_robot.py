"""A robot that sends its pose and wrench in every cycle of its controller and takes a position correction, over UDP."""

import argparse
import json
import math
import socket
from typing import Any

import numpy as np

import rotations
from admittance import Admittance
from exported_plan import ExportedPlan, ToolState
from failures import ConnectionLost, InputError
from guards import Measurement, require_command
from kinematics import Pose
from settings import Settings, position_law, require_between

# Longest wait (s) for the first datagram, and most that may be allowed for the next one: the robot stops by itself without answers.
FIRST_PATIENCE, MOST_SILENCE = 10.0, 10.0
# The robot's cycle is the period of the law, but for this part of it.
SAME_PERIOD = 0.2
LARGEST_DATAGRAM = 65535
FIELDS = {"sequence": 1, "time_s": 1, "position_m": 3, "quaternion": 4, "force_n": 3, "torque_nm": 3}


class CorrectionRobot:
    """Answers every datagram of the robot with the pose that the law commands, as a correction of the pose at the beginning."""

    def __init__(self, endpoint: socket.socket, plan: ExportedPlan, factors: tuple[float, float], silence: float) -> None:
        self.endpoint, self.plan, self.factors, self.silence = endpoint, plan, factors, silence
        self.period = plan.document["admittance"]["period_s"]
        self.robot: tuple[str, int] | None = None
        self.sequence, self.time, self.pose = -1, -math.inf, None
        self.law: Admittance | None = None
        self.home: Pose | None = None
        # The last command, and the datagram that it answered.
        self.commanded: Pose | None = None
        self.answered = -1

    def read(self) -> Measurement:
        """Waits for the next datagram of the robot. One that asked for no sample of the law is answered with the last command."""
        if self.commanded is not None and self.answered < self.sequence:
            self.answer(self.commanded)
        said = self.receive()
        pose = Pose(np.array(said["position_m"]), rotations.matrix(np.array(said["quaternion"])))
        elapsed = said["time_s"] - self.time
        velocity, angular_velocity = np.zeros(3), np.zeros(3)
        if self.pose is not None:
            self.require_cycle(elapsed)
            velocity = (pose.position - self.pose.position) / elapsed
            angular_velocity = rotations.vector(pose.rotation @ self.pose.rotation.T) / elapsed
        self.time, self.pose = said["time_s"], pose
        joints = np.array(said.get("joints", []), dtype=float)
        speeds = np.array(said.get("joint_speeds", []), dtype=float)
        tool = ToolState(pose, velocity, angular_velocity)
        return Measurement(said["time_s"], joints, speeds, tool, np.array(said["force_n"]), np.array(said["torque_nm"]))

    def receive(self) -> dict[str, Any]:
        """The next datagram, whole and newer than the one before."""
        self.endpoint.settimeout(FIRST_PATIENCE if self.robot is None else self.silence)
        try:
            content, sender = self.endpoint.recvfrom(LARGEST_DATAGRAM)
        except TimeoutError as error:
            if self.robot is None:
                raise InputError(f"no datagram comes from the robot within {FIRST_PATIENCE:g} s") from error
            raise ConnectionLost(f"the robot has sent nothing for {self.silence:g} s; it stops without answers") from error
        if self.robot not in (None, sender):
            raise ConnectionLost(f"datagrams come from {sender[0]}:{sender[1]}, too")
        said = parsed(content)
        if said["sequence"] <= self.sequence:
            raise ConnectionLost(f"datagram {said['sequence']} came after {self.sequence}")
        self.robot, self.sequence = sender, said["sequence"]
        return said

    def require_cycle(self, elapsed: float) -> None:
        """The robot's cycle is that of the plan: gains are stable for this one."""
        if not abs(elapsed / self.period - 1) <= SAME_PERIOD:
            raise ConnectionLost(
                f"the robot's cycle took {1e3 * elapsed:.1f} ms, and the law was chosen for {1e3 * self.period:.1f} ms: state "
                "robot.control_period of the scene, and plan again"
            )

    def begin(self, hold: ToolState) -> None:
        """The law starts at the pose that is held; corrections are relative to it."""
        self.home = hold.pose
        self.law = Admittance(self.plan, hold.pose, *self.factors)
        self.answer(hold.pose)

    def track(self, reference: ToolState, measured: Measurement) -> None:
        """One sample of the law."""
        self.answer(self.law.step(reference.pose, measured.tool.pose, measured.force, measured.torque))

    def answer(self, pose: Pose, stop: bool = False) -> None:
        """Sends a commanded pose."""
        shift = pose.position - self.home.position
        turn = rotations.vector(pose.rotation @ self.home.rotation.T)
        quaternion = rotations.quaternion(pose.rotation, None)
        require_command("pose", [*pose.position, *quaternion, *shift, *turn])
        answer = {
            "sequence": self.sequence,
            "position_m": pose.position.tolist(),
            "quaternion": quaternion.tolist(),
            "correction_m": shift.tolist(),
            "correction_rad": turn.tolist(),
            "stop": stop,
        }
        self.commanded, self.answered = pose, self.sequence
        self.endpoint.sendto(json.dumps(answer).encode(), self.robot)

    def end(self) -> None:
        """The robot stays where it is."""
        if self.pose is not None:
            self.answer(self.pose, stop=True)

    def close(self) -> None:
        """Leaves the port."""
        self.endpoint.close()


def parsed(content: bytes) -> dict[str, Any]:
    """A datagram of the robot, of which nothing is missing and everything is a number."""
    try:
        said = json.loads(content)
        for name, count in FIELDS.items():
            values = said[name] if count > 1 else [said[name]]
            if len(values) != count or not all(math.isfinite(float(value)) for value in values):
                raise ValueError(f"`{name}` is not {count} finite numbers")
        if not isinstance(said["sequence"], int):
            raise ValueError("`sequence` is not an integer")
    except (KeyError, TypeError, ValueError) as error:
        raise ConnectionLost(f"a datagram of the robot is not as README.md has it: {type(error).__name__} {error}") from error
    return said


def connect(arguments: argparse.Namespace, plan: ExportedPlan, _: Settings) -> CorrectionRobot:
    """The robot behind a port."""
    position_law(arguments, plan)
    if not 1 <= arguments.port <= 65535:
        raise InputError(f"--port {arguments.port} must lie between 1 and 65535")
    require_between(arguments, "longest_silence", MOST_SILENCE)
    endpoint = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
    try:
        endpoint.bind((arguments.address, arguments.port))
    except OSError as error:
        endpoint.close()
        raise InputError(f"{arguments.address}:{arguments.port}: {error}") from error
    return CorrectionRobot(endpoint, plan, (arguments.stiffness_factor, arguments.damping_factor), arguments.longest_silence)
