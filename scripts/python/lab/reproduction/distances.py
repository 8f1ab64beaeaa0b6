"""Fig. sdfresults: times of the distance kernel; Figs. distancecomp and normalvis: level lines and normals in a
plane."""

import os
import subprocess

import matplotlib.pyplot as plt
import numpy as np

from lab.paths import ROOT
from lab.reproduction import paper, plane, studies
from lab.reproduction.page import COLOURS, Page

STUDIES = ()
TIMES = studies.RUNS / "distance_times.txt"
LEVELS = (-0.4, 0.0, 1.0)
SMOOTHINGS = (0.3, 0.1, 0.03, 0.01)


def cargo(*arguments: str) -> str:
    """What a cargo command prints."""
    command = ["cargo", *arguments]
    environment = os.environ | {"CARGO_TERM_QUIET": "true"}
    return subprocess.run(command, check=True, cwd=ROOT, env=environment, stdout=subprocess.PIPE, text=True).stdout


def run() -> None:
    """Measures what is not there yet."""
    studies.RUNS.mkdir(parents=True, exist_ok=True)
    if not TIMES.exists():
        TIMES.write_text(cargo("bench", "--package", "collision", "--bench", "distance"))


def cube_times() -> list[tuple[str, str, float, float, float]]:
    """Instruction set, tau, and microseconds of values, Jacobian and Hessian, each without the one before."""
    rows = [line.split() for line in TIMES.read_text().splitlines()]
    times = []
    for _, name, tau, values, first, second in (row for row in rows if len(row) == 6 and row[0] == "12"):
        plain, jacobian, hessian = float(values), float(first), float(second)
        times.append((name, tau, plain, jacobian - plain, hessian - jacobian))
    return times


def times_figure(times: list[tuple[str, str, float, float, float]]) -> plt.Figure:
    """Bars of the three parts."""
    drawn, axes = plt.subplots(figsize=(7, 2.6))
    for position, (_, _, *parts) in enumerate(times):
        for index, (label, part) in enumerate(zip(("values", "Jacobian", "Hessian"), parts)):
            axes.bar(
                position + 0.27 * (index - 1), part, 0.25, color=COLOURS[index], label=label if position == 0 else None
            )
    axes.set_xticks(range(len(times)), [f"{name}\n{tau}" for name, tau, *_ in times], fontsize=7)
    axes.set(ylabel="µs per cube pair")
    axes.legend(frameon=False)
    return drawn


def times_section(page: Page) -> str:
    """Times of one pair of cubes."""
    page.heading("Time of one distance (Fig. sdfresults)")
    if not TIMES.exists():
        page.text("Missing: not measured.")
        return "times missing"
    times = cube_times()
    page.text(
        """Two cubes of 0.1 m, 1000 random poses and seeds, one thread; mean processor time (`cargo bench -p collision`,
        which does not count waiting for a processor that others use), for the widest SIMD instructions of the processor
        and for narrower ones. A Jacobian costs what is shown on top of the values, a Hessian on top of the Jacobian.
        `scalar` costs more than eight lanes of AVX-512 together explain; calls of a library for multiply-adds that are
        rounded once are suspected, which was not examined. On the busy machine figures vary by a quarter or so between
        runs."""
    )
    page.figure("times", times_figure(times), "Microseconds per pair by instructions and tau.")
    page.table(
        ["instructions", "tau", "values µs", "Jacobian µs", "Hessian µs"],
        ([name, tau, *(f"{part:.2f}" for part in parts)] for name, tau, *parts in times),
    )
    words = paper.DISTANCE_US
    page.text(
        f"""Paper: values {words["values"]} µs, Jacobian {words["Jacobian"]}, Hessian {words["Hessian"]}; the figure is
        not given as numbers. The paper evaluates one pose at a time, here a batch fills the lanes."""
    )
    _, tau, *parts = times[0]
    return (
        f"cube and cube, tau {tau}: {parts[0]:.2f} + {parts[1]:.2f} + {parts[2]:.2f} µs for values, Jacobian, Hessian"
    )


def grid(columns: int, rows: int) -> np.ndarray:
    """Points around the rectangle."""
    return np.stack(np.meshgrid(np.linspace(-2.5, 2.5, columns), np.linspace(-2, 2, rows)), axis=-1)


def rectangle(axes: plt.Axes) -> None:
    """Draws the shape."""
    corner = (-plane.HALF_WIDTH, -plane.HALF_HEIGHT)
    axes.add_patch(plt.Rectangle(corner, 2 * plane.HALF_WIDTH, 2 * plane.HALF_HEIGHT, color="0.88", zorder=0))
    axes.set_aspect("equal")


def levels_figure() -> plt.Figure:
    """Left: three exact distances. Right: the smoothed one for several tau."""
    drawn, (left, right) = plt.subplots(1, 2, figsize=(9, 3.6), sharey=True)
    points = grid(501, 401)
    exact = {
        "Euclidean": plane.euclidean(points),
        "scaled (earlier work)": plane.scaling(points),
        "this one, exact": plane.exact(points),
    }
    smoothed = {f"tau = {tau}": plane.smoothed(points, tau).distance for tau in SMOOTHINGS}
    for axes, curves in ((left, exact), (right, smoothed)):
        rectangle(axes)
        for colour, style, (label, values) in zip(COLOURS, ("-", "-", "--", ":"), curves.items()):
            axes.contour(
                points[..., 0], points[..., 1], values, levels=LEVELS, colors=colour, linestyles=style, linewidths=1.2
            )
            axes.plot([], [], color=colour, linestyle=style, label=label)
        axes.legend(frameon=False, fontsize=7, loc="upper center", ncols=2, bbox_to_anchor=(0.5, 1.15))
    return drawn


def normals_figure() -> plt.Figure:
    """Gradient and normal for every tau."""
    drawn, panels = plt.subplots(2, 2, figsize=(9, 7), sharex=True, sharey=True)
    points = grid(14, 12)
    for axes, tau in zip(panels.flat, SMOOTHINGS):
        rectangle(axes)
        field = plane.smoothed(points, tau)
        for colour, width, label, arrows in (
            (COLOURS[0], 0.008, "gradient", field.gradient),
            (COLOURS[1], 0.004, "approximate normal", field.normal),
        ):
            axes.quiver(
                *np.moveaxis(points, -1, 0), *np.moveaxis(arrows, -1, 0),
                color=colour, scale=3.5, scale_units="x", width=width, label=label,
            )  # fmt: skip
        axes.set_title(f"tau = {tau}", fontsize=8)
    panels[1][0].legend(frameon=False, fontsize=8, loc="upper left", bbox_to_anchor=(0, -0.08), ncols=2)
    return drawn


def plane_section(page: Page) -> str:
    """Level lines and normals."""
    page.heading("Level lines and normals (Figs. distancecomp and normalvis)")
    page.text(
        """The paper's example is the distance of a point and a rectangle in the plane, the point itself not growing.
        The product knows only solids that both grow, so these figures come from the example's own equation, solved in
        `scripts/python/lab/reproduction/plane.py`; the solids are tested against independent data in
        `crates/collision`. Levels are the paper's; its rectangle and its four values of tau are not given as
        numbers."""
    )
    page.figure(
        "levels", levels_figure(), "Levels 1, 0, -0.4 of the distance. Left: without smoothing. Right: smoothed."
    )
    page.figure("normals", normals_figure(), "Gradient of the smoothed distance and the approximate normal n_tau.")
    points = grid(101, 81)
    rows = []
    for tau in SMOOTHINGS:
        field = plane.smoothed(points, tau)
        apart = np.linalg.norm(field.gradient - field.normal, axis=-1)
        norms = np.linalg.norm(field.normal, axis=-1)
        rows.append([tau, *(f"{number:.3f}" for number in (apart.max(), np.median(apart), np.median(norms)))])
    page.table(["tau", "largest distance of gradient and normal", "median", "median norm of the normal"], rows)
    exact, euclidean = plane.exact(points), plane.euclidean(points)
    inside = np.abs(exact - euclidean)[exact < 0].max()
    page.text(
        f"""As the paper says, the exact distance is the Euclidean one for negative values (largest difference
        {inside:.0e}) and 0-levels coincide, and normal and gradient agree more and more as tau shrinks. Where the
        nearest side changes the exact distance has a kink; there they differ at any tau, in a strip that gets
        thinner."""
    )
    (first, _, large, _), (last, _, small, _) = rows[0], rows[-1]
    return f"normal and gradient differ by {large} (median) at tau {first} and by {small} at tau {last}"


def render(page: Page) -> str:
    """Writes the page; the result in a sentence."""
    return "; ".join((times_section(page), plane_section(page)))
