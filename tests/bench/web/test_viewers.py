from bench.circle import ROUND
from bench.web.viewers import REACH, measure_viewers


def test_the_viewers_are_served_and_their_cost_is_measured() -> None:
    core, poses, p50, p99 = measure_viewers([2], runs=1, seconds=0.5)
    assert core.figure > 0
    assert (core.reach, core.better) == (None, "lower")
    assert poses.figure > 1
    assert 0 < p50.figure <= p99.figure < 1000 * ROUND


def test_what_four_viewers_may_cost_is_asked_for() -> None:
    assert REACH == {4: 60.0}
