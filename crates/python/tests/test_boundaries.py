"""How `scripts/lab boundaries` finds the offset at which too many motions fail, without playing any."""

import importlib
import sys

import pytest
from conftest import ROOT

sys.path.append(str(ROOT / "scripts/python"))
search = importlib.import_module("lab.boundaries.search")


@pytest.mark.parametrize("count", [1, 2, 5, 9])
def test_bisection_finds_how_many_levels_a_case_passes(count: int) -> None:
    for passed in range(count + 1):
        played: list[int] = []

        def passes(level: int, passed: int = passed, played: list[int] = played) -> bool:
            played.append(level)
            return level < passed

        assert search.levels_passed(passes, count) == passed
        assert len(played) == len(set(played)) <= 5
        if passed == count:
            assert played == [count - 1], "the hardest level is enough"


def test_levels_surround_the_prediction() -> None:
    large = search.levels(0.004)
    assert large == pytest.approx([0.0032, 0.0034, 0.0036, 0.0038, 0.004, 0.0042, 0.0044, 0.0046, 0.0048])
    # Half of 0.2 mm apart, and none that is no error.
    small = search.levels(0.0003)
    assert small == pytest.approx([0.0001, 0.0002, 0.0003, 0.0004, 0.0005, 0.0006, 0.0007])


def test_boundaries_are_quantiles_with_their_interval() -> None:
    # Of 60 cases, three pass one level, nine pass three, and the others all.
    passed = [1] * 3 + [3] * 9 + [5] * 48
    found = search.boundary(passed, 5, 0.9)
    assert found.at == 2, "57 of 60 pass it, 48 the next one"
    assert found.surely == 0, "all pass that"
    assert found.surely_not == 3, "of 80 %, the interval ends at 88 %"
    assert search.boundary([0] * 60, 5, 0.9) == search.Boundary(None, None, 0)
    assert search.boundary([5] * 20, 5, 0.9) == search.Boundary(4, None, None), "20 cases show no 90 %"


def test_boundaries_agree_that_are_a_margin_apart() -> None:
    at = [search.Boundary(level, None, None) for level in range(5)]
    assert search.agree(at[1], at[3]) and search.agree(at[3], at[1]) and not search.agree(at[1], at[4])
    nowhere = search.Boundary(None, None, 0)
    assert not search.agree(at[1], nowhere) and not search.agree(nowhere, nowhere)
