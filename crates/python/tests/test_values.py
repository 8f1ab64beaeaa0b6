"""Scenes and plans as values: copied, pickled, compared, changed, shown."""

import copy
import pickle
from concurrent.futures import ProcessPoolExecutor
from pathlib import Path
from typing import Any

import assembly_plan
import numpy as np
import pytest
from assembly_plan import Plan, Scene, SceneError
from conftest import CORNER


def objective(scene: Scene) -> float:
    return float(scene.solve(jobs=1).result["objective"])


def test_scenes_are_copied_pickled_and_compared(scene: Scene) -> None:
    again = pickle.loads(pickle.dumps(scene))
    assert again == scene and hash(again) == hash(scene) and again is not scene
    assert again.starts.keys() == scene.starts.keys()
    assert all(np.array_equal(again.starts[name], scene.starts[name]) for name in scene.starts)
    assert copy.copy(scene) is scene and copy.deepcopy([scene])[0] == scene
    assert Scene.load(CORNER) == scene and scene != scene.replace(title="other") and scene != "corner"


def test_a_scene_is_a_dictionary_that_can_be_changed(scene: Scene) -> None:
    content = scene.to_dict()
    assert Scene.from_dict(content) == scene and [start["name"] for start in content["start"]] == list(scene.starts)
    smaller = scene.replace(robustness__offset_magnitude=0.01, title="smaller")
    assert (smaller.title, smaller.offset_magnitude, scene.offset_magnitude) == ("smaller", 0.01, 0.02)
    assert scene.replace(limits={"contact_force": 30.0}).to_dict()["limits"]["contact_force"] == 30.0
    with pytest.raises(SceneError, match="unknown key"):
        scene.replace(robustness__offset=0.01)
    with pytest.raises(SceneError, match="is no table"):
        scene.replace(title__text="x")


def test_processes_take_scenes_and_return_plans(scene: Scene, plan: Plan) -> None:
    with ProcessPoolExecutor(2) as pool:
        objectives = list(pool.map(objective, [scene, scene.replace(robustness__offset_magnitude=0.01)]))
    assert objectives[0] == plan.result["objective"] != objectives[1]
    again = pickle.loads(pickle.dumps(plan))
    assert again == plan and hash(again) == hash(plan) and copy.deepcopy(plan) is plan
    assert again.status == plan.status and len(again.stages) == len(plan.stages)
    assert np.array_equal(again.stages[0].reference, plan.stages[0].reference)
    twice = pickle.loads(pickle.dumps(again))
    assert twice == plan and plan != scene.solve(delta=0.01)


def test_numbers_stand_for_names_and_lists(scene: Scene, plan: Plan) -> None:
    assert scene.check(start=2)["start"] == scene.check(start="2")["start"]
    alone = scene.simulate(plan, friction=0.1, magnitude=0.01)
    listed = scene.simulate(plan, friction=[0.1], magnitude=(0.01,))
    assert np.array_equal(alone.rollouts["position_error_m"], listed.rollouts["position_error_m"])
    assert scene.simulate(plan, friction=np.float64(0.1)).successes["friction"].tolist() == [0.1, 0.1]


def test_a_plan_is_shown(plan: Plan, tmp_path: Path) -> None:
    plan.report(tmp_path / "page.html")
    page = (tmp_path / "page.html").read_text()
    assert page.lower().startswith("<!doctype html>") and "corner" in page
    for name in ("moving.svg", "moving.gif"):
        plan.animate(tmp_path / name)
        everything = (tmp_path / name).stat().st_size
        plan.animate(tmp_path / name, scenario=1)
        assert 1000 < (tmp_path / name).stat().st_size < everything, "one scenario takes less than all"
    with pytest.raises(assembly_plan.SceneError, match=r"neither \.svg nor \.gif"):
        plan.animate(tmp_path / "moving.mp4")
    with pytest.raises(assembly_plan.SceneError, match="must be from 1 to"):
        plan.animate(tmp_path / "moving.svg", scenario=99)
    shown = plan._repr_html_()
    assert shown.startswith("<iframe srcdoc=") and "corner" in shown
    matplotlib = pytest.importorskip("matplotlib")
    matplotlib.use("Agg")
    axes = plan.plot()
    assert [axis.get_ylabel() for axis in axes] == ["x (mm)", "y (mm)", "z (mm)"]
    lines = axes[0].get_lines()
    assert len(lines) == 1 + len(plan.states) and np.array_equal(lines[0].get_ydata(), 1e3 * plan.reference[:, 0])


def test_tolerances_are_those_of_the_command(scene: Scene, plan: Plan) -> None:
    asked: Any = {"target_rate": 0.8, "cases": 40, "position_tolerance": 0.006, "friction": [0.0, 0.1]}
    measured = scene.tolerance(
        plan, quantities=["offset"], need=("offset", 0.001), map=("offset", "friction"), rows=[0.0], **asked
    )
    offset = measured["boundaries"][0]
    assert offset["quantity"] == "offset" and offset["value"] > 0.0
    assert offset["successes"] >= 0.8 * offset["rollouts"]
    assert measured["map"]["rows"][0]["at"] == 0.0 and measured["need"]["quantity"] == "offset"
    assert scene.tolerance(plan, quantities=["offset"], jobs=1, **asked)["boundaries"][0] == offset
    with pytest.raises(SceneError, match="choose one of offset, rotation, hole, friction, clearance, chamfer"):
        scene.tolerance(plan, quantities=["size"])
    with pytest.raises(SceneError, match="by = friction: unknown; choose clearance or chamfer"):
        scene.tolerance(plan, need=("offset", 0.001), by="friction")
    with pytest.raises(SceneError, match="chamfer: the hole cannot be given a chamfer"):
        scene.tolerance(plan, quantities=["chamfer"])


def test_the_version_is_that_of_the_program(plan: Plan) -> None:
    assert plan.result["versions"]["assembly_plan"] == assembly_plan.__version__
