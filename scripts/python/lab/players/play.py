"""Plays a case as a user does, in an exported folder, with stand-ins of the makers' packages."""

import contextlib
import itertools
import json
import os
import pathlib
import resource
import shutil
import signal
import socket
import subprocess
import sys
import time
from collections.abc import Iterator

from lab.paths import PLAYERS
from lab.players.case import Case
from lab.players.judgement import judge
from lab.players.rtde_server import DASHBOARD
from lab.players.seal import seal

HERE = pathlib.Path(__file__).resolve().parent
RECORDED = HERE / "recorded"
# Folder of the player, folder of its stand-ins.
TARGETS = {
    "ur-rtde": ("ur_rtde", "ur"),
    "loopback": ("ur_rtde", ""),
    "franka": ("franka", "franka"),
    "ros2": ("ros2", "ros2"),
    "ros2-control": ("ros2_control", "ros2_control"),
    "urscript": ("urscript", ""),
    "correction": ("correction", ""),
}
# Robots behind topics of ROS 2.
TOPICS = ("ros2", "ros2-control")
# What plans are recorded for besides arms that are commanded torques: the arm with six joints.
COMMANDED = ("position", "force")
# Names of the arms that the plans were recorded for, where it is not the one with six joints.
ARMS = {"franka": "seven", "correction": "none", "ros2-control": "position"}
# Longest time of a player (s), also on a machine that is busy.
PATIENCE = 120.0


def run(case: Case, address: str, work: pathlib.Path) -> str:
    """Plays a case as a user does; returns what is wrong, or nothing."""
    folder, outcome = work / case.folder, work / case.folder / "outcome.json"
    player, stand_ins = TARGETS[case.target]
    arm = case.arm or ARMS.get(case.target, "six")
    recorded = RECORDED / f"{case.plan}-{arm}"
    assemble(case, recorded, PLAYERS / player, folder)
    simulation = {
        "plan": str(recorded),
        "arm": "six" if arm in COMMANDED else arm,
        "offset": (0.0, 0.0, 0.0),
        "outcome": str(outcome),
        **case.simulation,
    }
    paths = [HERE / "stand_ins" / stand_ins, HERE.parents[1]] if stand_ins or case.target == "urscript" else []
    common = {**os.environ, **case.environment, "PYTHONDONTWRITEBYTECODE": "1", "OMP_NUM_THREADS": "1"}
    # Nothing is drawn: MuJoCo need not look for a screen.
    common["MUJOCO_GL"] = "disable"
    environment = {**common, "SIMULATION": json.dumps(simulation), "PYTHONPATH": ":".join(map(str, paths))}
    with contextlib.ExitStack() as stack:
        if case.target == "loopback":
            stack.enter_context(server(address, environment))
        if case.target == "correction":
            stack.enter_context(correction_server(address, environment))
        if case.target == "urscript" and case.has_receiver:
            stack.enter_context(receiver(address, folder, environment))
        code, said = play(case, command_of(case, folder, address), environment)
    return judge(case, code, said, folder)


def assemble(case: Case, recorded: pathlib.Path, player: pathlib.Path, folder: pathlib.Path) -> None:
    """The folder of an export: a recorded plan with the files of its player."""
    for source in (PLAYERS / "shared", player, recorded):
        shutil.copytree(source, folder, dirs_exist_ok=True)
    if case.target in TOPICS:
        shutil.copytree(PLAYERS / "topics", folder, dirs_exist_ok=True)
        # Without ROS, there is neither a node nor its messages.
        (folder / "node.py").unlink()
        shutil.copy(HERE / "stand_ins" / player.name / "middleware.py", folder)
    if case.target == "urscript":
        choose(folder / "plan.script", case.flags)
    seal(folder)
    if case.spoil:
        case.spoil(folder)


def choose(script: pathlib.Path, flags: tuple[str, ...]) -> None:
    """Changes the first lines of a script as flags change a player."""
    text = script.read_text()
    values = dict(itertools.pairwise(flags))
    for flag, name, usual in (("--dry-run", "dry_run", "0.0"), ("--stiffness-factor", "stiffness_factor", "1.0")):
        text = text.replace(f"global {name} = {usual}", f"global {name} = {float(values.get(flag, usual))}")
    text = text.replace("path_is_free = False", f"path_is_free = {'--path-is-free' in flags}")
    script.write_text(text.replace("self_test = True", f"self_test = {'--skip-self-test' not in flags}"))


def command_of(case: Case, folder: pathlib.Path, address: str) -> list[str]:
    """What a user types."""
    if case.target == "urscript":
        runner = [sys.executable, "-P", "-m", "lab.players.script_runner"]
        return [*runner, str(folder / "plan.script"), *([address] * case.has_receiver)]
    host = [] if case.target in TOPICS else ["--address", address] if case.target == "correction" else [address]
    # Without `site`, Python finds no packages.
    python = [sys.executable] if case.has_packages else [sys.executable, "-S"]
    return [*python, str(folder / "play.py"), *host, "--log", str(folder / case.log), *case.flags]


def play(case: Case, command: list[str], environment: dict[str, str]) -> tuple[int, str]:
    """Runs a player, with a signal where that is asked for; returns its exit code and what it says."""
    if not case.has_packages:
        environment = {**environment, "PYTHONPATH": ""}
    limited = (lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (case.limit, case.limit))) if case.limit else None
    pipe = subprocess.PIPE
    process = subprocess.Popen(command, env=environment, stdout=pipe, stderr=pipe, text=True, preexec_fn=limited)
    said = ""
    if case.interrupted_at:
        for line in process.stderr:
            said += line
            if line.startswith(case.interrupted_at):
                time.sleep(0.3)
                if not case.hears:
                    process.stderr.close()
                process.send_signal(getattr(signal, case.signal))
                break
    try:
        said += process.communicate(timeout=PATIENCE)[1] if case.hears else ""
        process.wait(timeout=PATIENCE)
    except subprocess.TimeoutExpired:
        process.kill()
        said = f"did not end within {PATIENCE:g} s: {process.communicate()[1]}"
    return process.returncode, said


@contextlib.contextmanager
def server(address: str, environment: dict[str, str]) -> Iterator[None]:
    """A simulated robot behind sockets."""
    environment = {**environment, "PYTHONPATH": str(HERE.parents[1])}
    process = subprocess.Popen([sys.executable, "-P", "-m", "lab.players.rtde_server", address], env=environment)
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
def correction_server(address: str, environment: dict[str, str]) -> Iterator[None]:
    """A simulated robot that takes corrections; it ends by itself when the player does."""
    environment = {**environment, "PYTHONPATH": f"{PLAYERS / 'shared'}:{HERE.parents[1]}"}
    process = subprocess.Popen([sys.executable, "-P", "-m", "lab.players.correction_server", address], env=environment)
    try:
        yield
        process.wait(timeout=PATIENCE)
    finally:
        process.kill()
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
