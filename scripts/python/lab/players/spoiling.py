"""What happens to the files of an export."""

import json
import pathlib
import re
import shutil
from collections.abc import Callable
from typing import Any

from lab.players.seal import seal

RECORDED = pathlib.Path(__file__).resolve().parent / "recorded"


def edited(change: Callable[[Any], None], sealed: bool = False) -> Callable[[pathlib.Path], None]:
    """Changes plan.json."""

    def spoil(folder: pathlib.Path) -> None:
        file = folder / "plan.json"
        document = json.loads(file.read_text())
        change(document)
        file.write_text(json.dumps(document))
        if sealed:
            seal(folder)

    return spoil


def stiffer(document: Any) -> None:
    """Ten times the stiffness."""
    document["tool_stiffness"] = [[10 * value for value in row] for row in document["tool_stiffness"]]
    document["impedance"]["translational_stiffness"] *= 10


def no_number(document: Any) -> None:
    """A guard that nothing is beyond."""
    document["guards"]["insertion"]["force_n"] = float("nan")


def narrow(folder: pathlib.Path) -> None:
    """Something stands 20 mm from a link at the start, in the way of the test of the frames."""

    def stand(document: Any) -> None:
        for start in document["free"]["arm_starts"]:
            start["clearance_m"], start["test_is_free"] = 0.02, False

    edited(stand, sealed=True)(folder)
    script = folder / "plan.script"
    if script.exists():
        text = re.sub(r"global arm_clearances = .*", lambda found: found[0].replace("0.3", "0.02"), script.read_text())
        script.write_text(re.sub(r"global test_is_free = .*", lambda found: found[0].replace("True", "False"), text))


def older(document: Any) -> None:
    """An export of another version."""
    document["format"] = 1


def rows(change: Callable[[list[str]], list[str]], sealed: bool = True) -> Callable[[pathlib.Path], None]:
    """Changes the rows of trajectory.csv."""

    def spoil(folder: pathlib.Path) -> None:
        file = folder / "trajectory.csv"
        header, *lines = file.read_text().splitlines()
        file.write_text("\n".join([header, *change(lines)]) + "\n")
        if sealed:
            seal(folder)

    return spoil


def moved(lines: list[str]) -> list[str]:
    """A jump of 20 mm."""
    half = len(lines) // 2
    cells = [line.split(",") for line in lines]
    return [",".join([c[0], str(float(c[1]) + 0.02 * (index > half)), *c[2:]]) for index, c in enumerate(cells)]


def flipped(lines: list[str]) -> list[str]:
    """The sign of the quaternion changes."""
    half = len(lines) // 2
    cells = [line.split(",") for line in lines]
    turned = [[str(-float(cell)) for cell in c[4:8]] if index > half else c[4:8] for index, c in enumerate(cells)]
    return [",".join([*c[:4], *q, *c[8:]]) for c, q in zip(cells, turned)]


def longer(lines: list[str]) -> list[str]:
    """A quaternion that is not of unit norm."""
    cells = [line.split(",") for line in lines]
    return [",".join([*c[:4], *(str(1.1 * float(cell)) for cell in c[4:8]), *c[8:]]) for c in cells]


def backwards(lines: list[str]) -> list[str]:
    """Times that decrease."""
    return lines[::-1]


def foreign(name: str) -> Callable[[pathlib.Path], None]:
    """The trajectory of another plan."""
    return lambda folder: shutil.copy(RECORDED / name / "trajectory.csv", folder) and None


def lost(name: str) -> Callable[[pathlib.Path], None]:
    """A file that is missing."""
    return lambda folder: (folder / name).unlink()


def changed_player(folder: pathlib.Path) -> None:
    """A guard that was taken out of the player."""
    file = folder / "guards.py"
    file.write_text(file.read_text().replace("LONGEST_GAP = 0.1", "LONGEST_GAP = 10.0"))


def unsealed_player(folder: pathlib.Path) -> None:
    """A guard that was taken out, and the line of the seal that would tell."""
    changed_player(folder)
    sums = folder / "SHA256SUMS"
    sums.write_text("".join(line for line in sums.read_text().splitlines(True) if "guards.py" not in line))


def foreign_module(folder: pathlib.Path) -> None:
    """A module that the player would import instead of Python's own."""
    (folder / "csv.py").write_text("from _csv import *\nclass DictReader(list): ...\n")


def existing_log(folder: pathlib.Path) -> None:
    """A log of an earlier run."""
    (folder / "executed.csv").write_text("mine\n")
