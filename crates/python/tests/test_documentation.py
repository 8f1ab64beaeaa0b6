"""What users read: signatures, docstrings, pages and examples."""

import inspect
import keyword
import os
import re
import subprocess
import sys
from pathlib import Path

import assembly_plan
import nbclient
import nbformat
import pytest
from assembly_plan import (
    Arm,
    Contacts,
    Figure,
    Plan,
    Reference,
    Rollouts,
    Scene,
    Simulation,
    arm,
    commands,
    contacts,
    content,
    errors,
    events,
    figure,
    motion,
    plan,
    reference,
    rollouts,
    scene,
    simulation,
)
from conftest import CORNER, ROOT, command

EXAMPLES = ROOT / "crates/python/examples"


def run(words: list[object], folder: Path) -> str:
    environment = {**os.environ, "MPLBACKEND": "Agg"}
    done = subprocess.run(
        [sys.executable, *map(str, words)], capture_output=True, text=True, cwd=folder, env=environment
    )
    assert done.returncode == 0, done.stderr
    return done.stdout


@pytest.mark.parametrize("name", ["solve", "solve_robust", "simulate", "check", "distances"])
def test_keywords_are_flags_of_the_command(name: str) -> None:
    subcommand = {"solve_robust": "solve", "distances": "check"}.get(name, name)
    shown = command(subcommand, "--help").stdout
    flags = {flag.replace("-", "_") for flag in re.findall(r"--([a-z][a-z-]*)", shown)}
    parameters = inspect.signature(getattr(Scene, name)).parameters
    keywords = {key for key, value in parameters.items() if value.kind is value.KEYWORD_ONLY}
    # A word of the language ends with an underscore.
    flags |= {flag + "_" for flag in flags & set(keyword.kwlist)}
    # The command shows progress; a guess is an array; `check` has no flag for a homotopy.
    assert keywords - {"progress", "guess"} - ({"homotopy"} if subcommand == "check" else set()) <= flags
    for key in keywords:
        default = re.search(
            rf"--{key.replace('_', '-')} <[^\n]*\[default: ([0-9.e-]+)", shown.split("Options:")[1], re.DOTALL
        )
        value = parameters[key].default
        if isinstance(value, float | int) and not isinstance(value, bool):
            assert default is not None and float(default[1]) == value, key


def test_everything_public_is_documented() -> None:
    parts = (arm, commands, contacts, content, figure, motion, reference, rollouts)
    for module in (assembly_plan, errors, events, plan, scene, simulation, *parts):
        assert module.__doc__
        for name, item in vars(module).items():
            if name.startswith("_") or not getattr(item, "__module__", "").startswith("assembly_plan"):
                continue
            assert item.__doc__, name
            if inspect.isclass(item):
                for member, value in vars(item).items():
                    if not member.startswith("_") and (callable(value) or isinstance(value, property)):
                        assert value.__doc__, f"{name}.{member}"


def test_help_renders() -> None:
    shown = run(["-m", "pydoc", "assembly_plan.Scene"], ROOT)
    assert "solve_robust(self, *, start: 'str | int | None' = None" in shown
    assert "offset magnitude (m)" in shown


@pytest.mark.parametrize("page", ["docs/reference/python.md", "README.md", "crates/python/README.md"])
def test_python_in_pages_runs(page: str, tmp_path: Path) -> None:
    (tmp_path / "scenes").symlink_to(ROOT / "scenes")
    blocks = re.findall(r"```python\n(.*?)```", (ROOT / page).read_text(), re.DOTALL)
    assert blocks
    # Each block continues the one before.
    script = tmp_path / "page.py"
    script.write_text("".join(blocks))
    run([script], tmp_path)


@pytest.mark.parametrize(
    ("words", "expected"),
    [
        (["solve.py", CORNER, "--out", "corner"], "planned, not tested"),
        (["scene_in_code.py"], "offsets of 20 mm: planned"),
        (["refine.py", CORNER, "--friction", 0], "friction 0: "),
        (["play.py", CORNER, "--friction", 0], "straight push, friction 0, offset 0 0 0.01 m"),
        (["distances.py", CORNER], "1.00 mm (smoothed 8.88 mm)"),
    ],
)
def test_small_examples_run(words: list[object], expected: str, tmp_path: Path) -> None:
    shown = run([EXAMPLES / str(words[0]), *words[1:]], tmp_path)
    assert expected in shown, shown


@pytest.mark.filterwarnings("default")
def test_the_notebook_runs(tmp_path: Path) -> None:
    (tmp_path / "scenes").symlink_to(ROOT / "scenes")
    notebook = nbformat.read(EXAMPLES / "notebook.ipynb", as_version=4)
    nbclient.NotebookClient(notebook, timeout=600, resources={"metadata": {"path": str(tmp_path)}}).execute()
    outputs = [output for cell in notebook.cells if cell.cell_type == "code" for output in cell.outputs]
    shown = "".join(output.text for output in outputs if output.output_type == "stream" and output.name == "stdout")
    assert "planned, not tested" in shown
    kinds = {kind for output in outputs if "data" in output for kind in output.data}
    assert {"image/png", "text/html"} <= kinds, "figure and page"


def test_the_tour_uses_everything(tmp_path: Path) -> None:
    tour = (EXAMPLES / "tour.py").read_text()
    for kind in (Scene, Plan, Reference, Rollouts, Simulation, Contacts, Arm, Figure):
        public = [name for name in vars(kind) if not name.startswith("_")]
        unused = [name for name in public if f".{name}" not in tour]
        assert unused == [], kind.__name__
    shown = run([EXAMPLES / "tour.py", CORNER, tmp_path / "tour"], tmp_path)
    assert "replanned: done, 0 iterations" in shown
    names = {
        "plan",
        "robust",
        "robot",
        "simulation",
        "plan.xml",
        "report.html",
        "forces.svg",
        "moving.svg",
        "peg.toml",
        "batch",
    }
    assert names <= {file.name for file in (tmp_path / "tour").iterdir()}


def test_the_sweep_is_drawn(tmp_path: Path) -> None:
    shown = run([EXAMPLES / "sweep.py", CORNER, "--deltas", 0.005, 0.01, "--random", 5], tmp_path)
    assert "planned for 5 mm: planned, not tested" in shown
    assert (tmp_path / "success.png").read_bytes().startswith(b"\x89PNG")


def test_a_part_is_planned_from_a_mesh(tmp_path: Path) -> None:
    shown = run([EXAMPLES / "mesh.py", "--out", tmp_path / "clamp"], tmp_path)
    assert "the mesh became clamp.1, clamp.2, clamp.3" in shown
    assert Plan.load(tmp_path / "clamp").planned


def test_a_plan_is_played_in_mujoco(tmp_path: Path) -> None:
    Scene.load(CORNER).solve_robust(out=tmp_path / "plan")
    shown = run([EXAMPLES / "mujoco_play.py", CORNER, tmp_path / "plan"], tmp_path)
    errors = [float(number) for number in re.findall(r"ends ([0-9.]+) mm", shown)]
    assert len(errors) == 2 and max(errors) < 3.0
