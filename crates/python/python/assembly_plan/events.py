"""What happens while a plan is made or played: one class per kind of event.

A function that is given as `progress` hears of each:

    def show(event: events.Event) -> None:
        match event:
            case events.HomotopyStep(number=number, position_error_m=error):
                print(f"homotopy step {number}: {1e3 * error:.2f} mm from the goal")
            case events.Refined(rate=rate):
                print(f"{100 * rate:.1f} % of rollouts succeed")

    scene.solve_robust(progress=show)

It is called in the thread that has called `solve`. An exception that it raises ends the work and is passed on.
"""

from __future__ import annotations

import json
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, TypeAlias


@dataclass(frozen=True)
class SolverIteration:
    """An iteration of Ipopt, in homotopy step `homotopy_step` (from 1) with smoothing `tau`.

    `objective`, `primal_infeasibility`, `dual_infeasibility` and `barrier` are Ipopt's; `restoration` says whether it
    restores feasibility.
    """

    homotopy_step: int
    tau: float
    iteration: int
    objective: float
    primal_infeasibility: float
    dual_infeasibility: float
    barrier: float
    restoration: bool


@dataclass(frozen=True)
class HomotopyStep:
    """The end of homotopy step `number` of at most `most`, counted from 1.

    `position_error_m` is the largest final distance of all scenarios from the goal; it is None where that is not
    finite. `record` is the entry of ``stages`` in `Plan.result`.
    """

    number: int
    most: int
    position_error_m: float | None
    record: dict[str, Any]


@dataclass(frozen=True)
class Attempt:
    """Nothing is planned yet, with a goal error of `position_error_m`; `planned` says in words what is tried next."""

    planned: str
    position_error_m: float | None


@dataclass(frozen=True)
class Resumed:
    """An earlier run is continued after `done` of at most `most` homotopy steps; `refining` if it refined."""

    done: int
    most: int
    refining: bool


@dataclass(frozen=True)
class Discarded:
    """Unfinished work of an earlier run is not used, for this `reason`."""

    reason: str


@dataclass(frozen=True)
class Evaluated:
    """The plan has been played before refinement: the fraction `rate` of rollouts succeeds."""

    rate: float


@dataclass(frozen=True)
class Refining:
    """The refinement of a plan begins; `planned` says in words of which problem."""

    planned: str


@dataclass(frozen=True)
class Perturbation:
    """A perturbation of the reference was tried: `failing` of `cases` training rollouts fail, `accepted` were kept."""

    failing: int
    cases: int
    accepted: int


@dataclass(frozen=True)
class Refined:
    """A refined plan has been played at errors it was not trained on: the fraction `rate` of rollouts succeeds."""

    rate: float


@dataclass(frozen=True)
class Variant:
    """Refinement is stuck: variant `number` of `count` is solved; `planned` is its name."""

    planned: str
    number: int
    count: int


@dataclass(frozen=True)
class VariantSolved:
    """The variant has been solved; `status` says how that ended."""

    status: str


@dataclass(frozen=True)
class VariantTried:
    """The plan of the variant has been played: `failing` of `cases` training rollouts fail."""

    failing: int
    cases: int


@dataclass(frozen=True)
class Rollouts:
    """A simulation has played `done` of `count` rollouts."""

    done: int
    count: int


Event: TypeAlias = (
    SolverIteration
    | HomotopyStep
    | Attempt
    | Resumed
    | Discarded
    | Evaluated
    | Refining
    | Perturbation
    | Refined
    | Variant
    | VariantSolved
    | VariantTried
    | Rollouts
)
"""Any event."""

Progress: TypeAlias = Callable[[Event], object]
"""A function that hears of events."""


def bar(**options: Any) -> Progress:
    """A progress bar for notebooks and terminals by tqdm, which has to be installed: ``progress=events.bar()``.

    It counts homotopy steps or rollouts, and says what refinement has reached. `options` are those of ``tqdm.tqdm``.
    """
    from tqdm.auto import tqdm

    shown = tqdm(**options)

    def advance(done: int, count: int, unit: str) -> None:
        shown.unit, shown.total, shown.n = unit, count, done
        shown.refresh()

    def show(event: Event) -> None:
        match event:
            case HomotopyStep(number=number, most=most):
                advance(number, most, "step")
            case Rollouts(done=done, count=count):
                advance(done, count, "rollout")
            case Refined(rate=rate) | Evaluated(rate=rate):
                shown.set_description(f"{100 * rate:.1f} % of rollouts succeed")

    return show


_CLASSES: dict[str, Callable[..., Event]] = {
    "solver_iteration": SolverIteration,
    "homotopy_step": HomotopyStep,
    "attempt": Attempt,
    "resumed": Resumed,
    "discarded": Discarded,
    "evaluated": Evaluated,
    "refining": Refining,
    "perturbation": Perturbation,
    "refined": Refined,
    "variant": Variant,
    "variant_solved": VariantSolved,
    "variant_tried": VariantTried,
    "rollouts": Rollouts,
}


def _listener(progress: Progress | None) -> Callable[[str, str], object] | None:
    """What the native module calls for every event, with its name and its fields as JSON."""
    if progress is None:
        return None
    return lambda name, fields: progress(_CLASSES[name](**json.loads(fields)))
