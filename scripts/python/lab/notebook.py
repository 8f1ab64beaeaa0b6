"""The pages of documentation that commands write or read."""

import pathlib
import sys

from lab.paths import ROOT

# Of what was measured.
FOLDER = ROOT / "docs"
# With a table of faults, and with one of the libraries in the wheel.
PLAYERS, PYTHON = ROOT / "docs/export.md", ROOT / "docs/python.md"


def write(name: str, title: str, text: str) -> None:
    """Writes a page."""
    file = FOLDER / f"{name}.md"
    file.write_text(f"# {title}\n\n{text}")
    said_to(file)


def said_to(place: pathlib.Path) -> None:
    """Says where something is."""
    print(f"written to {place}", file=sys.stderr)
