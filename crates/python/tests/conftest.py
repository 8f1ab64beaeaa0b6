"""What all tests share: scenes, a plan, and the command line."""

import subprocess
import sys
from pathlib import Path

import assembly_plan
import pytest

ROOT = Path(__file__).resolve().parents[3]
CORNER = ROOT / "scenes" / "corner.toml"
PEG = ROOT / "scenes" / "peg1.toml"


@pytest.fixture(scope="session")
def scene() -> assembly_plan.Scene:
    return assembly_plan.Scene.load(CORNER)


@pytest.fixture(scope="session")
def plan(scene: assembly_plan.Scene) -> assembly_plan.Plan:
    return scene.solve()


def command(*arguments: object) -> subprocess.CompletedProcess[str]:
    """Run the command line of the package."""
    words = [sys.executable, "-m", "assembly_plan", *map(str, arguments)]
    return subprocess.run(words, capture_output=True, text=True, check=False)


def error_of(*arguments: object) -> str:
    """The error message of a command whose input is wrong."""
    run = command(*arguments)
    assert run.returncode == 2, run
    message = run.stderr.removeprefix("error: ").removesuffix("\n")
    assert message != run.stderr
    return message
