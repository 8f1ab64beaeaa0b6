"""What the commands write, from Python."""

import xml.etree.ElementTree as ElementTree
from pathlib import Path

import assembly_plan
import mujoco
import numpy as np
import pytest
from assembly_plan import Plan, Scene, SceneError, SceneWarning, events
from conftest import CORNER, ROOT


def test_a_plan_is_exported(scene: Scene, tmp_path: Path) -> None:
    plan = scene.solve_robust(friction=[0.0, 0.1], time_limit=60)
    with pytest.warns(SceneWarning, match="the scene has no arm"):
        files = plan.export("csv", tmp_path / "robot", rate=250)
    assert sorted(files) == sorted(file.name for file in (tmp_path / "robot").iterdir())
    assert {"trajectory.csv", "plan.json", "SHA256SUMS"} <= set(files)
    assert plan.result["files"] == {}
    with pytest.raises(SceneError, match="target = abb: unknown; choose one of csv, ur-rtde"):
        plan.export("abb", tmp_path / "other")
    with pytest.raises(SceneError, match="rate = '250': must be a number"):
        plan.export("csv", tmp_path / "other", rate="250")  # type: ignore[arg-type]


def test_a_model_plays_the_plan_in_mujoco(scene: Scene) -> None:
    plan = scene.solve_robust(friction=[0.0, 0.1], time_limit=3600)
    model = mujoco.MjModel.from_xml_string(plan.mjcf())
    data = mujoco.MjData(model)
    mujoco.mj_forward(model, data)
    assert data.body("body").xpos == pytest.approx(scene.starts["1"][:3], abs=1e-6)
    while data.time < plan.time[-1] + 1.0:
        mujoco.mj_step(model, data)
    assert np.linalg.norm(data.body("body").xpos - scene.goal[:3]) < 3e-3


def test_figures_are_drawn(plan: Plan, tmp_path: Path) -> None:
    figure = plan.figure()
    assert ElementTree.fromstring(figure._repr_svg_()).tag.endswith("svg")
    assert plan.figure("forces").svg != figure.svg
    figure.save(tmp_path / "figure.svg")
    assert (tmp_path / "figure.svg").read_text() == figure.svg
    with pytest.raises(SceneError, match="choose one of keyframes-x, keyframes-y, keyframes-z, forces, convergence"):
        plan.figure("energy")


def test_scenes_are_written(tmp_path: Path) -> None:
    peg = assembly_plan.generate("round", tmp_path / "peg.toml", diameter=0.01, facets=6)
    assert len(peg.body) == 1 and len(peg.body[0].vertices) == 12
    with pytest.raises(SceneError, match="force"):
        assembly_plan.generate("round", tmp_path / "peg.toml")
    body, environment = ROOT / "examples/cap.stl", ROOT / "examples/base.stl"
    cap = assembly_plan.new(tmp_path / "cap.toml", unit="mm", offset=0.0015, body=body, environment=environment)
    assert cap.offset_magnitude == 0.0015 and cap == Scene.load(tmp_path / "cap.toml")
    with pytest.raises(SceneError, match="offset"):
        assembly_plan.new(tmp_path / "other.toml", unit="mm", offset=-1.0, body=body, environment=environment)


def test_a_batch_is_solved(tmp_path: Path) -> None:
    cells = assembly_plan.batch(CORNER, tmp_path / "batch", starts=[1, 2], deltas=[0.01], jobs=2)
    assert len(cells) == 2 and {cell["cell"]["start"] for cell in cells} == {"1", "2"}
    assert assembly_plan.batch(CORNER, tmp_path / "batch", starts=[1, 2], deltas=[0.01]) == cells
    with pytest.raises(SceneError, match="start"):
        assembly_plan.batch(CORNER, tmp_path / "none", starts=["9"])


def test_logs_of_other_robots_are_refused(scene: Scene, tmp_path: Path) -> None:
    (tmp_path / "log.csv").write_text("no log\n")
    with pytest.raises(SceneError, match=r"log\.csv"):
        scene.calibrate(tmp_path / "log.csv")


def test_wrong_types_are_named_as_the_caller_wrote_them(scene: Scene, plan: Plan) -> None:
    with pytest.raises(SceneError, match=r"delta = '0.01': must be a number"):
        scene.solve(delta="0.01")  # type: ignore[arg-type]
    with pytest.raises(SceneError, match=r"jobs = 1.5: must be a whole number"):
        scene.solve(jobs=1.5)  # type: ignore[arg-type]
    with pytest.raises(SceneError, match="jobs = 0: must be at least 1"):
        scene.solve(jobs=0)
    with pytest.raises(SceneError, match="random = -1: must lie between 0"):
        scene.simulate(plan, random=-1)
    with pytest.raises(SceneError, match="friction = 'rough': must be a number"):
        scene.simulate(plan, friction="rough")  # type: ignore[arg-type]
    with pytest.raises(SceneError, match="offsets: has a number that is not finite"):
        scene.simulate(plan, offsets=[[float("nan"), 0, 0]])
    for array in (plan.offsets, plan.turns, plan.states):
        assert not array.flags.writeable


def test_arrays_are_properties_with_help() -> None:
    for name in ("time", "reference", "states", "wrenches", "distances", "forces", "offsets", "turns"):
        assert "shape" in (getattr(Plan, name).__doc__ or ""), name


def test_a_bar_counts(scene: Scene, plan: Plan) -> None:
    pytest.importorskip("tqdm")
    bar = events.bar(disable=True)
    scene.simulate(plan, random=5, progress=bar)
    scene.solve(progress=bar)
