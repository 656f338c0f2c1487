"""On a slow processor half as many tests of whole programs run side by side, and at least one."""

from side_by_side import QUICK, side_by_side


def test_a_quick_machine_runs_as_many_as_it_is_asked_for():
    assert [side_by_side(most, QUICK) for most in (4, 2, 1)] == [4, 2, 1]


def test_a_slow_machine_runs_half_as_many():
    assert [side_by_side(most, 2 * QUICK) for most in (4, 2, 1)] == [2, 1, 1]
