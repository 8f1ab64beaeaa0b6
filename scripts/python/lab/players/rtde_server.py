"""A simulated robot of Universal Robots behind its sockets, as far as the client of ur-rtde needs them:
`python -m lab.players.rtde_server ADDRESS`.

Dashboard (29999), scripts (30003, which are received and not run) and RTDE (30004, version 2). Commands of the control
script come in registers: `input_int_register_0` names one, `output_int_register_0` says that it is done (2) or that the
next may come (1). The robot's time begins with the control script. While torques come, a period of it passes with each
of them: a slow computer makes a slow robot and not a failure, and faults come where they are meant to. The state is
sent every two milliseconds, whether it is new or not."""

import functools
import re
import socket
import struct
import sys
import threading
import time
from collections.abc import Callable
from typing import Any

import numpy as np

import rotations
from lab.players.simulated_robot import PERIOD, SimulatedRobot

DASHBOARD, SCRIPT, RTDE = 29999, 30003, 30004
VERSION = (5, 26, 0, 1)
# Types of variables by their names, and how they are packed.
TYPES = [
    (r"output_int_register_\d+|input_int_register_\d+|robot_mode|safety_mode", "INT32", "i"),
    (r"robot_status_bits|safety_status_bits|runtime_state", "UINT32", "I"),
    (r"actual_digital_(in|out)put_bits", "UINT64", "Q"),
    (r"joint_mode", "VECTOR6INT32", "6i"),
    (r"payload_cog|actual_tool_accelerometer", "VECTOR3D", "3d"),
    (r".*mask|.*digital_output|standard_analog_output_type", "UINT8", "B"),
    (
        r".*double_register_\d+|timestamp|actual_execution_time|speed_scaling|target_speed_fraction|speed_slider_fraction|"
        r"actual_momentum|actual_main_voltage|actual_robot_(voltage|current)|standard_analog_\w+|payload",
        "DOUBLE",
        "d",
    ),
    (r".*", "VECTOR6D", "6d"),
]
READY, DONE = 1, 2
STOPPED, PLAYING = 1, 2
# Numbers of commands in the control script of ur-rtde 1.6.5.
FORCE_MODE, FORCE_MODE_STOP, STOP_JOINTS, DIRECT_TORQUE, JACOBIAN, STOP_SCRIPT = 6, 7, 34, 66, 70, 255
# After this time (s) without torques, the robot is back in position control.
SILENCE = 0.25


class Server:
    """The sockets and the robot behind them."""

    def __init__(self, address: str) -> None:
        self.address, self.robot = address, SimulatedRobot()
        self.tick, self.periods = threading.Condition(), 0
        self.registers: dict[str, int | float] = {
            "output_int_register_0": READY,
            "runtime_state": STOPPED,
            "robot_status_bits": 1,
        }
        self.last_torque = -SILENCE

    def run(self) -> None:
        """Serves until the process is ended."""
        for port, serve in ((DASHBOARD, self.serve_dashboard), (SCRIPT, self.receive_script), (RTDE, self.serve_rtde)):
            threading.Thread(target=self.accept, args=(port, serve), daemon=True).start()
        while True:
            time.sleep(PERIOD)
            with self.tick:
                is_silent = time.monotonic() - self.last_torque > SILENCE
                if self.registers["runtime_state"] == PLAYING and (self.robot.torques is not None or is_silent):
                    self.robot.wait()
                self.periods += 1
                self.tick.notify_all()

    def accept(self, port: int, serve: Callable[[socket.socket], None]) -> None:
        """A thread for every connection."""
        with socket.create_server((self.address, port)) as listening:
            while True:
                connection, _ = listening.accept()
                connection.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
                threading.Thread(target=self.guarded, args=(serve, connection), daemon=True).start()

    def guarded(self, serve: Callable[[socket.socket], None], connection: socket.socket) -> None:
        """The client may go whenever it wants."""
        try:
            with connection:
                serve(connection)
        except OSError:
            pass

    def serve_dashboard(self, connection: socket.socket) -> None:
        """Answers in lines."""
        answers = {
            "PolyscopeVersion": "URSoftware 5.26.0.1 (Jun 01 2026)",
            "get serial number": "20265500001",
            "is in remote control": "true",
        }
        connection.sendall(b"Connected: Universal Robots Dashboard Server\n")
        for line in connection.makefile("r"):
            connection.sendall((answers.get(line.strip(), "unknown") + "\n").encode())

    def receive_script(self, connection: socket.socket) -> None:
        """The control script is not run: its commands are simulated."""
        while connection.recv(1 << 16):
            self.registers |= {"runtime_state": PLAYING, "robot_status_bits": 3}

    def serve_rtde(self, connection: socket.socket) -> None:
        """Packages of size, type and content."""
        inputs: list[list[str]] = []
        try:
            self.serve_packages(connection, inputs)
        finally:
            # The watchdog stops a robot that is not heard of.
            if inputs:
                with self.tick:
                    self.leave_mode(STOP_SCRIPT)

    def serve_packages(self, connection: socket.socket, inputs: list[list[str]]) -> None:
        """Answers until the client has gone; collects what it sends."""
        outputs: list[str] = []
        while True:
            size, kind = struct.unpack(">Hc", receive(connection, 3))
            content = receive(connection, size - 3)
            if kind in b"VP":
                send(connection, kind, b"\x01")
            elif kind == b"v":
                send(connection, kind, struct.pack(">4I", *VERSION))
            elif kind == b"O":
                outputs = names_of(content[8:])
                send(connection, kind, b"\x01" + types_of(outputs))
            elif kind == b"I":
                inputs.append(names_of(content))
                send(connection, kind, bytes([len(inputs)]) + types_of(inputs[-1]))
            elif kind == b"S":
                send(connection, kind, b"\x01")
                threading.Thread(target=self.guarded, args=(self.stream_of(outputs), connection), daemon=True).start()
            elif kind == b"U":
                self.take(inputs[content[0] - 1], content[1:])

    def stream_of(self, names: list[str]) -> Callable[[socket.socket], None]:
        """Sends the state after every period."""

        def stream(connection: socket.socket) -> None:
            sent = 0
            while True:
                with self.tick:
                    while self.periods == sent:
                        self.tick.wait()
                    arm, sent = self.robot.arm, self.periods
                    if arm.fails("hang"):
                        continue
                    if arm.fails("disconnect"):
                        connection.shutdown(socket.SHUT_RDWR)
                        return
                    values = package.pack(*(number for name in names for number in self.numbers(name)))
                send(connection, b"U", b"\x01" + values)

        package = struct.Struct(">" + "".join(format_of(name) for name in names))
        return stream

    def numbers(self, name: str) -> list[float]:
        """What the robot says of itself: registers, measurements, else zeros."""
        arm = self.robot.arm
        measured: dict[str, Callable[[], Any]] = {
            "timestamp": lambda: [arm.time],
            "actual_q": lambda: arm.said().positions,
            "actual_qd": lambda: arm.said().speeds,
            "actual_TCP_pose": self.pose,
            "actual_TCP_force": lambda: arm.said().wrench,
            "safety_status_bits": lambda: [4 if arm.fails("protective") else 1],
        }
        if name in measured:
            return measured[name]()
        if name in self.registers:
            return [self.registers[name]]
        code = format_of(name)
        return [0] * int(code[:-1] or 1)

    def pose(self) -> list[float]:
        """Position and rotation vector of the tool."""
        position, rotation, _ = self.robot.tool()
        return [*position, *rotations.vector(rotation)]

    def take(self, names: list[str], content: bytes) -> None:
        """A command: those that come at the control rate leave the state `ready`."""
        values = dict(zip(names, struct.unpack(">" + "".join(format_of(name) for name in names), content)))
        command = values.get("input_int_register_0")
        doubles = [value for name, value in values.items() if "double" in name]
        with self.tick:
            if command in (DIRECT_TORQUE, FORCE_MODE):
                self.apply(command, doubles)
                return
            if command == JACOBIAN:
                jacobian = self.robot.tool()[2].flatten(order="F")
                numbers = [*range(24), *range(36, 48)]
                self.registers |= {f"output_double_register_{number}": v for number, v in zip(numbers, jacobian)}
                return
            self.registers["output_int_register_0"] = DONE if command else READY
            if command in (FORCE_MODE_STOP, STOP_JOINTS, STOP_SCRIPT):
                self.leave_mode(command)

    def apply(self, command: int, doubles: list[float]) -> None:
        """Torques, or the wrench of force mode, for a period."""
        if command == DIRECT_TORQUE:
            self.robot.command("torque", np.array(doubles[:6]))
        else:
            self.robot.command("force", self.robot.tool()[2].T @ np.array(doubles[6:12]))
        self.last_torque = time.monotonic()

    def leave_mode(self, command: int) -> None:
        """Position control holds the arm."""
        self.robot.arm.mode, self.robot.torques, self.last_torque = "position", None, -SILENCE
        if command == STOP_SCRIPT:
            self.registers |= {"runtime_state": STOPPED, "robot_status_bits": 1}
            self.robot.arm.leave()


def receive(connection: socket.socket, size: int) -> bytes:
    """So many bytes; OSError at the end of the stream."""
    content = b""
    while len(content) < size:
        more = connection.recv(size - len(content))
        if not more:
            raise ConnectionResetError
        content += more
    return content


def send(connection: socket.socket, kind: bytes, content: bytes) -> None:
    """A package."""
    connection.sendall(struct.pack(">Hc", 3 + len(content), kind) + content)


def names_of(content: bytes) -> list[str]:
    """Names that are separated by commas."""
    return [name for name in content.decode().split(",") if name]


def types_of(names: list[str]) -> bytes:
    """Their types."""
    return ",".join(next(kind for pattern, kind, _ in TYPES if re.fullmatch(pattern, name)) for name in names).encode()


@functools.cache
def format_of(name: str) -> str:
    """How a variable is packed."""
    return next(code for pattern, _, code in TYPES if re.fullmatch(pattern, name))


if __name__ == "__main__":
    Server(sys.argv[1]).run()
