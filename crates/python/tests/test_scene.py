"""Scenes: reading, wrong input, what is known before solving."""

import json
import math
import tomllib
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from assembly_plan import PlannerError, Scene, SceneError
from conftest import CORNER, command, error_of


def content() -> dict[str, Any]:
    return tomllib.loads(CORNER.read_text())


def test_a_scene_has_what_its_file_says(scene: Scene) -> None:
    assert scene.title == "corner"
    assert list(scene.starts) == ["1", "2", "3"]
    assert scene.starts["1"][:3].tolist() == [0.1, 0.0, 0.08]
    assert scene.goal.tolist() == [0.051, 0.0, 0.031, 1.0, 0.0, 0.0, 0.0]
    assert [part.name for part in scene.environment] == ["floor", "wall"]
    box = scene.body[0]
    assert box.vertices.shape == (8, 3)
    assert np.ptp(box.vertices, axis=0) == pytest.approx([0.1, 0.08, 0.06])
    assert (box.normals @ box.vertices.T <= box.offsets[:, None] + 1e-12).all()
    with pytest.raises(ValueError, match="read-only"):
        scene.goal[0] = 1.0


def test_a_dictionary_is_a_scene_file(scene: Scene) -> None:
    given = content()
    given["body"]["inertia"] = np.diag([0.1, 0.1, 0.1])
    given["goal"]["position"] = tuple(given["goal"]["position"])
    given["robustness"]["offset_magnitude"] = np.float64(given["robustness"]["offset_magnitude"])
    made = Scene.from_dict(given)
    assert made.check() == scene.check()


def test_files_of_a_dictionary_are_relative_to_its_base(tmp_path: Path) -> None:
    given = content()
    given["homotopy"] = Path("other.toml")
    (tmp_path / "other.toml").write_text("[homotopy]\ntau = 0.0031\n")
    assert Scene.from_dict(given, base=tmp_path).solve().result["stages"][0]["tau"] == 0.0031
    with pytest.raises(SceneError, match=r"other\.toml cannot be read: there is no such file"):
        Scene.from_dict(given, base=tmp_path / "elsewhere")


def test_errors_are_those_of_the_command_line(tmp_path: Path) -> None:
    wrong = tmp_path / "wrong.toml"
    text = CORNER.read_text()
    for old, new in [
        ("mass = 1.0", "mass = -1.0"),
        ("mass = 1.0", "masss = 1.0"),
        ("[goal]", "[gaol]"),
        ('name = "floor"', 'name = "wall"'),
        ("title", "= title"),
    ]:
        wrong.write_text(text.replace(old, new, 1))
        with pytest.raises(SceneError) as raised:
            Scene.load(wrong)
        assert str(raised.value) == error_of("check", wrong)
    with pytest.raises(SceneError) as raised:
        Scene.load(tmp_path / "missing.toml")
    assert str(raised.value) == error_of("check", tmp_path / "missing.toml")
    assert isinstance(raised.value, PlannerError) and isinstance(raised.value, ValueError)


def test_errors_of_a_dictionary_show_its_lines() -> None:
    given = content()
    given["body"]["mass"] = -1
    with pytest.raises(SceneError, match=r"(?s)^scene:\d+:\d+: .*mass = -1"):
        Scene.from_dict(given)


@pytest.mark.parametrize(
    ("value", "message"),
    [
        (None, r"^body\.mass: None is no value; leave the key out$"),
        (math.nan, r"^body\.mass: nan must be a finite number$"),
        (1j, r"^body\.mass: a complex is no value"),
        ({1: 2}, r"^body\.mass: the key 1 is no text$"),
        (2**80, r"body\.mass = 1208925819614629200000000\.0: must lie between"),
    ],
)
def test_values_that_no_file_has_are_refused(value: object, message: str) -> None:
    given = content()
    given["body"]["mass"] = value
    with pytest.raises(SceneError, match=message):
        Scene.from_dict(given)


def test_what_is_no_dictionary_is_refused(scene: Scene) -> None:
    with pytest.raises(SceneError, match="a list is no dictionary"):
        Scene.from_dict([])  # type: ignore[arg-type]
    with pytest.raises(SceneError, match="a int is no dictionary"):
        scene.check(homotopy=3)  # type: ignore[arg-type]


def test_checks_are_those_of_the_command_line(scene: Scene) -> None:
    assert scene.check(start="2", delta=0.01) == json.loads(
        command("check", CORNER, "--start", "2", "--delta", 0.01, "--json").stdout
    )
    pose = "0.06 0 0.04 2 0 0 0"
    shown = json.loads(command("check", CORNER, "--pose", pose, "--tau", 0.001, "--json").stdout)
    assert scene.distances([float(word) for word in pose.split()], tau=0.001) == shown
    assert {pair["environment"] for pair in shown} == {"floor", "wall"}


def test_choices_that_are_wrong_are_refused(scene: Scene) -> None:
    with pytest.raises(SceneError) as raised:
        scene.check(start="4")
    assert str(raised.value) == error_of("check", CORNER, "--start", "4")
    with pytest.raises(SceneError) as raised:
        scene.check(delta=-1.0)
    assert str(raised.value) == error_of("check", CORNER, "--delta", -1.0)
    with pytest.raises(SceneError, match="tau = 2: must lie between"):
        scene.check(tau=2.0)
    with pytest.raises(SceneError, match=r"pose: has shape \(3,\), must have shape \(7,\)"):
        scene.distances([0.0, 0.0, 0.0])
    with pytest.raises(SceneError, match="quaternion that is not zero"):
        scene.distances([0.0] * 7)
    with pytest.raises(SceneError, match="resume: needs out"):
        scene.solve(resume=True)
    with pytest.raises(SceneError, match="unknown; choose one of"):
        scene.solve(linear_solver="pardiso")
    with pytest.raises(SceneError, match=r"jobs = 0: must be at least 1"):
        scene.solve(jobs=0)
    with pytest.raises(SceneError, match=r"homotopy:\d+:\d+: .*tau_rate"):
        scene.solve(homotopy={"homotopy": {"tau_rate": 1.2}})
    with pytest.raises(SceneError, match="`9`"):
        scene.solve(start=9)
    with pytest.raises(SceneError, match="time_limit = -1: must lie between"):
        scene.solve_robust(time_limit=-1.0)
