"""Plays recorded plans with every player on a simulated arm, and lets every guard stop one."""

import argparse
import concurrent.futures
import importlib.util
import os
import pathlib
import resource
import tempfile
import time
from collections.abc import Sequence

from lab import notebook

# Those of the makers where they exist: stand-ins are compared with them, and ur-rtde is tested itself. PyYAML reads
# parameters as ROS 2 does.
PACKAGES = ("mujoco", "numpy", "PyYAML", "ur-rtde", "franky-control")


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Adds its arguments."""
    add = parser.add_argument
    add("words", nargs="*", metavar="WORD", help="only cases with one of these words in their names [default: all]")
    add(
        "--good-runs",
        type=int,
        metavar="N",
        help="play N motions without a fault instead, none of which may be stopped",
    )
    add("--write-table", action="store_true", help="write the table of faults into its page when all are right")


def run(arguments: argparse.Namespace) -> int:
    """Runs the cases; returns the exit code."""
    from lab.players import checks, faulty_cases

    begin = time.monotonic()
    cases, failures = cases_of(arguments), 0
    if not arguments.words and not arguments.good_runs:
        failures += sum(report(check.__name__.replace("_", " "), check()) for check in checks.ALL)
    failures += play(cases)
    if arguments.write_table and not failures:
        faulty_cases.write_table(notebook.PLAYERS)
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    print(
        f"{len(cases)} cases, {failures} failures, {time.monotonic() - begin:.0f} s, of which processors worked "
        f"{used.ru_utime + used.ru_stime:.0f} s"
    )
    return 1 if failures else 0


def cases_of(arguments: argparse.Namespace) -> list:
    """What is to be played."""
    from lab.players.cases import good_runs, guards, insertions
    from lab.players.faulty_cases import faulty

    if arguments.good_runs:
        return good_runs(arguments.good_runs)
    words = arguments.words or [""]
    cases = [case for case in insertions() + guards() + faulty() if any(word in case.name for word in words)]
    if importlib.util.find_spec("rtde_control") is None:
        print("       ur-rtde is not installed: nothing is played over sockets")
        cases = [case for case in cases if case.target != "loopback"]
    return cases


def play(cases: Sequence) -> int:
    """Plays cases, several at once; returns the number of failures."""
    from lab.players.play import run as run_case

    with tempfile.TemporaryDirectory() as work, concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        addresses = [f"127.0.1.{number}" for number in range(1, len(cases) + 1)]
        played = pool.map(run_case, cases, addresses, [pathlib.Path(work)] * len(cases))
        return sum(report(case.name, problem) for case, problem in zip(cases, played))


def report(name: str, problem: str) -> int:
    """Prints how a check ended; returns the number of failures."""
    print(f"{'FAILED' if problem else 'ok':7}{name}{': ' if problem else ''}{problem}", flush=True)
    return 1 if problem else 0
