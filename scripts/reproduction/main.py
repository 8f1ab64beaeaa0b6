"""Repeats the paper's experiments and writes pages and figures of what came out."""

import argparse
import datetime
import os
import pathlib
import sys

import clamps
import distances
import hessians
import pegs
import studies
from page import Page

PAGES = {
    "distances": (distances, "Distances: times, level lines, normals"),
    "pegs": (pegs, "Pegs"),
    "clamps": (clamps, "Clamps"),
    "hessians": (hessians, "Hessians, relaxation and smoothing"),
}


def parse_arguments() -> argparse.Namespace:
    """Reads the command line."""
    parser = argparse.ArgumentParser(
        prog="scripts/reproduce",
        description=__doc__,
        epilog="Runs are kept in out/reproduction; the same command goes on where it was stopped.",
    )
    parser.add_argument("pages", nargs="*", metavar="PAGE", help=f"of {', '.join(PAGES)} [default: all]")
    parser.add_argument("--jobs", type=int, default=1, help="plans solved at once; more make wall times larger [default: 1]")
    parser.add_argument("--quick", action="store_true", help="only the first plan of every study, a few minutes")
    parser.add_argument("--no-run", action="store_true", help="solve and measure nothing, only write what there is")
    parser.add_argument("--out", type=pathlib.Path, help="folder of the pages [default: docs/experiments/reproduction, with --quick out/reproduction/pages]")
    arguments = parser.parse_args()
    unknown = [page for page in arguments.pages if page not in PAGES]
    if unknown:
        parser.error(f"there is no page {unknown[0]}; there are {', '.join(PAGES)}")
    if arguments.jobs < 1:
        parser.error(f"--jobs {arguments.jobs}: must be at least 1")
    return arguments


def run(names: list[str], jobs: int, is_quick: bool) -> None:
    """Does what is not done yet."""
    for name in names:
        if name == "distances" and not is_quick:
            distances.run()
        for study in PAGES[name][0].STUDIES:
            studies.run(study, jobs, is_quick)


def machine() -> str:
    """The machine, in neutral words."""
    return f"""One processor core per plan, on a machine with {os.cpu_count()} cores. Only the plans of the pegs' page had it
        for themselves; elsewhere wall times include waiting for other programs. The paper used a laptop with an Intel
        i7-11850H (8 cores) and Ipopt with MA27."""


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
        f"*Lab notebook, written on {datetime.date.today().isoformat()}.*",
        """*Robust Rigid Body Assembly via Contact-Implicit Optimal Control with Exact Second-Order Derivatives* (Dietz et
        al.), with our numbers beside the paper's where it gives any. `scripts/reproduce` runs everything and writes these
        pages; `--quick` tries one plan of each study.""",
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
        f"Plans that are missing: {missing}. `scripts/reproduce` goes on with them." if missing else "No plan is missing."
    )
    index.write()
    print(f"written to {folder}", file=sys.stderr)


def main() -> None:
    """Runs and writes."""
    arguments = parse_arguments()
    names = arguments.pages or list(PAGES)
    if not arguments.no_run:
        run(names, arguments.jobs, arguments.quick)
    quick_folder = studies.RUNS / "pages"
    write(arguments.out or (quick_folder if arguments.quick else studies.ROOT / "docs/experiments/reproduction"))


main()
