"""Commands that write scenes or solve many of them, each in a process of the program."""

from __future__ import annotations

import json
import os
import re
import subprocess
import sys
import warnings
from collections.abc import Iterable
from pathlib import Path
from typing import Any, Literal

from assembly_plan._values import StrPath, threads
from assembly_plan.errors import NoPlanError, PlannerError, SceneError, SceneWarning
from assembly_plan.scene import Scene

_ERRORS: dict[int, type[PlannerError]] = {1: NoPlanError, 2: SceneError}


def new(
    file: StrPath,
    *,
    body: StrPath | None = None,
    environment: StrPath | None = None,
    unit: str | None = None,
    axis: str | None = None,
    link: str | None = None,
    environment_link: str | None = None,
    offset: float | None = None,
    position_tolerance: float | None = None,
    contact_force: float | None = None,
    force: bool = False,
) -> Scene:
    """Write a commented scene file, from two meshes or models or an example, as the command ``new`` does; read it.

    `body` and `environment` are files in the assembled pose, meshes in a `unit` (``m``, ``cm``, ``mm``, ``inch``). The
    body is taken out along `axis`, such as ``-z``, by default one in which it gets out; `link` and `environment_link`
    name links of models. `offset` (m), `position_tolerance` (m) and `contact_force` (N) are values of the scene. With
    `force`, a file that exists is replaced.
    """
    flags = {
        "body": body,
        "environment": environment,
        "unit": unit,
        "axis": axis,
        "link": link,
        "environment-link": environment_link,
        "offset": offset,
        "position-tolerance": position_tolerance,
        "contact-force": contact_force,
    }
    _run(["new", file, *_words(flags, force=force)])
    return Scene.load(file)


def generate(
    kind: Literal["random", "round", "rectangular", "keyed"],
    out: StrPath,
    *,
    length: float | None = None,
    clearance: float | None = None,
    chamfer: float | None = None,
    offset: float | None = None,
    diameter: float | None = None,
    width: float | None = None,
    depth: float | None = None,
    key_width: float | None = None,
    key_height: float | None = None,
    facets: int | None = None,
    prisms: int | None = None,
    seed: int | None = None,
    force: bool = False,
) -> Scene:
    """Write the scene file of a peg and its hole, as the command ``generate`` does, and read it.

    All lengths are in metres; each kind of peg takes the flags of ``assembly-plan generate KIND --help``. With `force`,
    a file that exists is replaced.
    """
    flags = {
        "out": out,
        "length": length,
        "clearance": clearance,
        "chamfer": chamfer,
        "offset": offset,
        "diameter": diameter,
        "width": width,
        "depth": depth,
        "key-width": key_width,
        "key-height": key_height,
        "facets": facets,
        "prisms": prisms,
        "seed": seed,
    }
    _run(["generate", kind, *_words(flags, force=force)])
    return Scene.load(out)


def batch(
    scenes: StrPath | Iterable[StrPath],
    out: StrPath,
    *,
    starts: Iterable[str | int] = (),
    deltas: Iterable[float] = (),
    homotopies: Iterable[StrPath] = (),
    linear_solver: str | None = None,
    report: bool = False,
    jobs: int | None = None,
) -> list[dict[str, Any]]:
    """Plan scene files for many starts and offset magnitudes into a folder, as the command ``batch`` does.

    Every cell is solved in a process of its own, `jobs` at once; the same call resumes an interrupted one. Returns the
    entries of ``cells.json``; a cell without a plan says so in its ``state``. With `report`, pages are written.
    """
    files = [scenes] if isinstance(scenes, str | os.PathLike) else list(scenes)
    flags = {
        "out": out,
        "starts": _list(starts),
        "deltas": _list(deltas),
        "homotopies": _list(homotopies),
        "linear-solver": linear_solver,
        "jobs": threads(jobs),
    }
    # Cells that have no plan are in the table, too.
    _run(["batch", *files, *_words(flags, report=report), "--quiet"], accepted=(0, 1))
    _run(["batch", "collect", out])
    cells: list[dict[str, Any]] = json.loads((Path(out) / "cells.json").read_text(encoding="utf-8"))
    return cells


def _list(values: Iterable[Any]) -> str | None:
    return ",".join(str(value) for value in values) or None


def _words(flags: dict[str, Any], **switches: bool) -> list[str]:
    values = [
        f"--{name}={os.fspath(value) if isinstance(value, os.PathLike) else value}"
        for name, value in flags.items()
        if value is not None
    ]
    return values + [f"--{name}" for name, on in switches.items() if on]


def _run(words: list[Any], accepted: tuple[int, ...] = (0,)) -> None:
    command = [sys.executable, "-P", "-m", "assembly_plan", *map(os.fspath, words)]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    for line in done.stderr.splitlines():
        if line.startswith("warning: "):
            warnings.warn(line.removeprefix("warning: "), SceneWarning, stacklevel=3)
    if done.returncode == 130:
        raise KeyboardInterrupt
    if done.returncode not in accepted:
        message = done.stderr.rpartition("error: ")[2].strip()
        # Flags are keyword arguments here.
        named = re.sub(r"--([a-z][a-z-]*)", lambda flag: flag[1].replace("-", "_"), message)
        raise _ERRORS.get(done.returncode, PlannerError)(named)
