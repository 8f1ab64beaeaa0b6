"""A stand-in of a robot that is commanded by position and takes corrections over UDP: the part on a stiff spring at its
flange, in MuJoCo. It sends its state, waits for the answer, and moves for a cycle. Without answers it stops."""

import json
import os
import pathlib
import socket
import sys
import time
import tomllib

import mujoco
import numpy as np

from lab.mujoco.control import GraspError
from lab.paths import SCENES
from lab.players.commanded_part import commanded_part

PORT = 49152
TIME_STEP = 0.0005
# Time (s) within which a player has to begin, its longest wait for an answer, and the cycles without one after which it
# stops.
FIRST_WAIT, FIRST_CYCLE, WAIT, MOST_SILENT = 30.0, 0.02, 2.0, 10
# Of the sensor (Hz).
CUTOFF = 50.0


class Server:
    """Cycles of the robot."""

    def __init__(self, task: dict, address: str) -> None:
        self.task, self.fault = task, task.get("fault", {"kind": "", "time": np.inf})
        document = json.loads((pathlib.Path(task["plan"]) / "plan.json").read_text())
        self.goal, record = np.array(document["goal"]), document["admittance"]
        self.period = record["period_s"]
        scene = tomllib.loads((SCENES / f"{document['scene']}.toml").read_text())
        rows = (pathlib.Path(task["plan"]) / "trajectory.csv").read_text().splitlines()
        start = np.array([float(number) for number in rows[1].split(",")[1:8]])
        # A little beside the start: the player goes there first.
        start[2] += task.get("displaced", 0.0)
        grasp_error = GraspError(np.array(task["offset"]), np.array(task.get("turn", (0.0,) * 3)))
        self.part = commanded_part(scene, document, start, grasp_error, TIME_STEP, CUTOFF)
        self.endpoint = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        self.endpoint.bind((address, 0))
        self.player = (address, PORT)
        self.begun = time.monotonic()
        self.time, self.sequence, self.silent, self.answers = 0.0, 0, 0, 0

    def run(self) -> None:
        """Until the player says stop or falls silent."""
        while self.silent < MOST_SILENT:
            self.send()
            answer = self.receive()
            if answer and answer["stop"]:
                break
            self.move()
        self.leave()

    def has(self, kind: str) -> bool:
        """Whether a fault has come."""
        return self.fault["kind"] == kind and self.time >= self.fault["time"]

    def send(self) -> None:
        """What the robot says of itself."""
        position, rotation = self.part.tool()
        quaternion = np.zeros(4)
        mujoco.mju_mat2Quat(quaternion, rotation.flatten())
        force, torque = (part.copy() for part in self.part.wrench)
        if self.has("force"):
            force += [0.0, 0.0, 300.0]
        if self.has("nan"):
            force[0] = np.nan
        self.sequence += 0 if self.has("repeated") else 1
        said = {
            "sequence": self.sequence,
            "time_s": self.time * (2.0 if self.has("clock") else 1.0),
            "position_m": position.tolist(),
            "quaternion": quaternion.tolist(),
            "force_n": force.tolist(),
            "torque_nm": torque.tolist(),
        }
        if self.has("silent"):
            return
        content = json.dumps(said).encode()
        self.endpoint.sendto(content[: len(content) // 2] if self.has("cut") else content, self.player)

    def receive(self) -> dict | None:
        """The player's answer. Before the first one, the robot rests and its time goes on."""
        self.endpoint.settimeout(WAIT if self.answers else FIRST_CYCLE)
        try:
            answer = json.loads(self.endpoint.recv(65535))
        except (TimeoutError, ConnectionRefusedError):
            is_late = time.monotonic() > self.begun + FIRST_WAIT
            self.silent += 1 if self.answers or is_late else 0
            return None
        self.silent, self.answers = 0, self.answers + 1
        position, quaternion = np.array(answer["position_m"]), np.array(answer["quaternion"])
        assert np.isfinite(position).all() and abs(np.linalg.norm(quaternion) - 1) < 1e-6, "a command is no pose"
        self.part.go_to(position, quaternion)
        return answer

    def move(self) -> None:
        """One cycle."""
        for step in range(1, round(self.period / TIME_STEP) + 1):
            self.part.advance(step, [0.0] * 13)
        self.time += self.period

    def leave(self) -> None:
        """Writes what has become of the part."""
        state = np.array(self.part.state())
        cosine = min(1.0, abs(float(state[3:7] @ self.goal[3:])))
        outcome = {
            "position_error_m": float(np.linalg.norm(state[:3] - self.goal[:3])),
            "angle_error_rad": 2 * float(np.arccos(cosine)),
            "mode": "position",
            "time_s": self.time,
            "commands": self.answers,
            "torque_step_nm_per_ms": 0.0,
            "obstacle_force_n": 0.0,
        }
        pathlib.Path(self.task["outcome"]).write_text(json.dumps(outcome))


if __name__ == "__main__":
    Server(json.loads(os.environ["SIMULATION"]), sys.argv[1]).run()
