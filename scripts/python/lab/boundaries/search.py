"""Where too many cases fail: bisection, quantiles and their comparison. Nothing here plays a motion."""

import dataclasses
from collections.abc import Callable, Sequence

from lab.validation.results import wilson

# What counts as agreement: a share of the predicted offset, or a length (m), whichever is more.
SHARE, LENGTH = 0.1, 0.0002
# Levels on each side of the predicted offset, half of what counts as agreement apart.
AROUND = 4


@dataclasses.dataclass(frozen=True)
class Boundary:
    """The hardest level at which the wanted share of cases passes, the hardest at which it does with confidence, and
    the easiest at which it does not, with confidence; None beyond the levels that were tried."""

    at: int | None
    surely: int | None
    surely_not: int | None


def margin(predicted: float) -> float:
    """How far (m) a boundary may be from a predicted one."""
    return max(SHARE * predicted, LENGTH)


def levels(predicted: float) -> list[float]:
    """The offsets (m) that are tried, from easy to hard."""
    step = margin(predicted) / 2
    tried = [predicted + index * step for index in range(-AROUND, AROUND + 1)]
    return [offset for offset in tried if offset > 1e-3 * step]


def levels_passed(passes: Callable[[int], bool], count: int) -> int:
    """How many of some levels a case passes, by bisection: it takes it that one which passes a level passes all easier
    ones. The hardest level is the first to be tried."""
    if passes(count - 1):
        return count
    passed, failed = 0, count - 1
    while passed < failed:
        middle = (passed + failed) // 2
        if passes(middle):
            passed = middle + 1
        else:
            failed = middle
    return passed


def boundary(passed: Sequence[int], count: int, rate: float) -> Boundary:
    """From the number of levels that every case passes; confidence intervals are Wilson's of 95 %."""
    successes = [sum(levels > level for levels in passed) for level in range(count)]
    intervals = [wilson(number, len(passed)) for number in successes]
    holds = [level for level in range(count) if successes[level] >= rate * len(passed)]
    surely = [level for level in range(count) if intervals[level][0] >= rate]
    surely_not = [level for level in range(count) if intervals[level][1] < rate]
    return Boundary(max(holds, default=None), max(surely, default=None), min(surely_not, default=None))


def agree(one: Boundary, other: Boundary) -> bool:
    """Whether two boundaries are at most a margin, which is two levels, apart."""
    return None not in (one.at, other.at) and abs(one.at - other.at) <= 2
