"""Solves scenes with --robust, plays the plans in MuJoCo and writes docs/experiments/robustness*.md."""

import argparse
import datetime
import json
import pathlib
import sys

import robust_arm
from robust_cases import COUNT, SEED, Case, by_offset, cases, run, shares, summary, table_row

# Wall seconds that the paper's solver took for a plan without any refinement (Table total_comp_times).
PAPER_SECONDS = {"peg1": 86, "peg2": 171, "peg3": 391, "peg4": 380, "peg5": 344}
# Friction coefficients that --robust asks for by default.
FRICTIONS = ("0.0", "0.1", "0.3")
# Seconds after which the best plan so far is kept.
TIME_LIMIT = "120"

PAGE = """\
# Robust plans, played in MuJoCo

*Lab notebook, written on {date}.*

Every start of every scene, planned by `solve --robust{asked} --time-limit {limit}` and then played in MuJoCo with frictions
{frictions} by `scripts/validate_mujoco --seed {seed}`: {count} random offsets in the hull of the planned ones at each of
0, 25, 50 and 75 % of delta-hat and at delta-hat less 1 mm (one without offset). Success: within 3 mm and 0.1 rad of the
goal, one second after the end of the reference. The push is an unplanned straight motion from start to goal in the same
time, frictionless. `scripts/robust-all{options}` repeats all of it and writes this page.

In our own simulator: success in rollouts of the plain plan, and of the robust one at offsets that it was not trained
on; `(short)` where the target, 99 % at each friction and every planned offset, was not reached in time.
Times are those of `solve --robust --jobs {jobs}` with everything it does, on a shared machine; the paper's are those of a
plan without refinement, on a laptop.

{summary} The plans took {seconds:.0f} s in all, {longest:.0f} s at most.

{head}
{rows}

By magnitude of the offset in MuJoCo, all plans together:

{magnitude_head}
{magnitudes}
"""


def parse_arguments() -> argparse.Namespace:
    """Reads the command line."""
    parser = argparse.ArgumentParser(prog="scripts/robust-all", description=__doc__)
    parser.add_argument("scenes", nargs="*", help="only these scenes, by name [default: all]")
    parser.add_argument("--root", type=pathlib.Path, help=argparse.SUPPRESS)
    parser.add_argument("--jobs", type=int, default=1, help="threads of each solve, processes of MuJoCo [default: 1]")
    parser.add_argument("--count", default=COUNT, help=f"random offsets of each magnitude in MuJoCo [default: {COUNT}]")
    parser.add_argument(
        "--friction",
        metavar="LIST",
        help="plan and play with these friction coefficients, 0.0,0.1 for example, and write "
        "docs/experiments/robustness-low-friction.md",
    )
    parser.add_argument("--no-run", action="store_true", help="only write the page, from what is in out/")
    parser.add_argument(
        "--arm",
        type=pathlib.Path,
        action="append",
        default=[],
        metavar="FILE",
        help="plan for the [robot] table of this TOML file, let the whole arm play, and write "
        "docs/experiments/robustness-arm.md; may be repeated",
    )
    parser.add_argument("--starts", type=int, metavar="N", help="only the first N starts of each scene [default: all]")
    return parser.parse_args()


def first_starts(chosen: list[Case], count: int | None) -> list[Case]:
    """The cases with the first starts of each scene and offset."""
    starts: dict[tuple[str, float], list[Case]] = {}
    for case in chosen:
        starts.setdefault((case.scene, case.delta), []).append(case)
    return [case for group in starts.values() for case in group[:count]]


def header(cells: list[str]) -> str:
    """The first lines of a Markdown table."""
    return table_row(cells) + "\n" + "|---" * len(cells) + "|"


def row(case: Case, frictions: tuple[str, ...]) -> str:
    """One line of the table."""
    robust = json.loads((case.folder / "result.json").read_text())["robust"]
    rows = case.motions()
    kept = robust["rounds"][robust["kept_round"] - 1]
    variant = "" if len(robust["rounds"]) == 1 else f" ({kept['planned']})"
    planned = [row for row in rows if row["motion"] == "plan"]
    return table_row(
        [
            case.label(),
            f"{100 * robust['rate_before']:.1f} -> {100 * robust['rate_after']:.1f}" + ("" if robust["reached"] else " (short)"),
            f"{kept['changes']}{variant}" if kept["changes"] else "left alone",
            *shares(rows, frictions),
            f"{1e3 * max(float(row['position_error_m']) for row in planned):.1f}",
            f"{max(float(row['force_n']) for row in planned):.0f}",
            f"{robust['wall_s']:.0f}",
            f"{float((case.folder / 'cpu_s').read_text()):.0f}",
            str(PAPER_SECONDS.get(case.scene, "-")),
        ]
    )


def page(arguments: argparse.Namespace, frictions: tuple[str, ...], done: list[Case], missing: list[Case]) -> str:
    """Everything as Markdown."""
    shown = [f"{float(friction):g}" for friction in frictions]
    columns = [f"friction {friction}" for friction in shown]
    seconds = [json.loads((case.folder / "result.json").read_text())["robust"]["wall_s"] for case in done]
    options = f" --friction {arguments.friction} --count {arguments.count}" if arguments.friction else ""
    before, after = ["plan", "own rollouts, plain -> robust, %", "changes"], ["push", "largest error, mm", "force, N"]
    return PAGE.format(
        date=datetime.date.today().isoformat(),
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
        head=header([*before, *columns, *after, "wall s", "CPU s", "paper s"]),
        rows="\n".join(row(case, frictions) for case in done),
        magnitude_head=header(["offset", *columns, "push"]),
        magnitudes=by_offset(done, frictions),
    )


def chosen(arguments: argparse.Namespace, out: str) -> list[Case]:
    """What is to be planned, in a folder below the root."""
    return first_starts(cases(arguments.root, arguments.scenes, out), arguments.starts)


def free_bodies(arguments: argparse.Namespace) -> tuple[pathlib.Path, str]:
    """Plans free bodies; their page."""
    root, name, out, frictions, asked = arguments.root, "robustness", "out/robust", FRICTIONS, []
    if arguments.friction:
        name, out = f"{name}-low-friction", f"{out}-low-friction"
        frictions, asked = tuple(arguments.friction.split(",")), ["--friction", arguments.friction]
    for case in [] if arguments.no_run else chosen(arguments, out):
        print(case.label(), file=sys.stderr)
        run(arguments, case, root / f"scenes/{case.scene}.toml", ["--time-limit", TIME_LIMIT, *asked], asked)
    everything = cases(root, [], out)
    done = [case for case in everything if case.is_played()]
    missing = [case for case in everything if case not in done]
    return root / f"docs/experiments/{name}.md", page(arguments, frictions, done, missing)


def arms(arguments: argparse.Namespace) -> tuple[pathlib.Path, str]:
    """Plans for arms; their page."""
    for arm in arguments.arm:
        for case in [] if arguments.no_run else chosen(arguments, f"out/robust-arm/{arm.stem}"):
            print(f"{arm.stem}: {case.label()}", file=sys.stderr)
            robust_arm.make(arguments, arm, case)
    everything = {arm: cases(arguments.root, [], f"out/robust-arm/{arm.stem}") for arm in arguments.arm}
    return arguments.root / "docs/experiments/robustness-arm.md", robust_arm.page(arguments, everything)


def main() -> None:
    """Runs what is missing and writes the page."""
    arguments = parse_arguments()
    file, text = arms(arguments) if arguments.arm else free_bodies(arguments)
    file.write_text(text)
    print(f"written to {file}", file=sys.stderr)


main()
