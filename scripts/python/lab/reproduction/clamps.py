"""Sec. clamp: three clips, five starts, six magnitudes of the offset."""

import matplotlib.pyplot as plt
import numpy as np

from lab.reproduction import paper, studies
from lab.reproduction.page import Page, mean

CLAMPS = {"clamp1": "clamp1", "clamp2": "clamp2", "clamp3": "clamp3", "clamp1_paper": "clamp1, the paper's tau"}
# Only for how large the first smoothing must be, with several in one study.
SWEEPS = ("clamp1_first_tau", "clamp1_four_offsets", "clamp1_window", "clamp2_long_outer_leg")
STUDIES = (*CLAMPS, *SWEEPS)
# A plan keeps every scenario so close to the goal.
TOLERANCE_MM = 1.0
# Of a pair of boxes, which all parts of clamp1 are.
HALFSPACES = 12
LARGEST_OFFSET = 0.005


EXPLANATION = """With smoothing tau shapes overlap by up to about the number of halfspaces of a pair times tau, called
the reach below. It is a known suspicion that plans miss the goal because the first reach is too small for the offset.
For `clamp1` at 5 mm that is not the reason: success is not monotone in the first tau. The scenario that misses the goal
ends on the wrong side of the flange, 10 mm off. While tau is 0.00125 or more it stands at a point between both sides (y
6 mm) in the plans of starts 1 to 3 that were looked at, whatever the first tau; it comes to the right side in a stage
with tau 0.001, and goes to the wrong one when the steps jump over that or begin below it. The homotopy of this page
(0.002, halved) and 0.004 meet 0.001 on their way; 0.0025, 0.003 and four offsets (0.00167) do not. The explanation was
found by looking at these runs; two predictions of it were then written down and tried on three starts, the lines with
another rate: 0.00167 with steps through 0.001 should reach the goal, 0.002 with steps past it should not. It does not
explain everything: `clamp2_long_outer_leg` steps through 0.001 and mostly misses the goal. A rule for the first tau and
sigma from offset and shapes (a reach of four offsets) was tried and dropped, since it missed the goal here. How wide
the window is, and whether it lies elsewhere in other tasks, was not examined: the setting of this page is known to work
for the plans of this page and not more."""

# clamp2 has been chosen after a look at results.
SELECTION = """`clamp2` is our second design: a first one with the long leg outside was solved before and missed the
goal from some starts at 5 mm, also with twice the first smoothing, and another, with the long leg inside, took its
place. That all plans of `clamp2` are good is therefore no test of the method. The first design is kept as
`clamp2_long_outer_leg` in `scripts/python/lab/reproduction/studies/scenes`, with its results in the last table."""


def is_good(cell: studies.Cell) -> bool:
    """Whether the plan converged and every scenario ends within the tolerance."""
    return cell.is_finished and cell.result["converged"] and cell.error_mm < TOLERANCE_MM


def figure(groups: dict[str, list[studies.Cell]]) -> plt.Figure:
    """Largest final error of every start and magnitude, a map per study."""
    drawn, grid = plt.subplots(1, len(groups), figsize=(2.7 * len(groups), 2.6), sharey=True, squeeze=False)
    for axes, (study, cells) in zip(grid[0], groups.items()):
        starts = sorted({cell.start for cell in cells})
        deltas = sorted({cell.delta_m for cell in cells})
        errors = np.full((len(starts), len(deltas)), np.nan)
        for cell in cells:
            place = starts.index(cell.start), deltas.index(cell.delta_m)
            errors[place] = cell.error_mm if cell.is_finished else np.nan
            text = f"{errors[place]:.1f}" if cell.is_finished else "-"
            axes.text(place[1], place[0], text, ha="center", va="center", fontsize=7)
        axes.imshow(errors, cmap="RdYlGn_r", vmin=0, vmax=2 * TOLERANCE_MM, aspect="auto")
        axes.set_xticks(range(len(deltas)), [f"{1e3 * delta:g}" for delta in deltas])
        axes.set_yticks(range(len(starts)), starts)
        axes.set_title(CLAMPS[study], fontsize=8)
        axes.set_xlabel("offset mm")
    grid[0][0].set_ylabel("start")
    return drawn


def row(name: str, delta: float, cells: list[studies.Cell]) -> list[object]:
    """One magnitude of one study."""
    finished = [cell for cell in cells if cell.is_finished]
    if not finished:
        return [name, f"{1e3 * delta:g}", f"0 of {len(cells)}", "missing", "", "", "", "", ""]
    objectives = [cell.result["objective"] for cell in finished]
    trajectories = sum(len(cell.stages) for cell in finished)
    return [
        name,
        f"{1e3 * delta:g}",
        f"{sum(map(is_good, finished))} of {len(finished)}",
        trajectories,
        f"{mean(cell.result['iterations'] for cell in finished):.0f}",
        f"{mean(cell.result['wall_s'] for cell in finished):.1f}",
        f"{min(objectives):.3f} to {max(objectives):.3f}",
        f"{max(cell.error_mm for cell in finished):.2f}",
        f"{max(cell.penetration_mm for cell in finished):.2f}",
    ]


def failures(page: Page, groups: dict[str, list[studies.Cell]]) -> None:
    """Every plan that misses the goal."""
    bad = [(study, cell) for study, cells in groups.items() for cell in cells if cell.is_finished and not is_good(cell)]
    if not bad:
        return
    page.heading("Plans that miss the goal")
    page.table(
        ["", "start", "offset mm", "final error of each scenario mm", "objective", "status"],
        (
            [
                CLAMPS[study],
                cell.start,
                f"{1e3 * cell.delta_m:g}",
                " ".join(f"{1e3 * scenario['position_error_m']:.1f}" for scenario in cell.result["scenarios"]),
                f"{cell.result['objective']:.3f}",
                cell.result["status"],
            ]
            for study, cell in bad
        ),
    )


def by_smoothing(cells: list[studies.Cell]) -> dict[tuple[str, float, float, float], list[studies.Cell]]:
    """Finished cells by scene, magnitude of the offset, first tau and its rate."""
    found: dict[tuple[str, float, float, float], list[studies.Cell]] = {}
    for cell in (cell for cell in cells if cell.is_finished):
        first, second = (stage["tau"] for stage in cell.stages[:2])
        found.setdefault((cell.scene, cell.delta_m, first, round(second / first, 3)), []).append(cell)
    return dict(sorted(found.items()))


def first_smoothing(page: Page, groups: dict[str, list[studies.Cell]]) -> None:
    """Good plans by first smoothing, at the largest offset."""
    page.heading("The first smoothing")
    page.text(EXPLANATION)
    cells = [cell for study, found in groups.items() if study.startswith("clamp1") for cell in found]
    cells += [cell for study in SWEEPS for cell in studies.load(study)]
    rows = []
    for (scene, delta, tau, rate), found in by_smoothing(cells).items():
        if delta != LARGEST_OFFSET:
            continue
        values = ", ".join(f"{1e3 * stage['tau']:.2f}" for stage in found[0].stages[:4])
        good = f"{sum(map(is_good, found))} of {len(found)}"
        iterations = f"{mean(cell.result['iterations'] for cell in found):.0f}"
        rows.append([scene, f"{tau:.2e}", rate, f"{values}, ...", f"{HALFSPACES * tau / delta:.1f}", good, iterations])
    page.table(
        [
            "5 mm offsets",
            "tau_1",
            "rate",
            "1000 tau by stage",
            "reach / offset",
            "good plans of those run",
            "iterations (mean)",
        ],
        rows,
    )


def render(page: Page) -> str:
    """Writes the page; the result in a sentence."""
    groups = {study: cells for study in CLAMPS if (cells := studies.load(study))}
    page.text(
        f"""Three clips onto the H-strut, five starts and offsets of 0 to 5 mm each. `clamp1` is the paper's U-shaped
        clamp; `clamp2` (J-shaped, legs of different length) and `clamp3` (tapered legs, astride the web) are our own,
        with the same clearance: a 5.5 mm gap on a 5 mm wall, 0.2 mm from the wall it stops at. Every homotopy step
        is a reference trajectory of its own, kept in `stages/`. The paper has {paper.CLAMP_TRAJECTORIES} per clip: six
        homotopy steps from tau 0.0005. Ours begin with four times that smoothing and do eight; the last six of
        these have exactly the paper's smoothing. A plan is good when it converged and every scenario ends within
        {TOLERANCE_MM:g} mm of the goal."""
    )
    page.text(SELECTION)
    if groups:
        page.figure("errors", figure(groups), "Largest final position error of all scenarios in mm.")
    page.table(
        [
            "",
            "offset mm",
            "good plans",
            "trajectories",
            "iterations (mean)",
            "wall s (mean)",
            "objective",
            "largest error mm",
            "deepest overlap mm",
        ],
        (
            row(CLAMPS[study], delta, [cell for cell in cells if cell.delta_m == delta])
            for study, cells in groups.items()
            for delta in sorted({cell.delta_m for cell in cells})
        ),
    )
    page.text("The paper gives no numbers of these plans, only how often the robot succeeded with them.")
    failures(page, groups)
    first_smoothing(page, groups)
    return "; ".join(
        f"{CLAMPS[study]}: {sum(map(is_good, cells))} of {sum(cell.is_finished for cell in cells)} within "
        f"{TOLERANCE_MM:g} mm ({len(cells)} planned)"
        for study, cells in groups.items()
    )
