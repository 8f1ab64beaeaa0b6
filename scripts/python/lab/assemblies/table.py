"""One table about all assemblies."""

import statistics

from lab import tables
from lab.assemblies.stages import FRICTIONS

COLUMNS = [
    *("assembly", "outcome", "pieces", "pairs", "active", "gap of meshes, mm", "of pieces, mm", "most error, mm"),
    *("new, s (CPU)", "check, s (CPU)", "plan, s", "own rates, %", "MuJoCo", "straight push", "largest force, N"),
]


def text(results: dict[str, dict]) -> str:
    """The table with a summary."""
    lines = [summary(results), "", f"Frictions are {', '.join(FRICTIONS)}.", ""]
    return "\n".join([*lines, tables.markdown(COLUMNS, (row(*each) for each in results.items()))]) + "\n"


def summary(results: dict[str, dict]) -> str:
    """Counts of outcomes and times of reading."""
    outcomes = [known["read"]["outcome"] for known in results.values()]
    counts = ", ".join(f"{outcomes.count(kind)} {kind}" for kind in dict.fromkeys(outcomes))
    parts = [f"{len(outcomes)} assemblies: {counts}"]
    for command in ("new", "check"):
        used = [known["read"][command] for known in results.values() if command in known["read"]]
        if used:
            walls, cpus = ([usage[key] for usage in used] for key in ("wall_s", "cpu_s"))
            parts.append(
                f"`{command}` takes {statistics.median(walls):.1f} s (median), at most {max(walls):.1f} s; "
                f"of processors {statistics.median(cpus):.1f} and {max(cpus):.1f} s"
            )
    return "; ".join(parts) + "."


def row(name: str, known: dict) -> list[str]:
    """The cells of an assembly."""
    read, plan, played = known["read"], known.get("plan", {}), known.get("play", {})
    if read["outcome"] != "read":
        cells = [name, read["reason"]]
        return cells + [""] * 6 + [seconds(read.get("new"))] + [""] * (len(COLUMNS) - 9)
    gap = read["gaps"][0] if read["gaps"] else None
    error = max((abs(gap["given_m"] - gap["parts_m"]) for gap in read["gaps"] if gap["given_m"] > 0), default=None)
    rates = plan.get("rates", {})
    successes = played.get("successes", {})
    force = plan.get("largest_force_n")
    return [
        name,
        plan.get("status", "read").partition(":")[0],
        " x ".join(map(str, read["pieces"])),
        str(read["pairs"]),
        str(plan.get("active_pairs", "")),
        millimetres(gap and gap["given_m"]),
        millimetres(gap and gap["parts_m"]),
        millimetres(error),
        seconds(read["new"]),
        seconds(read["check"]),
        f"{plan['solve']['wall_s']:.0f}" if plan else "",
        ", ".join(f"{100 * rates[friction]:.1f}" for friction in FRICTIONS if friction in rates),
        ", ".join(successes.get("plan", {}).values()),
        ", ".join(successes.get("straight push", {}).values()),
        f"{force:.0f}" if force is not None else "",
    ]


def millimetres(length_m: float | None) -> str:
    """A length as tables show it."""
    return "" if length_m is None else f"{1e3 * length_m:.4f}"


def seconds(usage: dict | None) -> str:
    """Wall time, and that of processors."""
    return f"{usage['wall_s']:.1f} ({usage['cpu_s']:.1f})" if usage else ""
