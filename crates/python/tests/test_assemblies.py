"""`scripts/lab assemblies` on two assemblies: a peg with clearance, and one that is too wide for its groove."""

import json
import pathlib
import shutil
import subprocess
from collections.abc import Sequence

import pytest

LAB = pathlib.Path(__file__).resolve().parents[3] / "scripts/lab"
PROFILE = [(0, 0), (30, 0), (30, 20), (20, 20), (20, 8), (10, 8), (10, 20), (0, 20)]
FACES = [(0, 1, 4, 5), (1, 2, 3, 4), (0, 5, 6, 7)]


def prism(profile: Sequence[tuple[float, float]], faces: Sequence[tuple[int, ...]], low: float, high: float) -> str:
    """OBJ (m) of a profile (mm) in the x-z plane along y, divided into convex faces."""
    count = len(profile)
    corners = [(x, y, z) for y in (low, high) for x, z in profile]
    text = "".join(f"v {1e-3 * x:.6f} {1e-3 * y:.6f} {1e-3 * z:.6f}\n" for x, y, z in corners)
    polygons = [face for face in faces] + [tuple(count + corner for corner in reversed(face)) for face in faces]
    sides = [(at, at + count, (at + 1) % count + count, (at + 1) % count) for at in range(count)]
    for polygon in [*polygons, *sides]:
        text += "f " + " ".join(str(corner + 1) for corner in polygon) + "\n"
    return text


@pytest.fixture
def folder(tmp_path: pathlib.Path) -> pathlib.Path:
    """Two assemblies of a peg that stands in a groove."""
    for name, play in [("loose", 0.2), ("pressed", -0.1)]:
        assembly = tmp_path / "assemblies" / name
        assembly.mkdir(parents=True)
        left, right = 10 + play, 20 - play
        peg = [(left, 8), (right, 8), (right, 30), (left, 30)]
        (assembly / "plug.obj").write_text(prism(peg, [(0, 1, 2, 3)], 2, 18))
        (assembly / "socket.obj").write_text(prism(PROFILE, FACES, 0, 20))
    return tmp_path / "assemblies"


def run(folder: pathlib.Path, program: str) -> subprocess.CompletedProcess[str]:
    """Reads all assemblies."""
    out = folder.parent / "out"
    command: list[str | pathlib.Path] = [LAB, "assemblies", folder, "--only", "read"]
    command += ["--program", program, "--out", out]
    return subprocess.run(command, capture_output=True, text=True, check=False)


def test_assemblies_are_read_once(folder: pathlib.Path) -> None:
    program = shutil.which("assembly-plan")
    assert program is not None
    first = run(folder, program)
    assert first.returncode == 0, first.stderr
    assert "2 assemblies: 1 read, 1 press fit" in first.stdout
    out = folder.parent / "out"
    loose, pressed = (json.loads((out / f"{name}.json").read_text())["read"] for name in ("loose", "pressed"))
    assert loose["pieces"] == [1, 3]
    assert abs(loose["gaps"][0]["given_m"] - 2e-4) < 1e-6
    assert "penetrate by 0.100 mm" in pressed["reason"]
    # What is known is not measured again: this program would fail.
    again = run(folder, "false")
    assert again.returncode == 0, again.stderr
    assert again.stdout == first.stdout


def test_names_that_do_not_exist_are_refused(tmp_path: pathlib.Path) -> None:
    refused = run(tmp_path / "nothing", "false")
    assert refused.returncode == 2
    assert "no folder NAME with plug.obj and socket.obj" in refused.stderr
