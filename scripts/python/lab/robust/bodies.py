"""Robust plans for free bodies, and the page about them."""

import argparse
import json
import sys

from lab import notebook, tables
from lab.paths import SCENES
from lab.robust.cases import SEED, Case, by_offset, cases, chosen, run, shares, summary

# Wall seconds that the paper's solver took for a plan without any refinement (Table total_comp_times).
PAPER_SECONDS = {"peg1": 86, "peg2": 171, "peg3": 391, "peg4": 380, "peg5": 344}
# Friction coefficients that --robust asks for by default.
FRICTIONS = ("0.0", "0.1", "0.3")
# Seconds after which the best plan so far is kept.
TIME_LIMIT = "120"

PAGE = """\
Every start of every scene, planned by `solve --robust{asked} --time-limit {limit}` and then played in MuJoCo with
frictions {frictions} by `scripts/lab validate --seed {seed}`: {count} random offsets in the hull of the planned ones at
each of 0, 25, 50 and 75 % of delta-hat and at delta-hat less 1 mm (one without offset). Success: within 3 mm and 0.1
rad of the goal, one second after the end of the reference. The push is an unplanned straight motion from start to goal
in the same time, frictionless. `scripts/lab robust{options}` repeats all of it and writes this page.

In our own simulator: success in rollouts of the plain plan, and of the robust one at offsets that it was not trained
on; `(short)` where the target, 99 % at each friction and every planned offset, was not reached in time. Times are those
of `solve --robust --jobs {jobs}` with everything it does, on a shared machine; the paper's are those of a plan without
refinement, on a laptop.

{summary} The plans took {seconds:.0f} s in all, {longest:.0f} s at most.

{rows}

By magnitude of the offset in MuJoCo, all plans together:

{magnitudes}
"""


def row(case: Case, frictions: tuple[str, ...]) -> list[str]:
    """Cells of the table."""
    robust = json.loads((case.folder / "result.json").read_text())["robust"]
    rows = case.motions()
    kept = robust["rounds"][robust["kept_round"] - 1]
    variant = "" if len(robust["rounds"]) == 1 else f" ({kept['planned']})"
    planned = [row for row in rows if row["motion"] == "plan"]
    return [
        case.label(),
        tables.rates(robust),
        f"{kept['perturbations']}{variant}" if kept["perturbations"] else "left alone",
        *shares(rows, frictions),
        f"{1e3 * max(float(row['position_error_m']) for row in planned):.1f}",
        f"{max(float(row['force_n']) for row in planned):.0f}",
        f"{robust['wall_s']:.0f}",
        f"{float((case.folder / 'cpu_s').read_text()):.0f}",
        str(PAPER_SECONDS.get(case.scene, "-")),
    ]


def page(arguments: argparse.Namespace, frictions: tuple[str, ...], done: list[Case], missing: list[Case]) -> str:
    """Everything as Markdown."""
    shown = [f"{float(friction):g}" for friction in frictions]
    columns = [f"friction {friction}" for friction in shown]
    seconds = [json.loads((case.folder / "result.json").read_text())["robust"]["wall_s"] for case in done]
    options = f" --friction {arguments.friction} --count {arguments.count}" if arguments.friction else ""
    before = ["plan", "own rollouts, plain -> robust, %", "perturbations"]
    after = ["push", "largest error, mm", "force, N"]
    return PAGE.format(
        asked=f" --friction {','.join(shown)}" if arguments.friction else "",
        frictions=" and ".join([", ".join(shown[:-1]), shown[-1]]),
        options=options,
        seed=SEED,
        count=arguments.count,
        limit=TIME_LIMIT,
        jobs=arguments.jobs,
        summary=summary(done, missing),
        seconds=sum(seconds),
        longest=max(seconds, default=0.0),
        rows=tables.markdown(
            [*before, *columns, *after, "wall s", "CPU s", "paper s"], (row(case, frictions) for case in done)
        ),
        magnitudes=by_offset(done, frictions),
    )


def make(arguments: argparse.Namespace) -> None:
    """Plans and plays what is missing, and writes the page."""
    name, out, frictions, asked = "robustness", "robust", FRICTIONS, []
    if arguments.friction:
        name, out = f"{name}-low-friction", f"{out}-low-friction"
        frictions, asked = tuple(arguments.friction.split(",")), ["--friction", arguments.friction]
    for case in [] if arguments.no_run else chosen(arguments, out):
        print(case.label(), file=sys.stderr)
        run(arguments, case, SCENES / f"{case.scene}.toml", ["--time-limit", TIME_LIMIT, *asked], asked)
    everything = cases([], out)
    done = [case for case in everything if case.is_played()]
    missing = [case for case in everything if case not in done]
    notebook.write(name, "Robust plans, played in MuJoCo", page(arguments, frictions, done, missing))
