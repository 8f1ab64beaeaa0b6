"""Fig. hessianapprox_comp: peg1 with exact Hessians and two approximations, relaxation and smoothing, two tolerances."""

import itertools

import matplotlib.pyplot as plt

import paper
import studies
from page import COLOURS, Page

HESSIANS = ("exact", "gauss-newton", "l-bfgs")
COMPLEMENTARITIES = ("relaxation", "smoothing")
TOLERANCES = ("1e-2", "1e-6")
STUDIES = tuple(f"hessian_{hessian.replace('-', '_')}" for hessian in HESSIANS)
STARTS = 5


def load() -> dict[tuple[str, str, str], list[studies.Cell]]:
    """Cells by Hessian, complementarity and tolerance."""
    cells = [cell for study in STUDIES for cell in studies.load(study)]
    combinations = itertools.product(HESSIANS, COMPLEMENTARITIES, TOLERANCES)
    return {
        (hessian, complementarity, tolerance): [
            cell for cell in cells if cell.homotopy == f"{complementarity}_{hessian}_{tolerance}.toml"
        ]
        for hessian, complementarity, tolerance in combinations
    }


def is_success(cell: studies.Cell) -> bool:
    """Whether every homotopy iteration converged and the goal is reached."""
    return cell.is_done and all(stage["status"].startswith("solved") for stage in cell.stages)


def figure(groups: dict[tuple[str, str, str], list[studies.Cell]], tolerance: str) -> plt.Figure:
    """Best and worst start of every combination, stage upon stage; failures hatched."""
    drawn, axes = plt.subplots(figsize=(9, 3.2))
    labels = []
    for hessian, complementarity in itertools.product(HESSIANS, COMPLEMENTARITIES):
        finished = [cell for cell in groups[hessian, complementarity, tolerance] if cell.is_finished]
        # A failure is worse than any success, whatever its iterations.
        finished.sort(key=lambda cell: (not is_success(cell), cell.result["iterations"]))
        short = f"{hessian}\n{complementarity[:4]}."
        for letter, cell in zip("bw", (finished[0], finished[-1]) if finished else (None, None)):
            position = len(labels)
            labels.append(f"{short} ({letter})")
            if cell is None:
                axes.text(position, 0, "not run", ha="center", va="bottom", rotation=90)
                continue
            bottom = 0
            for colour, stage in zip(COLOURS, cell.stages):
                count = stage["iterations"]
                axes.bar(position, count, bottom=bottom, color=colour, hatch=None if is_success(cell) else "///", edgecolor="white")
                bottom += count
            if not is_success(cell):
                axes.text(position, bottom, "failed", ha="center", va="bottom", color="#d55e00")
    axes.set_xticks(range(len(labels)), labels, fontsize=7)
    axes.set(ylabel=f"Ipopt iterations, tol {tolerance}")
    return drawn


def failure(cell: studies.Cell) -> str:
    """Why a plan counts as failed, stage by stage."""
    if is_success(cell):
        return ""
    bad = [(number, stage["status"]) for number, stage in enumerate(cell.stages, 1) if not stage["status"].startswith("solved")]
    where = ", ".join(f"stage {number}: {status}" for number, status in bad)
    return where or cell.result["status"]


def row(key: tuple[str, str, str], cells: list[studies.Cell]) -> list[object]:
    """One line of the table."""
    hessian, complementarity, tolerance = key
    finished = [cell for cell in cells if cell.is_finished]
    good = sorted(cell.result["iterations"] for cell in finished if is_success(cell))
    return [
        hessian,
        complementarity,
        tolerance,
        f"{len(finished)} of {STARTS}",
        len(finished) - len(good),
        f"{good[0]}, {good[-1]}" if good else "none converged" if finished else "missing",
        paper.HESSIANS[hessian, tolerance],
    ]


def render(page: Page) -> str:
    """Writes the page; the result in a sentence."""
    groups = load()
    finished = {key: [cell for cell in cells if cell.is_finished] for key, cells in groups.items()}
    page.text(
        """`peg1` from five starts with Scholtes' relaxation and smoothing, three kinds of Hessian and two tolerances of
        Ipopt. A plan counts as failed when any homotopy iteration does not converge or a scenario misses the goal.
        Gauss-Newton and L-BFGS get at most 1000 iterations per homotopy iteration, 5000 altogether, about ten times
        what the exact Hessian needs; a stage that stops short is continued by the next one."""
    )
    for tolerance in TOLERANCES:
        page.figure(
            tolerance,
            figure(groups, tolerance),
            f"Iterations of the best (b) and worst (w) start, one colour per homotopy iteration, tol {tolerance}.",
        )
    page.table(
        ["Hessian", "complementarity", "tol", "starts run", "failed", "iterations, best and worst that converged", "paper, in words"],
        (row(key, cells) for key, cells in groups.items()),
    )
    page.text("The paper does not give the figure as numbers, only the words above.")
    failed = [(key, cell) for key, cells in finished.items() for cell in cells if not is_success(cell)]
    if failed:
        page.heading("Failures")
        page.table(
            ["Hessian", "complementarity", "tol", "start", "iterations", "largest final error mm", "why"],
            ([*key, cell.start, cell.result["iterations"], f"{cell.error_mm:.2f}", failure(cell)] for key, cell in failed),
        )
    runs = {hessian: [cell for key, cells in finished.items() if key[0] == hessian for cell in cells] for hessian in HESSIANS}
    return "; ".join(
        f"{hessian}: {sum(map(is_success, cells))} of {len(cells)} converge ({4 * STARTS} planned)" for hessian, cells in runs.items()
    )
