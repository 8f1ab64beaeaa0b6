"""Sec. clamp: three clips, five starts, six magnitudes of the offset."""

import matplotlib.pyplot as plt
import numpy as np

import paper
import studies
from page import Page, mean

CLAMPS = {"clamp1": "clamp1", "clamp2": "clamp2", "clamp3": "clamp3", "clamp1_paper": "clamp1, the paper's tau", "clamp1_auto": "clamp1, tau auto"}
STUDIES = tuple(CLAMPS)
# A plan keeps every scenario so close to the goal.
TOLERANCE_MM = 1.0
# Of a pair of boxes, which all parts of clamp1 are.
HALFSPACES = 12


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
            text = f"{errors[place]:.1f}" if cell.is_finished else "–"
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
    trajectories = sum(len(cell.stages) for cell in finished)
    return [
        name,
        f"{1e3 * delta:g}",
        f"{sum(map(is_good, finished))} of {len(finished)}",
        trajectories,
        f"{mean(cell.result['iterations'] for cell in finished):.0f}",
        f"{mean(cell.result['wall_s'] for cell in finished):.1f}",
        f"{min(cell.result['objective'] for cell in finished):.3f} to {max(cell.result['objective'] for cell in finished):.3f}",
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


def first_smoothing(page: Page, groups: dict[str, list[studies.Cell]]) -> None:
    """How many plans of clamp1 are good for how large a first smoothing."""
    page.heading("The first smoothing")
    page.text(
        """With tau the shapes overlap by up to about the number of halfspaces of a pair times tau: the reach. With the
        paper's tau_1 = 0.0005 and boxes the reach is 6 mm, 1.2 offsets of 5 mm. The scenario that then misses the goal
        stays on the wrong side of the flange, 10 mm off: gap and leg have changed places. `tau = "auto"` and `sigma =
        "auto"` (`configs/homotopy_auto.toml`) choose a reach of four offsets, at least the thickness of the thinnest part,
        and `iterations = "auto"` goes on until the reach is below the clearance at the goal."""
    )
    rows = []
    for study, cells in groups.items():
        for delta in sorted({cell.delta_m for cell in cells}):
            finished = [cell for cell in cells if cell.delta_m == delta and cell.is_finished]
            if not study.startswith("clamp1") or not finished:
                continue
            tau = finished[0].stages[0]["tau"]
            reach = f"{HALFSPACES * tau / delta:.1f}" if delta else "-"
            good = f"{sum(map(is_good, finished))} of {len(finished)}"
            iterations = f"{mean(cell.result['iterations'] for cell in finished):.0f}"
            rows.append([CLAMPS[study], f"{1e3 * delta:g}", f"{tau:.2e}", len(finished[0].stages), reach, good, iterations])
    page.table(["", "offset mm", "tau_1", "stages", "reach / offset", "good plans", "iterations (mean)"], rows)


def render(page: Page) -> str:
    """Writes the page; the result in a sentence."""
    groups = {study: cells for study in STUDIES if (cells := studies.load(study))}
    page.text(
        f"""Three clips onto the H-strut, five starts and offsets of 0 to 5 mm each. `clamp1` is the paper's U-shaped clamp;
        `clamp2` (J-shaped, legs of different length) and `clamp3` (tapered legs, astride the web) are our own, with the
        same clearance: a 5.5 mm gap on a 5 mm wall, 0.2 mm from the wall it stops at. Every homotopy iteration is a
        reference trajectory of its own, kept in `stages/`. The paper has {paper.CLAMP_TRAJECTORIES} per clip: six
        homotopy iterations from tau 0.0005. The scenes begin with four times that smoothing and do eight; the last six
        of these have exactly the paper's smoothing. A plan is good when it converged and every scenario ends within
        {TOLERANCE_MM:g} mm of the goal."""
    )
    if groups:
        page.figure("errors", figure(groups), "Largest final position error of all scenarios in mm.")
    page.table(
        ["", "offset mm", "good plans", "trajectories", "iterations (mean)", "wall s (mean)", "objective", "largest error mm", "deepest overlap mm"],
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
