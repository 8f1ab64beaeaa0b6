"""Runs `assembly-plan`, and other commands of this repository."""

import dataclasses
import os
import pathlib
import subprocess
import sys
import time

from lab.errors import Failure
from lab.paths import LAB, PROGRAM, ROOT

# 1 says that there is no plan, or that it is not as robust as wanted: that is a result.
RESULTS = (0, 1)


@dataclasses.dataclass(frozen=True)
class Usage:
    """What a process took: wall and processor time (s), of user and system, its peak memory (MB) and its exit code."""

    wall_s: float
    cpu_s: float
    peak_memory_mb: float
    code: int


def build() -> None:
    """Builds the program; cargo does nothing where it is current."""
    subprocess.run([ROOT / "scripts/plan", "--version"], stdout=sys.stderr, check=True)


def given_or_built(file: pathlib.Path | None) -> pathlib.Path:
    """The program that is given, or else that of this repository, built."""
    if file is None:
        build()
    return file or PROGRAM


def run(*arguments: object, output: int | None = None, accepted: tuple[int, ...] = RESULTS) -> str | None:
    """Runs the program; returns what it prints if `output` is a pipe. An exit code that is not accepted is a
    failure."""
    command = [PROGRAM, *map(str, arguments)]
    done = subprocess.run(command, stdout=output, text=True, check=False)
    if done.returncode not in accepted:
        raise failure(command, done.returncode)
    return done.stdout


def measured(
    *arguments: object,
    log: pathlib.Path | None = None,
    program: pathlib.Path = PROGRAM,
    accepted: tuple[int, ...] = RESULTS,
) -> Usage:
    """Runs a program, with everything that it says in a log if there is one, and measures it. Times contain starting,
    reading and writing. Peak memory counts from what this process had when the program began."""
    command = [program, *map(str, arguments)]
    begin = time.perf_counter()
    if log is None:
        child = subprocess.Popen(command)
    else:
        with log.open("w") as file:
            child = subprocess.Popen(command, stdout=file, stderr=subprocess.STDOUT)
    _, status, usage = os.wait4(child.pid, 0)
    wall = time.perf_counter() - begin
    child.returncode = os.waitstatus_to_exitcode(status)
    if child.returncode not in accepted:
        raise failure(command, child.returncode, log)
    return Usage(wall, usage.ru_utime + usage.ru_stime, usage.ru_maxrss * 1024 / 1e6, child.returncode)


def failure(command: list[object], code: int, log: pathlib.Path | None = None) -> Failure:
    """What is said of a command that failed."""
    return Failure(f"{' '.join(map(str, command))} ended with code {code}" + (f"; see {log}" if log else ""))


def validate(plan: pathlib.Path, table: pathlib.Path, *options: object) -> None:
    """Plays a plan in MuJoCo into a table of all motions, unless that is done."""
    if table.exists():
        return
    unfinished = table.with_suffix(".unfinished")
    subprocess.run([LAB, "validate", plan, *map(str, options), "--csv", unfinished], check=True)
    unfinished.rename(table)
