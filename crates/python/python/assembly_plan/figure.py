"""Figures of plans."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from assembly_plan._values import StrPath


@dataclass(frozen=True)
class Figure:
    """A drawing (SVG), which a notebook shows where it is the result of a cell."""

    name: str
    svg: str

    def save(self, file: StrPath) -> None:
        """Write it into an SVG file."""
        Path(file).write_text(self.svg, encoding="utf-8")

    def _repr_svg_(self) -> str:
        return self.svg

    def __repr__(self) -> str:
        return f"<Figure {self.name!r}>"
