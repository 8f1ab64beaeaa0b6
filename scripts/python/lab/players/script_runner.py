"""Runs what `plan.script` uses of URScript, translated line by line to Python, with the simulated robot behind its
functions. `python -m lab.players.script_runner FILE [RECEIVER]` exits with 0 when the script says that the plan is
played, and with 1 when it stops; RECEIVER is the address at which receive.py waits."""

import contextlib
import math
import pathlib
import re
import socket
import sys
from typing import Any

import numpy as np

import rotations
from lab.players import faults
from lab.players.force_mode import ForceModeArm, is_planned_for_force
from lab.players.simulated_arm import SimulatedArm, Task

STEP_TIME = 0.002
# Longest string of URScript.
LONGEST_STRING = 1023


class Halted(Exception):
    """The script has ended itself."""


class Matrix(list):
    """Rows that are read as `m[row, column]` too."""

    def __getitem__(self, index: Any) -> Any:
        return list.__getitem__(self, index[0])[index[1]] if isinstance(index, tuple) else list.__getitem__(self, index)


def translated(script: str) -> str:
    """The same in Python: blocks have no `end`, threads are functions, poses are lists, and all variables are
    global."""
    script = re.sub(r"\bp\[", "[", script)
    script = re.sub(
        r"= \[\n(.*?)\n  \]", lambda rows: "= Matrix([" + rows[1].replace("\n", "") + "])", script, flags=re.DOTALL
    )
    lines, globals_ = [], sorted(set(re.findall(r"global (\w+)", script)))
    for line in script.splitlines():
        text = line.strip()
        if text == "end":
            continue
        text = (
            re.sub(r"^global ", "", text).replace("thread ", "def ", 1)
            if text.startswith(("global", "thread"))
            else text
        )
        text = re.sub(r"^join (\w+)", r"join(\1)", text)
        text = re.sub(r"run (\w+)\(\)", r"run(\1)", text)
        text = "halt()" if text == "halt" else text
        indent = line[: len(line) - len(line.lstrip())]
        lines.append(indent + text)
        if text.startswith("def "):
            lines.append(f"{indent}  global {', '.join(globals_)}")
    return "\n".join(lines) + "\nassembly_plan()\n"


def isometry(pose: list[float]) -> tuple[np.ndarray, np.ndarray]:
    """Position and rotation matrix of a pose with a rotation vector."""
    return np.array(pose[:3]), rotations.of_vector(np.array(pose[3:]))


def pose_of(position: np.ndarray, rotation: np.ndarray) -> list[float]:
    """The pose of the script."""
    return [*position.tolist(), *rotations.vector(rotation).tolist()]


class Controller:
    """The functions of URScript that the script calls, on a simulated arm."""

    def __init__(self, task: Task) -> None:
        self.force_mode_arm = ForceModeArm(task) if is_planned_for_force(task) else None
        self.arm: SimulatedArm = self.force_mode_arm or SimulatedArm(task)
        self.base = np.diag([-1.0, -1.0, 1.0]) if task.base_is_turned else np.eye(3)
        self.thread: Any = None
        self.variables: dict[str, Any] = {}
        self.sockets: dict[str, socket.socket] = {}
        self.is_played = False
        # The mode that the thread has set, and whether it is at work.
        self.mode, self.is_in_thread = "position", False

    def functions(self) -> dict[str, Any]:
        """By their names."""
        named = {name: getattr(self, name) for name in dir(Controller) if name.startswith("get_")}
        own = ("pose_trans", "pose_inv", "zero_ftsensor", "sync", "run", "join", "halt")
        named |= {name: getattr(self, name) for name in (*own, "textmsg", "popup", "direct_torque", "stopj")}
        force_mode = ("force_mode", "end_force_mode", "force_mode_set_gain_scaling", "force_mode_set_damping")
        named |= {name: getattr(self, name) for name in force_mode}
        named |= {name: getattr(self, name) for name in ("socket_open", "socket_send_line", "str_cat", "to_str")}
        return named | {"sqrt": math.sqrt, "norm": abs, "floor": math.floor, "Matrix": Matrix}

    def tool(self) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        said, jacobian = self.arm.said(), self.arm.tool()[2]
        position, rotation = said.pose, said.rotation
        return (
            self.base @ position,
            self.base @ rotation,
            np.vstack([self.base @ jacobian[:3], self.base @ jacobian[3:]]),
        )

    def get_actual_tcp_pose(self) -> list[float]:
        return pose_of(*self.tool()[:2])

    def get_actual_tcp_speed(self) -> list[float]:
        return (self.tool()[2] @ self.arm.said().speeds).tolist()

    def get_tcp_force(self) -> list[float]:
        return self.arm.said().wrench.tolist()

    def get_actual_joint_positions(self) -> list[float]:
        return self.arm.said().positions.tolist()

    def get_actual_joint_speeds(self) -> list[float]:
        return self.arm.said().speeds.tolist()

    def get_jacobian(self) -> Matrix:
        return Matrix(self.tool()[2].tolist())

    def get_steptime(self) -> float:
        return STEP_TIME

    def get_forward_kin(self, positions: list[float]) -> list[float]:
        """Where the controller has its tool point: a wrong tool point is wrong here too."""
        arm = self.arm
        before = arm.data.qpos.copy()
        arm.data.qpos[:] = positions
        position, rotation, _ = arm.tool()
        arm.data.qpos[:] = before
        said = arm.spoiled(faults.Said(arm.time, np.array(positions), np.zeros(6), position, rotation, np.zeros(6)))
        return pose_of(self.base @ said.pose, self.base @ said.rotation)

    def pose_trans(self, first: list[float], second: list[float]) -> list[float]:
        (position, rotation), (further, turned) = isometry(first), isometry(second)
        return pose_of(position + rotation @ further, rotation @ turned)

    def pose_inv(self, pose: list[float]) -> list[float]:
        position, rotation = isometry(pose)
        return pose_of(-rotation.T @ position, rotation.T)

    def zero_ftsensor(self) -> None:
        pass

    def run(self, thread: Any) -> Any:
        self.thread = thread
        return thread

    def sync(self) -> None:
        """Lets the thread send its command once: it would go on for ever."""
        if self.is_in_thread:
            return
        tracking = self.variables["is_tracking"]
        self.variables["is_tracking"], self.is_in_thread = _Once(), True
        try:
            self.thread()
        finally:
            self.variables["is_tracking"], self.is_in_thread = tracking, False
            self.arm.mode = self.mode

    def direct_torque(self, torque: list[float], viscous_scale: list[float], coulomb_scale: list[float]) -> None:
        self.mode = "torque"
        self.arm.obey(np.array(torque))
        self.arm.apply(np.array(torque), STEP_TIME)

    def force_mode(
        self, frame: list[float], selection: list[int], wrench: list[float], kind: int, limits: list[float]
    ) -> None:
        """All axes comply, and the frame is taken as it is: at the tool, along the axes of the controller's base."""
        assert self.force_mode_arm is not None, "the plan is not for force mode"
        assert np.allclose(frame[:3], self.tool()[0], atol=1e-3) or self.arm.task.fault.kind, "frame beside the tool"
        assert frame[3:] == [0.0] * 3 and selection == [1] * 6 and kind == 2 and min(limits) > 0
        self.mode = "force"
        self.arm.obey(np.array([*frame, *wrench]))
        along = np.concatenate([self.base.T @ np.array(wrench[:3]), self.base.T @ np.array(wrench[3:])])
        self.force_mode_arm.comply(along, np.array(limits), STEP_TIME)

    def end_force_mode(self) -> None:
        self.arm.mode = "stopping"

    def force_mode_set_gain_scaling(self, scaling: float) -> None:
        assert 0 <= scaling <= 2

    def force_mode_set_damping(self, damping: float) -> None:
        assert 0 <= damping <= 1

    def stopj(self, deceleration: float) -> None:
        """Force mode goes on until it is ended."""
        if self.arm.mode != "force":
            self.arm.mode = "position"

    def join(self, thread: Any) -> None:
        thread()

    def halt(self) -> None:
        raise Halted

    def popup(self, text: str, error: bool, blocking: bool) -> None:
        print(text, file=sys.stderr)

    def socket_open(self, address: str, port: int, name: str) -> bool:
        try:
            self.sockets[name] = socket.create_connection((address, port), timeout=2.0)
        except OSError:
            return False
        return True

    def socket_send_line(self, text: str, name: str) -> bool:
        try:
            self.sockets[name].sendall(f"{text}\n".encode("ascii"))
        except OSError:
            return False
        return True

    def str_cat(self, first: str, second: str) -> str:
        # Longer strings stop a script.
        if len(first + second) > LONGEST_STRING:
            raise ValueError(f"a string of {len(first + second)} characters")
        return first + second

    def to_str(self, value: Any) -> str:
        """Numbers have at most six decimals."""
        if isinstance(value, list):
            return f"[{','.join(map(self.to_str, value))}]"
        return str(value) if isinstance(value, str) else f"{float(value):.6f}".rstrip("0").rstrip(".")

    def textmsg(self, text: str, values: Any = "") -> None:
        print(text, values, file=sys.stderr)
        self.is_played = self.is_played or text.startswith("the plan is played")


class _Once:
    """True for one look."""

    looks = 0

    def __bool__(self) -> bool:
        self.looks += 1
        return self.looks == 1


def main() -> int:
    """Runs the script of a file."""
    controller = Controller(Task.read())
    script = pathlib.Path(sys.argv[1]).read_text()
    if len(sys.argv) > 2:
        script = script.replace('global receiver = ""', f'global receiver = "{sys.argv[2]}"')
    code = compile(translated(script), sys.argv[1], "exec")
    controller.variables = controller.functions()
    with contextlib.suppress(Halted):
        exec(code, controller.variables)
    controller.arm.leave()
    return 0 if controller.is_played else 1


if __name__ == "__main__":
    sys.exit(main())
