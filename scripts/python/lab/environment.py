"""The environment of the commands that need packages: `target/lab`, which has of `requirements.txt` what was needed so
far.

It is rebuilt when the pins change.
"""

import fcntl
import importlib.util
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys

from lab.errors import Failure, InputError
from lab.paths import ROOT

FOLDER = ROOT / "target/lab"
PINS = ROOT / "scripts/python/requirements.txt"
# Written last: what it names is whole.
RECORD = FOLDER / "installed.json"


def enter(packages: tuple[str, ...]) -> None:
    """Goes on in the environment with some packages, anywhere if there are none: runs the same command there."""
    if packages:
        install(packages)
        if pathlib.Path(sys.prefix).resolve() != FOLDER.resolve():
            python = FOLDER / "bin/python"
            os.execv(python, [python, "-P", "-m", "lab", *sys.argv[1:]])


def install(packages: tuple[str, ...]) -> None:
    """Adds packages to the environment, unless it has them. Another command that installs is waited for."""
    FOLDER.parent.mkdir(parents=True, exist_ok=True)
    with FOLDER.with_suffix(".lock").open("w") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)
        install_missing(packages)


def install_missing(packages: tuple[str, ...]) -> None:
    """Adds packages to the environment, unless it has them."""
    pins = PINS.read_text()
    record = json.loads(RECORD.read_text()) if RECORD.exists() else {}
    installed = record.get("packages", []) if record.get("pins") == pins else []
    missing = [name for name in packages if name not in installed]
    if not missing:
        return
    requirements = [pinned(name, pins) for name in missing]
    if not installed:
        make()
    print(f"installing {', '.join(missing)} in {FOLDER.relative_to(ROOT)}, once", file=sys.stderr)
    pip = [FOLDER / "bin/pip", "install", "--quiet", "--disable-pip-version-check", "--constraint", PINS]
    if subprocess.run([*pip, *requirements], stdout=sys.stderr, check=False).returncode:
        raise Failure(f"{', '.join(missing)} cannot be installed")
    RECORD.write_text(json.dumps({"pins": pins, "packages": [*installed, *missing]}))


def make() -> None:
    """An environment without packages."""
    if not all(map(importlib.util.find_spec, ("ensurepip", "venv"))):
        raise Failure(f"{sys.executable} cannot make virtual environments; on Debian: apt install python3-venv")
    shutil.rmtree(FOLDER, ignore_errors=True)
    if subprocess.run([pathlib.Path(sys.executable).resolve(), "-m", "venv", FOLDER], check=False).returncode:
        raise Failure(f"the virtual environment {FOLDER} cannot be made")


def pinned(name: str, pins: str) -> str:
    """The requirement of a package, with its version and the machines for which it exists."""
    found = re.search(rf"^{re.escape(name)}==.*$", pins, re.MULTILINE)
    if found is None:
        raise InputError(f"{name} is not in {PINS.relative_to(ROOT)}")
    return found[0]
