"""Plans: arrays, files, what can be chosen."""

from pathlib import Path

import numpy as np
import pytest
from assembly_plan import NoPlanError, Plan, Reference, Scene, SceneError
from conftest import CORNER, ROOT, command, error_of


def columns(file: Path, first: str, last: str) -> np.ndarray:
    """Columns of a table of numbers, without the names of pairs."""
    header = file.read_text().splitlines()[0].split(",")
    return np.genfromtxt(file, delimiter=",", skip_header=1, usecols=range(header.index(first), header.index(last) + 1))


def test_arrays_are_the_tables(plan: Plan, tmp_path: Path) -> None:
    plan.save(tmp_path / "plan")
    (scenarios, knots, _), (_, _, pairs) = plan.states.shape, plan.forces.shape
    assert (scenarios, pairs) == (len(plan.result["scenarios"]), 2)
    assert plan.time.shape == (knots,) and plan.time_step == plan.result["time_step_s"]
    assert plan.pairs == ("box/floor", "box/wall")
    reference = columns(tmp_path / "plan/reference.csv", "time_s", "wz_rad_s")
    assert np.array_equal(plan.reference, reference[:, 1:]) and np.allclose(plan.time, reference[:, 0])
    states = columns(tmp_path / "plan/scenarios.csv", "px_m", "wz_rad_s")
    assert np.array_equal(plan.states.reshape(-1, 13), states)
    wrenches = columns(tmp_path / "plan/wrench.csv", "fx_n", "tz_nm")
    assert np.array_equal(plan.wrenches.reshape(-1, 6), wrenches)
    contacts = columns(tmp_path / "plan/contacts.csv", "distance_m", "force_n")
    assert np.array_equal(np.stack([plan.distances, plan.forces], axis=-1).reshape(-1, 2), contacts)
    assert np.linalg.norm(plan.reference[:, 3:7], axis=1) == pytest.approx(1.0)


def test_a_plan_says_what_came_of_it(scene: Scene, plan: Plan) -> None:
    assert plan.planned and not plan.done and plan.status == "planned, not tested"
    tested = plan.result["tested"]
    assert {group["friction"] for group in tested["rates"]} == {0.0, 0.1, 0.3} and tested["wall_s"] > 0.0
    errors = np.linalg.norm(plan.states[:, -1, :3] - scene.goal[:3], axis=1)
    assert errors == pytest.approx([scenario["position_error_m"] for scenario in plan.result["scenarios"]])
    assert np.linalg.norm(plan.offsets, axis=1).max() == pytest.approx(scene.offset_magnitude)
    assert not plan.turns.any()
    with pytest.raises(ValueError, match="read-only"):
        plan.reference[0, 0] = 1.0


def test_a_saved_plan_is_read_back_and_read_by_the_command(plan: Plan, tmp_path: Path) -> None:
    folder = tmp_path / "plan"
    plan.save(folder)
    loaded = Plan.load(folder)
    assert loaded.result == plan.result and loaded.resolved == plan.resolved
    for name in ("time", "reference", "states", "wrenches", "distances", "forces"):
        assert np.array_equal(getattr(loaded, name), getattr(plan, name)), name
    assert len(loaded.stages) == len(plan.stages) == len(plan.result["stages"])
    for one, other in zip(loaded.stages, plan.stages, strict=True):
        assert np.array_equal(one.reference, other.reference)
    assert command("simulate", CORNER, folder).returncode == 0
    loaded.save(tmp_path / "copy")
    assert Plan.load(tmp_path / "copy").result == plan.result


def test_a_plan_is_that_of_the_command(plan: Plan, tmp_path: Path) -> None:
    assert command("solve", CORNER, "--out", tmp_path / "plan").returncode == 0
    assert np.array_equal(Plan.load(tmp_path / "plan").reference, plan.reference)


def test_damaged_and_foreign_folders_are_refused(plan: Plan, tmp_path: Path) -> None:
    with pytest.raises(SceneError, match=r"no result\.json in it"):
        Plan.load(tmp_path)
    (tmp_path / "reference.csv").write_text("mine")
    with pytest.raises(SceneError, match="was not written by an earlier run"):
        plan.save(tmp_path)
    folder = tmp_path / "plan"
    plan.save(folder)
    loaded = Plan.load(folder)
    with (folder / "wrench.csv").open("a") as table:
        table.write("\n")
    with pytest.raises(SceneError, match="was changed since the plan was written") as raised:
        Plan.load(folder)
    assert str(raised.value) == error_of("simulate", CORNER, folder)
    with pytest.raises(SceneError, match="was changed since the plan was written"):
        loaded.save(tmp_path / "copy")
    assert not (tmp_path / "copy").exists()


def test_a_plan_is_changed_by_what_is_chosen(scene: Scene) -> None:
    homotopy = {"homotopy": {"iterations": 2, "tau": 0.003}, "ipopt": {"max_iter": 4}}
    plan = scene.solve(start="3", delta=0.002, homotopy=homotopy, linear_solver="mumps", jobs=1)
    result = plan.result
    assert (result["start"], result["delta_m"], result["threads"]) == ("3", 0.002, 1)
    assert result["stages"][0]["tau"] == 0.003 and result["stages"][0]["iterations"] == 4
    assert "mumps" in result["linear_solver"]
    assert not plan.done and not result["converged"] and "homotopy step" in plan.status


def test_a_homotopy_file_is_the_dictionary_of_its_content(scene: Scene, tmp_path: Path) -> None:
    file = tmp_path / "homotopy.toml"
    file.write_text("[homotopy]\niterations = 2\ntau = 0.003\n")
    one = scene.solve(homotopy=file)
    other = scene.solve(homotopy={"homotopy": {"iterations": 2, "tau": 0.003}})
    assert one.resolved == other.resolved and np.array_equal(one.reference, other.reference)


def test_a_folder_is_written_only_whole(scene: Scene, plan: Plan, tmp_path: Path) -> None:
    solved = scene.solve(out=tmp_path / "plan")
    assert solved.result["files"] and Plan.load(tmp_path / "plan").result == solved.result
    assert np.array_equal(solved.reference, plan.reference)
    assert [entry.name for entry in tmp_path.iterdir()] == ["plan"]


def test_a_robust_plan_succeeds_with_hard_contacts(scene: Scene) -> None:
    plan = scene.solve_robust(friction=[0.0, 0.2], target_rate=0.95, time_limit=3600)
    robust = plan.result["robust"]
    assert plan.done and robust["target_rate"] == 0.95
    assert {group["friction"] for group in robust["after"]} == {0.0, 0.2}
    assert scene.simulate(plan, friction=[0.2]).rate() == 1.0


def test_an_earlier_plan_is_moved_to_a_new_start(scene: Scene, tmp_path: Path) -> None:
    plan = scene.solve_robust(friction=0.0, time_limit=3600)
    plan.save(tmp_path / "plan")
    starts = scene.to_dict()["start"]
    starts[0]["position"] = [0.103, 0.002, 0.078]
    measured = scene.replace(start=starts)
    for earlier in (plan, tmp_path / "plan"):
        moved = measured.solve_robust(friction=0.0, from_=earlier, time_limit=3600)
        assert moved.done and moved.result["iterations"] == 0
        assert moved.result["robust"]["rounds"][0]["planned"].startswith("the earlier plan")
        assert moved.reference[0, :3] == pytest.approx([0.103, 0.002, 0.078])
    with pytest.raises(SceneError, match="there is no such folder"):
        measured.solve_robust(from_=tmp_path / "none")


def test_the_optimal_cost_changes_as_its_sensitivities_say(scene: Scene, tmp_path: Path) -> None:
    record = scene.solve().result["stages"][-1]
    end = {"iterations": 1, "coarse_iterations": 0, "tau": record["tau"], "sigma": record["sigma"], "mu_init": 1e-8}
    solved = scene.solve(homotopy={"homotopy": end}, guess=scene.solve())
    found = solved.sensitivities()
    assert len(found) == 3 * len(solved.offsets) + 12
    step = 1e-4
    goal = scene.goal[:3] + np.array([0.0, 0.0, step])
    other = scene.replace(goal__position=goal).solve(homotopy={"homotopy": end}, guess=solved)
    change = other.result["objective"] - solved.result["objective"]
    assert found["goal z"] * step == pytest.approx(change, rel=0.2)
    solved.save(tmp_path / "plan")
    with pytest.raises(SceneError, match="sensitivities: only a plan that was solved in this process has them"):
        Plan.load(tmp_path / "plan").sensitivities()


def test_a_homotopy_starts_from_a_guess(scene: Scene) -> None:
    last = scene.solve().stages[-1]
    record = scene.solve().result["stages"][-1]
    end = {"homotopy": {"iterations": 1, "coarse_iterations": 0, "tau": record["tau"], "sigma": record["sigma"]}}
    cold = scene.solve(homotopy=end)
    warm = scene.solve(homotopy=end, guess=Reference(last.reference, last.time_step))
    assert warm.result["iterations"] < cold.result["iterations"]
    poses = scene.solve(homotopy=end, guess=Reference(last.reference[::2, :7], 2 * last.time_step))
    assert poses.planned and poses.reference.shape == last.reference.shape


def test_a_plan_is_replanned_for_what_was_measured_again(scene: Scene) -> None:
    plan = scene.solve_robust(friction=[0.0, 0.1], target_rate=0.98, time_limit=3600)
    start = scene.starts["1"] + np.array([0.003, 0.002, -0.002, 0.0, 0.0, 0.0, 0.0])
    turned = [np.cos(0.02), 0.0, 0.0, np.sin(0.02)]
    goal = np.array([scene.goal[0] + 0.004, scene.goal[1] + 0.003, scene.goal[2], *turned])
    moved = plan.replan(start=start, goal=goal, offset_magnitude=0.012, time_limit=3600)
    robust = moved.result["robust"]
    assert moved.done and moved.result["iterations"] == 0 and moved.result["delta_m"] == 0.012
    assert robust["rounds"][0]["planned"] == "the earlier plan"
    assert robust["target_rate"] == 0.98 and {row["friction"] for row in robust["after"]} == {0.0, 0.1}
    assert moved.reference[0, :7] == pytest.approx(start)
    end = plan.reference[-1, :3] - scene.goal[:3]
    across = np.array([np.cos(0.04) * end[0] - np.sin(0.04) * end[1], np.sin(0.04) * end[0] + np.cos(0.04) * end[1]])
    assert moved.reference[-1, :2] == pytest.approx(goal[:2] + across, abs=1e-9)
    assert plan.replan(time_limit=3600).reference == pytest.approx(plan.reference, abs=1e-9)
    with pytest.raises(SceneError, match=r"start: has shape \(3,\), must have shape \(7,\)"):
        plan.replan(start=start[:3])
    with pytest.raises(SceneError, match="orientation"):
        plan.replan(goal=[0.0] * 7)


def test_a_scene_that_begins_inside_cannot_be_planned(tmp_path: Path) -> None:
    inside = tmp_path / "inside.toml"
    inside.write_text(CORNER.read_text().replace("position = [0.1, 0.0, 0.08]", "position = [0.1, 0.0, -0.02]", 1))
    with pytest.raises(SceneError) as raised:
        Scene.load(inside).solve()
    assert str(raised.value) == error_of("solve", inside, "--out", tmp_path / "plan")


def test_no_plan_in_time_is_an_error() -> None:
    with pytest.raises(NoPlanError, match="the time limit ended before the first homotopy step"):
        Scene.load(ROOT / "scenes/peg1.toml").solve_robust(time_limit=0.001)
