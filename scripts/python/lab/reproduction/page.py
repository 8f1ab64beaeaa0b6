"""Markdown pages and their figures."""

import pathlib
from collections.abc import Iterable, Sequence

import matplotlib

matplotlib.use("svg")
import matplotlib.pyplot as plt
from matplotlib.figure import Figure

from lab import tables

# The same data give the same file.
matplotlib.rcParams["svg.hashsalt"] = "reproduction"
matplotlib.rcParams["font.size"] = 9
matplotlib.rcParams["axes.spines.top"] = False
matplotlib.rcParams["axes.spines.right"] = False

COLOURS = ("#0072b2", "#e69f00", "#009e73", "#d55e00", "#56b4e9", "#cc79a7")


class Page:
    """A Markdown page in a folder, written when it is whole."""

    def __init__(self, folder: pathlib.Path, name: str, title: str) -> None:
        self.folder = folder
        self.name = name
        self.title = title
        self.lines = [f"# {title}", ""]

    def text(self, *paragraphs: str) -> None:
        """Adds paragraphs."""
        for paragraph in paragraphs:
            self.lines += [" ".join(paragraph.split()), ""]

    def heading(self, text: str) -> None:
        """Adds a heading."""
        self.lines += [f"## {text}", ""]

    def table(self, columns: Sequence[str], rows: Iterable[Sequence[object]]) -> None:
        """Adds a table."""
        self.lines += [tables.markdown(columns, rows), ""]

    def figure(self, name: str, figure: Figure, caption: str) -> None:
        """Saves a figure beside the page and shows it."""
        file = f"{self.name}_{name}"
        figure.savefig(self.folder / f"{file}.svg", metadata={"Date": None, "Creator": None}, bbox_inches="tight")
        plt.close(figure)
        self.lines += [f"![{caption}]({file}.svg)", ""]
        self.text(f"*{caption}*")

    def write(self) -> None:
        """Writes the page."""
        (self.folder / f"{self.name}.md").write_text("\n".join(self.lines).rstrip() + "\n")


def mean(numbers: Iterable[float]) -> float:
    """Mean; not a number for none."""
    numbers = list(numbers)
    return sum(numbers) / len(numbers) if numbers else float("nan")
