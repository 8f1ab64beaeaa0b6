"""Success of several plans together: injected magnitude x delta-hat."""

from lab import tables
from lab.mujoco.plans import Plan
from lab.mujoco.rollout import Outcome
from lab.validation.results import Result, Tolerance, proportion


def by_plan(played: list[Result], tolerance: Tolerance) -> str:
    """One Markdown table per motion and friction; starts of the same scene and delta-hat are counted together."""
    heads = [(column.motion, column.friction) for column in played[0].columns]
    plans = list(dict.fromkeys(plan_label(result.plan) for result in played))
    labels = list(dict.fromkeys(cell.label for result in played for cell in result.cells))
    lines = []
    for index, (motion, friction) in enumerate(heads):
        pooled: dict[tuple[str, str], list[Outcome]] = {}
        for result in played:
            for cell, outcomes in zip(result.cells, result.columns[index].outcomes):
                for label in (cell.label, "all"):
                    pooled.setdefault((label, plan_label(result.plan)), []).extend(outcomes)
        rows = [
            [label, *(proportion(pooled.get((label, plan), []), tolerance) for plan in plans)]
            for label in [*labels, "all"]
        ]
        lines += [
            f"### Success of the {motion}, friction {friction:g}\n",
            tables.markdown(["offset", *plans], rows),
            "",
        ]
    return "\n".join(lines)


def plan_label(plan: Plan) -> str:
    """Scene and delta-hat."""
    return f"{plan.title}, {1e3 * plan.delta:g} mm"
