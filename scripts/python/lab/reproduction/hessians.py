"""Fig. hessianapprox_comp: peg1 with exact Hessians and two approximations, relaxation and smoothing, two
tolerances."""

import itertools

import matplotlib.pyplot as plt

from lab.reproduction import paper, studies
from lab.reproduction.page import COLOURS, Page

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
    """Whether the last homotopy step converged and every scenario reaches the goal."""
    return cell.is_done


def is_capped(cell: studies.Cell) -> bool:
    """Whether an earlier homotopy step stopped at our limit of iterations, so that the count says little."""
    return any(stage["status"] == "iteration limit reached" for stage in cell.stages)


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
                axes.bar(
                    position,
                    count,
                    bottom=bottom,
                    color=colour,
                    hatch=None if is_success(cell) else "///",
                    edgecolor="white",
                )
                bottom += count
            mark = "failed" if not is_success(cell) else "capped" if is_capped(cell) else ""
            axes.text(position, bottom, mark, ha="center", va="bottom", color="#d55e00", fontsize=7)
    axes.set_xticks(range(len(labels)), [label.replace("gauss-newton", "g.-newton") for label in labels], fontsize=7)
    axes.set(ylabel=f"Ipopt iterations, tol {tolerance}")
    return drawn


def remark(cell: studies.Cell) -> str:
    """What kept a plan from converging in every homotopy step."""
    bad = [
        f"stage {number}: {stage['status']}"
        for number, stage in enumerate(cell.stages, 1)
        if stage["status"] != "solved"
    ]
    return "; ".join([cell.result["status"], *bad])


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
        sum(not is_success(cell) for cell in finished) if finished else "missing",
        sum(map(is_capped, finished)) if finished else "missing",
        f"{good[0]}, {good[-1]}" if good else "none" if finished else "missing",
        paper.HESSIANS[hessian, tolerance],
    ]


def render(page: Page) -> str:
    """Writes the page; the result in a sentence."""
    groups = load()
    finished = {key: [cell for cell in cells if cell.is_finished] for key, cells in groups.items()}
    page.text(
        """`peg1` from five starts with Scholtes' relaxation and smoothing, three kinds of Hessian and two tolerances of
        Ipopt. A plan counts as failed when the last homotopy step does not converge or a scenario misses the goal.
        Gauss-Newton and L-BFGS get at most 1000 iterations per homotopy step, 5000 altogether, about ten times
        what the exact Hessian needs. That limit is ours. A homotopy step that reaches it is continued by the next
        one; such plans are counted apart as capped: they need at least the iterations shown, and say nothing of whether
        the approximation would have converged with more. A failure with `iteration limit reached` in the last homotopy
        iteration is of this kind too. Where a single start was run, best and worst are the same run."""
    )
    for tolerance in TOLERANCES:
        page.figure(
            tolerance,
            figure(groups, tolerance),
            f"Iterations of the best (b) and worst (w) start, one colour per homotopy step, tol {tolerance}.",
        )
    page.table(
        [
            "Hessian",
            "complementarity",
            "tol",
            "starts run",
            "failed",
            "capped",
            "iterations, best and worst that reach the goal",
            "paper, in words",
        ],
        (row(key, cells) for key, cells in groups.items()),
    )
    page.text("The paper does not give the figure as numbers, only the words above.")
    failed = [
        (key, cell) for key, cells in finished.items() for cell in cells if not is_success(cell) or is_capped(cell)
    ]
    if failed:
        page.heading("Failed or capped")
        page.table(
            ["Hessian", "complementarity", "tol", "start", "iterations", "largest final error mm", "status"],
            (
                [*key, cell.start, cell.result["iterations"], f"{cell.error_mm:.2f}", remark(cell)]
                for key, cell in failed
            ),
        )
    runs = {
        hessian: [cell for key, cells in finished.items() if key[0] == hessian for cell in cells]
        for hessian in HESSIANS
    }
    return "; ".join(
        f"{hessian}: {sum(map(is_success, cells))} of {len(cells)} reach the goal, "
        f"{sum(map(is_capped, cells))} capped ({4 * STARTS} planned)"
        for hessian, cells in runs.items()
    )
