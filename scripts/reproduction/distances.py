"""Fig. sdfresults: times of the distance kernel; Figs. distancecomp and normalvis: level lines and normals in a plane."""

import csv
import os
import subprocess

import matplotlib.pyplot as plt
import numpy as np

import paper
import studies
from page import COLOURS, Page

STUDIES = ()
TIMES = studies.RUNS / "distance_times.txt"
PLANE = studies.RUNS / "planar_distances.csv"
LEVELS = (-0.4, 0.0, 1.0)
HALF_WIDTH, HALF_HEIGHT = 1.0, 0.5


def cargo(*arguments: str) -> str:
    """What a cargo command prints."""
    command = ["cargo", *arguments]
    environment = os.environ | {"CARGO_TERM_QUIET": "true"}
    return subprocess.run(command, check=True, cwd=studies.ROOT, env=environment, stdout=subprocess.PIPE, text=True).stdout


def run() -> None:
    """Measures and computes what is not there yet."""
    studies.RUNS.mkdir(parents=True, exist_ok=True)
    if not TIMES.exists():
        TIMES.write_text(cargo("bench", "--package", "collision", "--bench", "distance"))
    if not PLANE.exists():
        PLANE.write_text(cargo("run", "--release", "--package", "collision", "--example", "planar_distances"))


def cube_times() -> list[tuple[str, str, float, float, float]]:
    """Instruction set, tau, and microseconds of values, Jacobian and Hessian, each without the one before."""
    rows = [line.split() for line in TIMES.read_text().splitlines()]
    times = []
    for rows_count, name, tau, values, first, second in (row for row in rows if len(row) == 6 and row[0] == "12"):
        plain, jacobian, hessian = float(values), float(first), float(second)
        times.append((name, tau, plain, jacobian - plain, hessian - jacobian))
    return times


def times_figure(times: list[tuple[str, str, float, float, float]]) -> plt.Figure:
    """Bars of the three parts."""
    drawn, axes = plt.subplots(figsize=(7, 2.6))
    for position, (name, tau, *parts) in enumerate(times):
        for index, (label, part) in enumerate(zip(("values", "Jacobian", "Hessian"), parts)):
            axes.bar(position + 0.27 * (index - 1), part, 0.25, color=COLOURS[index], label=label if position == 0 else None)
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
        """Two cubes of 0.1 m, 1000 random poses and seeds, one thread; medians of repeated batches (`cargo bench -p
        collision`), for the widest SIMD instructions of the processor and for narrower ones. A Jacobian costs what is
        shown on top of the values, a Hessian on top of the Jacobian."""
    )
    page.figure("times", times_figure(times), "Microseconds per pair by instructions and tau.")
    page.table(
        ["instructions", "tau", "values µs", "Jacobian µs", "Hessian µs"],
        ([name, tau, *(f"{part:.2f}" for part in parts)] for name, tau, *parts in times),
    )
    words = paper.DISTANCE_US
    page.text(
        f"""Paper: values {words['values']} µs, Jacobian {words['Jacobian']}, Hessian {words['Hessian']}; the figure is not
        given as numbers. The paper evaluates one pose at a time, here a batch fills the lanes."""
    )
    name, tau, *parts = times[0]
    return f"cube and cube, tau {tau}: {parts[0]:.2f} + {parts[1]:.2f} + {parts[2]:.2f} µs for values, Jacobian, Hessian"


def plane() -> dict[float, dict[str, np.ndarray]]:
    """Fields on the grid by tau."""
    with PLANE.open() as file:
        records = [{key: float(value) for key, value in record.items()} for record in csv.DictReader(file)]
    fields = {}
    for tau in sorted({record["tau"] for record in records}, reverse=True):
        part = [record for record in records if record["tau"] == tau]
        rows = len({record["y"] for record in part})
        fields[tau] = {key: np.array([record[key] for record in part]).reshape(rows, -1) for key in part[0]}
    return fields


def euclidean(x: np.ndarray, y: np.ndarray) -> np.ndarray:
    """Signed Euclidean distance to the rectangle."""
    beside_x, beside_y = np.abs(x) - HALF_WIDTH, np.abs(y) - HALF_HEIGHT
    outside = np.hypot(np.maximum(beside_x, 0), np.maximum(beside_y, 0))
    return outside + np.minimum(np.maximum(beside_x, beside_y), 0)


def scaling(x: np.ndarray, y: np.ndarray) -> np.ndarray:
    """The growth distance of earlier work, by which the rectangle must be scaled beyond one."""
    return np.maximum(np.abs(x) / HALF_WIDTH, np.abs(y) / HALF_HEIGHT) - 1


def rectangle(axes: plt.Axes) -> None:
    """Draws the shape."""
    corner = (-HALF_WIDTH, -HALF_HEIGHT)
    axes.add_patch(plt.Rectangle(corner, 2 * HALF_WIDTH, 2 * HALF_HEIGHT, color="0.88", zorder=0))
    axes.set_aspect("equal")


def levels_figure(fields: dict[float, dict[str, np.ndarray]]) -> plt.Figure:
    """Left: three exact distances. Right: the smoothed one for several tau."""
    drawn, (left, right) = plt.subplots(1, 2, figsize=(9, 3.6), sharey=True)
    field = next(iter(fields.values()))
    x, y = field["x"], field["y"]
    exact = {"Euclidean": euclidean(x, y), "scaled (earlier work)": scaling(x, y), "this one, exact": field["exact_distance"]}
    smoothed = {f"tau = {tau}": field["smoothed_distance"] for tau, field in fields.items()}
    for axes, curves in ((left, exact), (right, smoothed)):
        rectangle(axes)
        for colour, style, (label, values) in zip(COLOURS, ("-", "-", "--", ":"), curves.items()):
            axes.contour(x, y, values, levels=LEVELS, colors=colour, linestyles=style, linewidths=1.2)
            axes.plot([], [], color=colour, linestyle=style, label=label)
        axes.legend(frameon=False, fontsize=7, loc="upper center", ncols=2, bbox_to_anchor=(0.5, 1.15))
    return drawn


def normals_figure(fields: dict[float, dict[str, np.ndarray]]) -> plt.Figure:
    """Gradient and normal on a coarse grid for every tau."""
    drawn, grid = plt.subplots(1, len(fields), figsize=(10, 2.8), sharey=True)
    for axes, (tau, field) in zip(grid, fields.items()):
        rectangle(axes)
        coarse = {key: values[4:-4:8, 2:-2:8] for key, values in field.items()}
        for colour, name, label in ((COLOURS[0], "gradient", "gradient"), (COLOURS[1], "normal", "normal n")):
            arrows = (coarse[f"{name}_x"], coarse[f"{name}_y"])
            axes.quiver(coarse["x"], coarse["y"], *arrows, color=colour, scale=4, scale_units="x", width=0.006, label=label)
        axes.set_title(f"tau = {tau}", fontsize=8)
    grid[0].legend(frameon=False, fontsize=7, loc="lower left", bbox_to_anchor=(0, -0.4), ncols=2)
    return drawn


def difference(field: dict[str, np.ndarray]) -> tuple[float, float, float]:
    """Largest and median norm of gradient minus normal, and largest distance of the normal's norm from one."""
    apart = np.hypot(field["gradient_x"] - field["normal_x"], field["gradient_y"] - field["normal_y"])
    norms = np.hypot(field["normal_x"], field["normal_y"])
    return float(apart.max()), float(np.median(apart)), float(np.median(norms))


def plane_section(page: Page) -> str:
    """Level lines and normals."""
    page.heading("Level lines and normals (Figs. distancecomp and normalvis)")
    if not PLANE.exists():
        page.text("Missing: not computed.")
        return "level lines missing"
    fields = plane()
    page.text(
        """The paper draws the distance of a point and a rectangle, both in the plane. Here the distances, normals and
        gradients of the product itself are drawn (`cargo run --release -p collision --example planar_distances`), which
        knows only solids: a cube of edge 0.001 m stands for the point, a cuboid of 2 x 1 x 20 m for the rectangle. Without
        smoothing both agree but for half the cube's edge; with smoothing the cube's six facets blur as well, so that a tau
        of the paper's figure and one of ours are not the same. The paper's values of tau, and data, are not given as
        numbers; its levels are 1, 0, -0.4.""")
    page.figure("levels", levels_figure(fields), "Levels 1, 0, -0.4 of the distance. Left: without smoothing. Right: smoothed.")
    page.figure("normals", normals_figure(fields), "Gradient of the smoothed distance and the approximate normal n_tau.")
    rows = [(tau, *difference(field)) for tau, field in fields.items()]
    exact = next(iter(fields.values()))
    inside = exact["exact_distance"] < 0
    error = np.abs(exact["exact_distance"] - euclidean(exact["x"], exact["y"]))[inside].max()
    page.table(
        ["tau", "largest distance of gradient and normal", "median", "median norm of the normal"],
        ([tau, *(f"{number:.3f}" for number in numbers)] for tau, *numbers in rows),
    )
    page.text(
        f"""As the paper says: for negative values the distance is the Euclidean one (largest difference here {error:.4f} m,
        half the cube's edge is 0.0005 m), and normal and gradient agree more and more as tau shrinks; where the nearest
        facet changes, the exact distance has a kink and they differ at any tau, in a thinner and thinner strip."""
    )
    (first, _, large, _), (last, _, small, _) = rows[0], rows[-1]
    return f"normal and gradient differ by {large:.3f} (median) at tau {first} and by {small:.3f} at tau {last}"


def render(page: Page) -> str:
    """Writes the page; the result in a sentence."""
    return "; ".join((times_section(page), plane_section(page)))
