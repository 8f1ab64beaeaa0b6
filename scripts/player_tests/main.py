"""Plays recorded plans with every player on a simulated arm, and lets every guard stop one: `main.py [NAME...]`."""

import concurrent.futures
import contextlib
import csv
import dataclasses
import importlib.util
import json
import os
import pathlib
import shutil
import signal
import socket
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator

import checks
from rtde_server import DASHBOARD

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[1]
PLAYERS = ROOT / "crates/export/players"
RECORDED = HERE / "recorded"
# Folder of the player, folder of its stand-ins.
TARGETS = {
    "ur-rtde": ("ur_rtde", "ur"),
    "loopback": ("ur_rtde", ""),
    "franka": ("franka", "franka"),
    "ros2": ("ros2", "ros2"),
    "urscript": ("urscript", ""),
}
# Longest time of a player (s).
PATIENCE = 60.0
# What the players say of success: distance (m) and angle (rad) to the goal.
POSITION_TOLERANCE, ANGLE_TOLERANCE = 0.003, 0.1


@dataclasses.dataclass(frozen=True)
class Case:
    """A plan that is played, what goes wrong, and what is expected: the exit code, words on standard error, whether the part
    ends at its goal."""

    name: str
    target: str
    plan: str
    code: int = 0
    says: str = ""
    inserts: bool = False
    flags: tuple[str, ...] = ("--skip-self-test",)
    simulation: dict = dataclasses.field(default_factory=dict)
    environment: dict = dataclasses.field(default_factory=dict)
    interrupted_at: str = ""
    has_packages: bool = True
    has_receiver: bool = True


def insertions() -> list[Case]:
    """Every plan with every player, each with a grasp error that was planned for and one between them."""
    offsets = {
        "corner": ((0.019, 0.0, 0.0), (0.008, 0.0, 0.01)),
        "clamp1": ((0.003, -0.003, 0.0), (0.0, 0.0035, 0.0)),
        "peg1": ((0.0, 0.0, 0.0), (0.008, -0.008, 0.0)),
    }
    return [
        Case(f"{target} {plan} {number}", target, plan, inserts=True, simulation={"offset": offset, "turn": (0.0, 0.005, 0.0)})
        for target in TARGETS
        for plan in offsets
        for number, offset in enumerate(offsets[plan], 1)
        # Behind sockets, a robot takes longer than its own time.
        if target != "loopback" or (plan, number) == ("clamp1", 1)
    ]


def guards() -> list[Case]:
    """Everything that has to stop a player, and what must not."""

    def fault(kind: str, at: float = 2.0) -> dict:
        return {"fault": {"kind": kind, "time": at}}

    cases = []
    for target in ("ur-rtde", "franka", "ros2"):
        add = lambda name, *rest, target=target, **more: cases.append(
            Case(f"{target} {name}", target, "corner", *rest, **more)
        )
        add("self-test and dry run", 0, "dry run: the tool ends", flags=("--dry-run", "0.05"))
        add("force", 1, "stopped: force of", simulation=fault("force"))
        # A robot of Universal Robots that does not answer stops by itself: behind sockets, below.
        for name in ("hang", "disconnect") if target != "ur-rtde" else ():
            add(name, 1, "stopped: ", simulation=fault(name))
        add("gap", 1, "stopped: ", simulation=fault("gap"))
        add("frame", 2, "tool point", simulation=fault("frame", 0.0))
        add("too far", 2, "move it there first", simulation={"displaced": 0.6})
        add("interrupt", 130, "interrupted", interrupted_at="testing the frames", flags=())
        add("without packages", 3, "pip install numpy", has_packages=False)
        add("wrong factor", 2, "--stiffness-factor", flags=("--stiffness-factor", "-1"))
        add("soft", 1, "the tool moved", flags=("--stiffness-factor", "0.001"))
        add("push", 1, "stopped: ", simulation=fault("push"))
        add("distance", 1, "from its reference", flags=("--skip-self-test", "--distance-limit", "0.001"))
        add("displaced", 0, "", inserts=True, simulation={"displaced": 0.01})
    for name in ("protective", "refuse"):
        cases.append(Case(f"ur-rtde {name}", "ur-rtde", "corner", 1, "stopped: ", simulation=fault(name)))
    for name in ("force", "hang", "disconnect", "protective"):
        cases.append(Case(f"loopback {name}", "loopback", "corner", 1, "stopped: ", simulation=fault(name)))
    cases += [
        Case("loopback interrupt", "loopback", "corner", 130, "interrupted", interrupted_at="testing the frames", flags=()),
        Case("loopback force mode", "loopback", "corner", inserts=True, flags=("--skip-self-test", "--mode", "force")),
        Case("ur-rtde jacobian", "ur-rtde", "corner", 2, "Jacobian", simulation=fault("jacobian", 0.0)),
        Case("ur-rtde turned base", "ur-rtde", "corner", inserts=True, simulation={"base_is_turned": True}),
        Case("ur-rtde force mode", "ur-rtde", "corner", inserts=True, flags=("--skip-self-test", "--mode", "force")),
        Case("ur-rtde older", "ur-rtde", "corner", inserts=True, environment={"POLYSCOPE": "URSoftware 5.12.6 (2022)"}),
        Case(
            "ur-rtde older torque", "ur-rtde", "corner", 2, "takes no joint torques", flags=("--mode", "torque"),
            environment={"POLYSCOPE": "URSoftware 5.12.6 (2022)"},
        ),
        Case("franka protective", "franka", "corner", 1, "stopped: ", simulation=fault("protective")),
        Case("ros2 motion-update", "ros2", "corner", inserts=True, flags=("--skip-self-test", "--message", "motion-update")),
        Case("urscript without receiver", "urscript", "corner", inserts=True, has_receiver=False),
        Case("urscript turned base", "urscript", "corner", inserts=True, simulation={"base_is_turned": True}),
        Case("urscript frame", "urscript", "corner", 1, "tool point (TCP)", simulation=fault("frame", 0.0)),
        Case("urscript force", "urscript", "corner", 1, "beyond the limit", simulation=fault("force")),
        Case("urscript too far", "urscript", "corner", 1, "move the robot to the start", simulation={"displaced": 0.6}),
    ]
    return cases


def run(case: Case, address: str, work: pathlib.Path) -> str:
    """Plays a case as a user does; returns what is wrong, or nothing."""
    folder, outcome = work / case.name.replace(" ", "-"), work / case.name.replace(" ", "-") / "outcome.json"
    player, stand_ins = TARGETS[case.target]
    arm = "seven" if case.target == "franka" else "six"
    recorded = RECORDED / f"{case.plan}-{arm}"
    assemble(case, recorded, PLAYERS / player, folder)
    simulation = {"plan": str(recorded), "arm": arm, "offset": (0.0, 0.0, 0.0), "outcome": str(outcome), **case.simulation}
    paths = [HERE / "stand_ins" / stand_ins, HERE, PLAYERS / "shared"] if stand_ins or case.target == "urscript" else []
    common = {**os.environ, **case.environment, "PYTHONDONTWRITEBYTECODE": "1", "OMP_NUM_THREADS": "1"}
    environment = {**common, "SIMULATION": json.dumps(simulation), "PYTHONPATH": ":".join(map(str, paths))}
    with contextlib.ExitStack() as stack:
        if case.target == "loopback":
            stack.enter_context(server(address, environment))
        if case.target == "urscript" and case.has_receiver:
            stack.enter_context(receiver(address, folder, environment))
        code, said = play(case, command_of(case, folder, address), environment)
    return judge(case, code, said, folder)


def assemble(case: Case, recorded: pathlib.Path, player: pathlib.Path, folder: pathlib.Path) -> None:
    """The folder of an export: a recorded plan with the files of its player."""
    for source in (PLAYERS / "shared", player, recorded):
        shutil.copytree(source, folder, dirs_exist_ok=True)
    if case.target == "ros2":
        shutil.copy(HERE / "stand_ins/ros2/middleware.py", folder)


def command_of(case: Case, folder: pathlib.Path, address: str) -> list[str]:
    """What a user types."""
    if case.target == "urscript":
        return [sys.executable, str(HERE / "script_runner.py"), str(folder / "plan.script"), *([address] * case.has_receiver)]
    host = [] if case.target == "ros2" else [address]
    # Without `site`, Python finds no packages.
    python = [sys.executable] if case.has_packages else [sys.executable, "-S"]
    return [*python, str(folder / "play.py"), *host, "--log", str(folder / "executed.csv"), *case.flags]


def play(case: Case, command: list[str], environment: dict[str, str]) -> tuple[int, str]:
    """Runs a player, with Ctrl-C where that is asked for; returns its exit code and what it says."""
    if not case.has_packages:
        environment = {**environment, "PYTHONPATH": ""}
    process = subprocess.Popen(command, env=environment, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    said = ""
    if case.interrupted_at:
        for line in process.stderr:
            said += line
            if line.startswith(case.interrupted_at):
                process.send_signal(signal.SIGINT)
                break
    try:
        said += process.communicate(timeout=PATIENCE)[1]
    except subprocess.TimeoutExpired:
        process.kill()
        said = f"did not end within {PATIENCE:g} s: {process.communicate()[1]}"
    return process.returncode, said


@contextlib.contextmanager
def server(address: str, environment: dict[str, str]) -> Iterator[None]:
    """A simulated robot behind sockets."""
    paths = [HERE, PLAYERS / "shared"]
    environment = {**environment, "PYTHONPATH": ":".join(map(str, paths))}
    process = subprocess.Popen([sys.executable, str(HERE / "rtde_server.py"), address], env=environment)
    try:
        for _ in range(200):
            time.sleep(0.05)
            with socket.socket() as probe:
                if probe.connect_ex((address, DASHBOARD)) == 0:
                    break
        yield
        # The robot notices that the player has gone.
        time.sleep(0.5)
    finally:
        process.terminate()
        process.wait()


@contextlib.contextmanager
def receiver(address: str, folder: pathlib.Path, environment: dict[str, str]) -> Iterator[None]:
    """The receiver of a script's log, which ends with the script."""
    command = [sys.executable, str(folder / "receive.py"), "--address", address, "--log", str(folder / "executed.csv")]
    process = subprocess.Popen(command, env=environment, stderr=subprocess.PIPE, text=True)
    try:
        process.stderr.readline()
        yield
        process.communicate(timeout=PATIENCE)
    finally:
        process.kill()
        process.wait()


def judge(case: Case, code: int, said: str, folder: pathlib.Path) -> str:
    """What is wrong with the end of a case."""
    if code != case.code or case.says not in said or "Traceback" in said:
        return f"exit code {code}, expected {case.code} and `{case.says}`:\n{said}"
    outcome = folder / "outcome.json"
    if not outcome.exists():
        return "" if code in (2, 3) else f"the robot was not left:\n{said}"
    left = json.loads(outcome.read_text())
    if left["mode"] != "position":
        return f"the robot was left in mode {left['mode']}:\n{said}"
    is_inside = left["position_error_m"] <= POSITION_TOLERANCE and left["angle_error_rad"] <= ANGLE_TOLERANCE
    if case.inserts and not is_inside:
        return f"the part is not at its goal: {left}\n{said}"
    if case.has_receiver and code in (0, 1, 130):
        with (folder / "executed.csv").open(newline="") as file:
            header = json.loads(file.readline().removeprefix("#"))
            rows = list(csv.DictReader(file))
        # A script may refuse to begin.
        is_empty = not rows and (case.target != "urscript" or code == 0)
        if is_empty or any(len(row) != len(rows[0]) or None in row.values() for row in rows):
            return "executed.csv is empty or broken"
        if ("stopped" in said or "interrupted" in said) != ("stopped" in header):
            return f"executed.csv does not say whether the robot was stopped: {header}\n{said}"
    return ""


def main() -> int:
    """Runs the cases whose names contain a word of the command line, or all; returns the exit code."""
    words = sys.argv[1:]
    cases = [case for case in insertions() + guards() if not words or any(word in case.name for word in words)]
    if importlib.util.find_spec("rtde_control") is None:
        print("       ur-rtde is not installed: nothing is played over sockets")
        cases = [case for case in cases if case.target != "loopback"]
    failures = 0
    begin = time.monotonic()
    if not words:
        for check in checks.ALL:
            failures += report(check.__name__.replace("_", " "), check())
    with tempfile.TemporaryDirectory() as work, concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        addresses = [f"127.0.1.{number}" for number in range(1, len(cases) + 1)]
        played = pool.map(run, cases, addresses, [pathlib.Path(work)] * len(cases))
        for case, problem in zip(cases, played):
            failures += report(case.name, problem)
    print(f"{len(cases)} cases, {failures} failures, {time.monotonic() - begin:.0f} s")
    return 1 if failures else 0


def report(name: str, problem: str) -> int:
    """Prints how a check ended; returns the number of failures."""
    print(f"{'FAILED' if problem else 'ok':7}{name}{': ' if problem else ''}{problem}", flush=True)
    return 1 if problem else 0


if __name__ == "__main__":
    sys.exit(main())
