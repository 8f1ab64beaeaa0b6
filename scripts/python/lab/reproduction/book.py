"""All pages of the paper's experiments."""

import os
import pathlib

from lab import notebook
from lab.reproduction import clamps, distances, force_mode, hessians, pegs, studies
from lab.reproduction.page import Page

# In the order of the index.
PAGES = {
    "distances": (distances, "Distances: times, level lines, normals"),
    "pegs": (pegs, "Pegs"),
    "clamps": (clamps, "Clamps"),
    "force-mode": (force_mode, "Clamps in force mode"),
    "hessians": (hessians, "Hessians, relaxation and smoothing"),
}


def run(names: list[str], jobs: int, is_quick: bool) -> None:
    """Does what is not done yet."""
    for name in names:
        if name == "distances" and not is_quick:
            distances.run()
        if name == "force-mode":
            force_mode.run(jobs, is_quick)
            continue
        for study in PAGES[name][0].STUDIES:
            studies.run(study, jobs, is_quick)


def machine() -> str:
    """The machine, in neutral words."""
    return f"""One processor core per plan, on a machine with {os.cpu_count()} cores. Only the plans of the pegs' page
        had it for themselves; elsewhere wall times include waiting for other programs. The paper used a laptop with an
        Intel i7-11850H (8 cores) and Ipopt with MA27."""


def unfinished() -> dict[str, str]:
    """How many plans are missing of each study that is not whole."""
    counts = {}
    for study in (study for module, _ in PAGES.values() for study in module.STUDIES):
        cells = studies.load(study)
        missing = sum(not cell.is_finished for cell in cells)
        if missing or not cells:
            counts[study] = f"{missing} of {len(cells)}" if cells else "all"
    return counts


def write(folder: pathlib.Path) -> None:
    """Writes all pages; those whose studies were never begun say so."""
    folder.mkdir(parents=True, exist_ok=True)
    index = Page(folder, "README", "The paper's experiments, repeated")
    index.text(
        notebook.date(),
        """*Robust Rigid Body Assembly via Contact-Implicit Optimal Control with Exact Second-Order Derivatives* (Dietz
        et al.), with our numbers beside the paper's where it gives any. `scripts/lab reproduce` runs everything and
        writes these pages; `--quick` tries one plan of each study.""",
        machine(),
    )
    rows = []
    for name, (module, title) in PAGES.items():
        page = Page(folder, name, title)
        summary = module.render(page)
        page.write()
        rows.append([f"[{title}]({name}.md)", summary])
    index.table(["page", "what came out"], rows)
    missing = "; ".join(f"{study}: {count}" for study, count in unfinished().items())
    index.text(
        f"Plans that are missing: {missing}. `scripts/lab reproduce` goes on with them."
        if missing
        else "No plan is missing."
    )
    index.write()
    notebook.said_to(folder)
