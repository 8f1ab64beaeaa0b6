"""The pages of documentation that commands write or read."""

import datetime
import pathlib
import sys

from lab.paths import ROOT

# Of what was measured: the notebook.
FOLDER = ROOT / "docs/experiments"
# With a table of faults, and with one of the libraries in the wheel.
PLAYERS, PYTHON = ROOT / "docs/reference/players.md", ROOT / "docs/reference/python.md"


def date() -> str:
    """The line that says when a page was written."""
    return f"*Lab notebook, written on {datetime.date.today().isoformat()}.*"


def write(name: str, title: str, text: str) -> None:
    """Writes a page."""
    file = FOLDER / f"{name}.md"
    file.write_text(f"# {title}\n\n{date()}\n\n{text}")
    said_to(file)


def said_to(place: pathlib.Path) -> None:
    """Says where something is."""
    print(f"written to {place}", file=sys.stderr)
