"""Tables in CSV and Markdown."""

import csv
import pathlib
from collections.abc import Iterable, Sequence

Row = dict[str, str]


def read(path: pathlib.Path) -> list[Row]:
    """The rows of a CSV file by the names of its columns."""
    with path.open(newline="") as file:
        return list(csv.DictReader(file))


def write(path: pathlib.Path, header: Sequence[str], rows: Iterable[Sequence[object]]) -> None:
    """Writes a CSV file."""
    with path.open("w", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(header)
        writer.writerows(rows)


def line(cells: Iterable[object]) -> str:
    """A line of a Markdown table."""
    return "| " + " | ".join(map(str, cells)) + " |"


def head(cells: Sequence[str]) -> str:
    """The first two lines of a Markdown table."""
    return f"{line(cells)}\n{'|---' * len(cells)}|"


def markdown(cells: Sequence[str], rows: Iterable[Iterable[object]]) -> str:
    """A Markdown table."""
    return "\n".join([head(cells), *map(line, rows)])


def successes(rows: list[Row], motion: str, friction: str) -> str:
    """Successes of some motions in a table of `validate`, of how many."""
    chosen = [row["success"] == "1" for row in rows if (row["motion"], row["friction"]) == (motion, friction)]
    return f"{sum(chosen)}/{len(chosen)}"


def rates(robust: dict) -> str:
    """Success in own rollouts before and after refinement (%), from the record of a robust plan."""
    shown = f"{100 * robust['rate_before']:.1f} -> {100 * robust['rate_after']:.1f}"
    return shown if robust["reached"] else f"{shown} (short)"
