"""Plays recorded plans with every player on a simulated arm, and makes faults of all kinds: `main.py [--write-table] [WORD...]` plays
the cases with one of these words, or all; the table of faults is written into docs/reference/players.md when all are right.
`main.py --good-runs N` plays N motions without a fault, with random grasp errors, none of which a guard may stop."""

import concurrent.futures
import contextlib
import csv
import importlib.util
import json
import math
import os
import pathlib
import random
import resource
import shutil
import signal
import socket
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator

import checks
from case import Case, fault
from faulty_cases import DRY_RUN, DRY_RUN_PLAN, faulty, write_table
from rtde_server import DASHBOARD
from seal import seal

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
# Longest time of a player (s), also on a machine that is busy.
PATIENCE = 120.0
# What the players say of success: distance (m) and angle (rad) to the goal.
POSITION_TOLERANCE, ANGLE_TOLERANCE = 0.003, 0.1
# Largest force (N) on something that stands in free air: that of the guard, and what a millisecond of an impact adds.
LARGEST_TOUCH = 200.0


# Two offsets (m) of each plan that it covers.
OFFSETS = {
    "corner": ((0.019, 0.0, 0.0), (0.008, 0.0, 0.01)),
    "clamp1": ((0.003, -0.003, 0.0), (0.0, 0.0035, 0.0)),
    "peg1": ((0.0, 0.0, 0.0), (0.008, -0.008, 0.0)),
}
# Largest turn of the part (rad) in a good run, as those plans cover it.
LARGEST_TURN = 0.01


def insertions() -> list[Case]:
    """Every plan with every player, each with a grasp error that was planned for and one between them."""
    return [
        Case(f"{target} {plan} {number}", target, plan, inserts=True, simulation={"offset": offset, "turn": (0.0, 0.005, 0.0)})
        for target in TARGETS
        for plan in OFFSETS
        for number, offset in enumerate(OFFSETS[plan], 1)
        # Behind sockets, a robot takes longer than its own time.
        if target != "loopback" or (plan, number) == ("clamp1", 1)
    ]


def good_runs(count: int) -> list[Case]:
    """Motions without a fault: players and plans in turn, offsets between two of a plan, turns about any axis."""
    generator = random.Random(1)
    kinds = [(target, plan) for target in TARGETS if target != "loopback" for plan in OFFSETS]
    cases = []
    for number in range(count):
        target, plan = kinds[number % len(kinds)]
        share = generator.random()
        offset = [share * one + (1 - share) * other for one, other in zip(*OFFSETS[plan])]
        axis = [generator.gauss(0, 1) for _ in range(3)]
        size = generator.uniform(0, LARGEST_TURN) / math.hypot(*axis)
        turn = [size * component for component in axis]
        simulation = {"offset": offset, "turn": turn}
        cases.append(Case(f"good run {number + 1}: {target} {plan}", target, plan, inserts=True, simulation=simulation))
    return cases


def guards() -> list[Case]:
    """What stops a player beside faults, and what must not."""

    cases = []
    for target in ("ur-rtde", "franka", "ros2"):
        add = lambda name, *rest, plan="corner", target=target, **more: cases.append(
            Case(f"{target} {name}", target, plan, *rest, **more)
        )
        add("self-test and dry run", 0, "dry run: the tool ends", plan=DRY_RUN_PLAN, flags=("--dry-run", DRY_RUN))
        add("interrupt", 130, "interrupted", interrupted_at="testing the frames", flags=())
        add("without packages", 3, "pip install numpy", has_packages=False)
        add("wrong factor", 2, "--stiffness-factor", flags=("--stiffness-factor", "-1"))
        add("soft", 1, "the tool moved", flags=("--stiffness-factor", "0.001"))
        add("distance", 1, "from its reference", flags=("--skip-self-test", "--distance-limit", "0.001"))
        add("displaced", 0, "", inserts=True, simulation={"displaced": 0.005})
    for name in ("force", "hang", "disconnect", "protective"):
        cases.append(Case(f"loopback {name}", "loopback", "corner", 1, "stopped: ", simulation=fault(name)))
    cases += [
        Case("loopback interrupt", "loopback", "corner", 130, "interrupted", interrupted_at="testing the frames", flags=()),
        Case("loopback force mode", "loopback", "corner", inserts=True, flags=("--skip-self-test", "--mode", "force")),
        Case("ur-rtde turned base", "ur-rtde", "corner", inserts=True, simulation={"base_is_turned": True}),
        Case("ur-rtde force mode", "ur-rtde", "corner", inserts=True, flags=("--skip-self-test", "--mode", "force")),
        Case("ur-rtde older", "ur-rtde", "corner", inserts=True, environment={"POLYSCOPE": "URSoftware 5.12.6 (2022)"}),
        Case(
            "ur-rtde older torque", "ur-rtde", "corner", 2, "takes no joint torques", flags=("--mode", "torque"),
            environment={"POLYSCOPE": "URSoftware 5.12.6 (2022)"},
        ),
        Case("ros2 motion-update", "ros2", "corner", inserts=True, flags=("--skip-self-test", "--message", "motion-update")),
        Case("urscript without receiver", "urscript", "corner", inserts=True, has_receiver=False),
        Case("urscript turned base", "urscript", "corner", inserts=True, simulation={"base_is_turned": True}),
        Case("urscript force", "urscript", "corner", 1, "beyond the limit", simulation=fault("force")),
        Case("urscript too far", "urscript", "corner", 1, "move the robot to the start", simulation={"displaced": 0.6}),
    ]
    return cases


def run(case: Case, address: str, work: pathlib.Path) -> str:
    """Plays a case as a user does; returns what is wrong, or nothing."""
    folder, outcome = work / case.folder, work / case.folder / "outcome.json"
    player, stand_ins = TARGETS[case.target]
    arm = "seven" if case.target == "franka" else "six"
    recorded = RECORDED / f"{case.plan}-{arm}"
    assemble(case, recorded, PLAYERS / player, folder)
    simulation = {"plan": str(recorded), "arm": arm, "offset": (0.0, 0.0, 0.0), "outcome": str(outcome), **case.simulation}
    paths = [HERE / "stand_ins" / stand_ins, HERE, PLAYERS / "shared"] if stand_ins or case.target == "urscript" else []
    common = {**os.environ, **case.environment, "PYTHONDONTWRITEBYTECODE": "1", "OMP_NUM_THREADS": "1"}
    # Nothing is drawn: MuJoCo need not look for a screen.
    common["MUJOCO_GL"] = "disable"
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
    if case.target == "urscript":
        choose(folder / "plan.script", case.flags)
    seal(folder)
    if case.spoil:
        case.spoil(folder)


def choose(script: pathlib.Path, flags: tuple[str, ...]) -> None:
    """Changes the first lines of a script as flags change a player."""
    text = script.read_text()
    values = dict(zip(flags, flags[1:]))
    for flag, name, usual in (("--dry-run", "dry_run", "0.0"), ("--stiffness-factor", "stiffness_factor", "1.0")):
        text = text.replace(f"global {name} = {usual}", f"global {name} = {float(values.get(flag, usual))}")
    script.write_text(text.replace("self_test = True", f"self_test = {'--skip-self-test' not in flags}"))


def command_of(case: Case, folder: pathlib.Path, address: str) -> list[str]:
    """What a user types."""
    if case.target == "urscript":
        return [sys.executable, str(HERE / "script_runner.py"), str(folder / "plan.script"), *([address] * case.has_receiver)]
    host = [] if case.target == "ros2" else [address]
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
    if problem := problem_of_outcome(case, code, folder) or problem_of_log(case, code, folder):
        return f"{problem}\n{said}"
    return ""


def problem_of_outcome(case: Case, code: int, folder: pathlib.Path) -> str:
    """How the robot was left, as the simulation knows it."""
    outcome = folder / "outcome.json"
    if not outcome.exists():
        return "" if code in (2, 3, -signal.SIGKILL) else "the robot was not left"
    left = json.loads(outcome.read_text())
    if left["mode"] != "position":
        return f"the robot was left in mode {left['mode']}"
    if code == 2 and left["commands"] and "gains" not in case.says:
        return f"a player that refuses has sent {left['commands']} commands"
    if left["obstacle_force_n"] > LARGEST_TOUCH:
        return f"the tool pressed an obstacle with {left['obstacle_force_n']:.0f} N"
    is_inside = left["position_error_m"] <= POSITION_TOLERANCE and left["angle_error_rad"] <= ANGLE_TOLERANCE
    return f"the part is not at its goal: {left}" if case.inserts and not is_inside else ""


def problem_of_log(case: Case, code: int, folder: pathlib.Path) -> str:
    """Whether the log tells what was said."""
    log = folder / case.log
    if not case.has_receiver or code not in (0, 1, 130, -signal.SIGKILL):
        return ""
    with log.open(newline="") as file:
        header = json.loads(file.readline().removeprefix("#"))
        rows = list(csv.DictReader(file))
    # Faults from the beginning and a script that refuses leave no rows.
    is_empty = not rows and (code == 0 or case.interrupted_at != "")
    if is_empty or any(len(row) != len(rows[0]) or None in row.values() for row in rows):
        return "the log is empty or broken"
    reason = header.get("stopped", "")
    if (code != 0) != bool(reason) or (case.target != "urscript" and code in (1, 130) and case.says.removeprefix("stopped: ") not in reason):
        return f"the log does not say why the robot was stopped: {header}"
    return ""


def main() -> int:
    """Runs the cases whose names contain a word of the command line, or all; returns the exit code."""
    words = [word for word in sys.argv[1:] if word != "--write-table"]
    is_for_page = words != sys.argv[1:]
    if words[:1] == ["--good-runs"]:
        cases = good_runs(int(words[1]))
    else:
        cases = [case for case in insertions() + guards() + faulty() if not words or any(word in case.name for word in words)]
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
    if is_for_page and not failures:
        write_table(ROOT / "docs/reference/players.md")
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    print(
        f"{len(cases)} cases, {failures} failures, {time.monotonic() - begin:.0f} s, of which processors worked "
        f"{used.ru_utime + used.ru_stime:.0f} s"
    )
    return 1 if failures else 0


def report(name: str, problem: str) -> int:
    """Prints how a check ended; returns the number of failures."""
    print(f"{'FAILED' if problem else 'ok':7}{name}{': ' if problem else ''}{problem}", flush=True)
    return 1 if problem else 0


if __name__ == "__main__":
    sys.exit(main())
