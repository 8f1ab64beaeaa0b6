"""Table total_comp_times and Fig. pegs_data: pegs 1 to 5 from five starts each."""

import matplotlib.pyplot as plt

from lab.reproduction import paper, studies
from lab.reproduction.page import COLOURS, Page, mean

STUDIES = ("pegs",)
# The paper counts the linear solver as Ipopt's time.
SPLIT = {
    "distances, normals and derivatives": ("distances",),
    "model functions": ("model",),
    "rest of Ipopt with its linear solver": ("linear_solver", "rest"),
}


def milliseconds(cells: list[studies.Cell], parts: tuple[str, ...]) -> float:
    """Mean wall time per iteration of these parts."""
    return mean(1e3 * sum(cell.seconds(part) for part in parts) / cell.result["iterations"] for cell in cells)


def iterations(cells: list[studies.Cell]) -> list[float]:
    """Mean iterations of every homotopy step."""
    return [mean(counts) for counts in zip(*([stage["iterations"] for stage in cell.stages] for cell in cells))]


def figure(by_peg: dict[str, list[studies.Cell]]) -> plt.Figure:
    """Iterations per homotopy step; time per iteration."""
    drawn, (left, right) = plt.subplots(1, 2, figsize=(9, 3))
    width = 0.8 / len(by_peg)
    for index, (peg, cells) in enumerate(by_peg.items()):
        counts = iterations(cells)
        left.bar(
            [stage + width * (index - 2) for stage in range(1, len(counts) + 1)],
            counts,
            width,
            label=peg,
            color=COLOURS[index],
        )
        bottom = 0.0
        for colour, (label, parts) in zip(COLOURS, SPLIT.items()):
            time = milliseconds(cells, parts)
            right.bar(peg, time, bottom=bottom, color=colour, label=label if index == 0 else None)
            bottom += time
    left.set(xlabel="homotopy step", ylabel="Ipopt iterations (mean)")
    right.set(ylabel="wall ms per iteration (mean)")
    left.legend(frameon=False)
    # Room for the legend.
    right.set_ylim(top=1.3 * right.get_ylim()[1])
    right.legend(frameon=False, fontsize=8)
    return drawn


def render(page: Page) -> str:
    """Writes the page; the result in a sentence."""
    all_cells = studies.load("pegs")
    cells = [cell for cell in all_cells if cell.is_finished]
    by_peg = {peg: found for peg in paper.TOTAL_WALL_S if (found := [cell for cell in cells if cell.scene == peg])}
    done = sum(cell.is_done for cell in cells)
    summary = f"{done} of {len(cells)} plans converge and reach the goal ({len(all_cells)} planned)"
    page.text(
        """Each peg from five starting orientations with the parameters of Table parameters_pegs; one thread per plan,
        Ipopt with the `stage` linear solver.""",
        f"{summary}.",
    )
    if not cells:
        return summary
    page.heading("Total time (Table total_comp_times)")
    page.table(
        ["", "plans", "iterations (mean)", "wall s (mean)", "wall s, fastest and slowest", "wall s, paper (mean)"],
        (
            [
                peg,
                f"{sum(cell.is_done for cell in found)} of {len(found)} done",
                f"{mean(cell.result['iterations'] for cell in found):.0f}",
                f"{mean(cell.result['wall_s'] for cell in found):.1f}",
                ", ".join(f"{most(cell.result['wall_s'] for cell in found):.1f}" for most in (min, max)),
                paper.TOTAL_WALL_S[peg],
            ]
            for peg, found in by_peg.items()
        ),
    )
    page.text(
        """Wall times of plans solved one after the other with nothing else on the machine. The paper's Ipopt has MA27
        for its linear systems."""
    )
    page.heading("Iterations and time per iteration (Fig. pegs_data)")
    page.figure(
        "iterations", figure(by_peg), "Left: Ipopt iterations. Right: wall time per iteration. Means of the starts."
    )
    counts = {peg: iterations(found) for peg, found in by_peg.items()}
    page.table(
        ["iterations (mean)", *(f"stage {number}" for number in range(1, 6)), "paper"],
        ([peg, *(f"{count:.0f}" for count in counts[peg]), "not given as numbers"] for peg in by_peg),
    )
    page.table(
        ["wall ms per iteration (mean)", *SPLIT, "paper"],
        (
            [peg, *(f"{milliseconds(found, parts):.1f}" for parts in SPLIT.values()), "not given as numbers"]
            for peg, found in by_peg.items()
        ),
    )
    page.heading("All plans")
    page.table(
        [
            "",
            "start",
            "iterations per stage",
            "wall s",
            "objective",
            "largest final error mm",
            "deepest overlap mm",
            "status",
        ],
        (
            [
                cell.scene,
                cell.start,
                "+".join(str(stage["iterations"]) for stage in cell.stages),
                f"{cell.result['wall_s']:.1f}",
                f"{cell.result['objective']:.4f}",
                f"{cell.error_mm:.2f}",
                f"{cell.penetration_mm:.2f}",
                cell.result["status"],
            ]
            for cell in cells
        ),
    )
    return summary
