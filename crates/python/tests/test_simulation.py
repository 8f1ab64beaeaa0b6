"""Simulations: rollouts, tables, wrong input."""

import tomllib
from pathlib import Path

import numpy as np
import pytest
from assembly_plan import Plan, Scene, SceneError, SceneWarning
from conftest import CORNER, PEG, command


def test_rollouts_are_those_of_the_command(scene: Scene, plan: Plan, tmp_path: Path) -> None:
    plan.save(tmp_path / "plan")
    options = ["--random", 7, "--seed", 3, "--magnitude", "0.005,0.01", "--friction", "0,0.3", "--rotation-error", 0.02]
    run = command("simulate", CORNER, tmp_path / "plan", *options, "--out", tmp_path / "command")
    assert run.returncode == 0
    played = scene.simulate(
        Plan.load(tmp_path / "plan"),
        random=7,
        seed=3,
        magnitude=[0.005, 0.01],
        friction=[0.0, 0.3],
        rotation_error=0.02,
    )
    played.save(tmp_path / "python")
    for table in ("rollouts.csv", "success.csv"):
        assert (tmp_path / "python" / table).read_text() == (tmp_path / "command" / table).read_text()
    assert str(played) in run.stdout


def test_columns_are_the_rollouts(scene: Scene, plan: Plan) -> None:
    offsets = np.array([[0.001, 0.0, 0.0], [0.0, 0.002, 0.0]])
    played = scene.simulate(plan, offsets=offsets, stages=True)
    rollouts = played.rollouts
    of_plan = rollouts["motion"] == "plan"
    assert np.array_equal(np.stack([rollouts[name][of_plan] for name in ("x_m", "y_m", "z_m")], axis=1), offsets)
    stages = {f"stage {number + 1}" for number in range(len(plan.stages))}
    assert set(rollouts["motion"]) == {"plan", "straight push"} | stages
    assert played.rate() == rollouts["success"][of_plan].mean() == 1.0
    assert played.successes["rollouts"].sum() == len(rollouts["success"])
    assert "Simulation: " in repr(played)
    with pytest.raises(ValueError, match="choose one of stage 1, "):
        played.rate("stage 99")


def test_every_source_of_offsets_is_played(scene: Scene, plan: Plan) -> None:
    count = len(plan.offsets)
    assert len(scene.simulate(plan).rollouts["success"]) == 2 * count
    for played in (
        scene.simulate(plan, random=5),
        scene.simulate(plan, random=5, hull=True),
        scene.simulate(plan, random=5, disc=True),
        scene.simulate(plan, random=5, ball=True),
    ):
        assert len(played.rollouts["success"]) == 10
    assert len(scene.simulate(plan, grid=2).rollouts["success"]) > 2 * count


def test_random_offsets_are_those_that_the_scene_covers(tmp_path: Path) -> None:
    given = tomllib.loads(CORNER.read_text())
    del given["robustness"]["offset_directions"]
    given["robustness"] |= {"offset_magnitude": 0.002, "coverage": "disc", "insertion_axis": [0.0, 1.0, 0.0]}
    scene = Scene.from_dict(given)
    plan = scene.solve()
    plan.save(tmp_path / "plan")
    played = scene.simulate(plan, random=21, seed=4).rollouts
    offsets = np.stack([played[name] for name in ("x_m", "y_m", "z_m")], axis=1)[played["motion"] == "plan"]
    lengths = np.linalg.norm(offsets, axis=1)
    assert np.allclose(lengths[:11], 0.002) and (lengths[11:] < 0.002).all()
    assert (np.abs(offsets[:, 1]) < 1e-12).all()
    same = scene.simulate(plan, random=21, seed=4, disc=True).rollouts
    assert all(np.array_equal(column, same[name]) for name, column in played.items())
    assert len(plan.offsets) == 6


def test_wrong_requests_are_refused(scene: Scene, plan: Plan) -> None:
    for options, message in [
        ({"random": 0}, "number of offsets = 0: must lie between 1 and 1000000"),
        ({"random": 2, "grid": 2}, "offsets: at most one of random, grid and offsets"),
        ({"ball": True}, "ball: needs random"),
        ({"random": 2, "ball": True, "disc": True}, "random: give at most one of hull, disc and ball"),
        ({"offsets": [[0.0, 0.0]]}, r"offsets: has shape \(1, 2\)"),
        ({"offsets": [[0.0, 0.0, 0.0]], "magnitude": [0.01]}, "magnitude: does not scale"),
        ({"friction": [-0.5]}, "friction = -0.5: must lie between 0 and 10"),
        ({"friction": []}, "number of frictions = 0: must be 1 to 20"),
        ({"time_step": 10.0}, "time_step = 10 s"),
        ({"magnitude": [0.01, 0.01]}, "magnitude = 0.01: is given twice"),
    ]:
        with pytest.raises(SceneError, match=message):
            scene.simulate(plan, **options)  # type: ignore[arg-type]


def test_a_plan_of_another_scene_is_refused(plan: Plan, tmp_path: Path) -> None:
    with pytest.raises(SceneError, match="plan: it was made for another scene"):
        Scene.load(PEG).simulate(plan, position_tolerance=0.01)
    plan.save(tmp_path / "plan")
    with pytest.raises(
        SceneError, match="the plan was made for another scene: part `box` of its body is not part `shaft`"
    ):
        Scene.load(PEG).simulate(Plan.load(tmp_path / "plan"))


def test_a_plan_of_other_settings_is_a_warning(plan: Plan) -> None:
    given = tomllib.loads(CORNER.read_text())
    given["impedance"]["translational_stiffness"] = 60.0
    with pytest.warns(SceneWarning, match="plan: the plan was made with other settings than scene has") as caught:
        Scene.from_dict(given).simulate(plan)
    assert {Path(warning.filename).name for warning in caught} == {"test_simulation.py"}


def test_nothing_of_others_is_replaced(scene: Scene, plan: Plan, tmp_path: Path) -> None:
    (tmp_path / "success.csv").write_text("my,own,table\n")
    with pytest.raises(SceneError, match="exists and is not"):
        scene.simulate(plan).save(tmp_path)
