"""Each measurement of the web process, run briefly, gives its rows."""

import pytest

from bench.circle import ROUND
from bench.web.long_trajectory import SHORT, measure_trajectory
from bench.web.review import KINDS, measure_review
from bench.web.slow import measure_slow_pages
from bench.web.start import measure_start
from bench.web.tls import measure_tls
from bench.web.viewers import REACH, measure_viewers


def test_link_help_and_memory_are_measured() -> None:
    link, help_of_slowest, memory = measure_start(runs=1, help_runs=1, commands=("log",))
    assert link.figure > 0
    assert help_of_slowest.details.startswith("log, of 1 commands")
    assert 20 < memory.figure < 2000  # MB


def test_the_same_figures_are_measured_over_http_and_over_https() -> None:
    rows = measure_tls(turns=1, seconds=0.5)
    assert [row.what.count("https") for row in rows] == [0, 0, 0, 1, 1, 1]
    assert [row.unit for row in rows] == ["% of one core", "ms", "ms"] * 2
    assert all(0 < row.figure < 1000 * ROUND for row in rows)


def test_the_viewers_are_served_and_their_cost_is_measured() -> None:
    core, poses, p50, p99 = measure_viewers([2], runs=1, seconds=0.5)
    assert core.figure > 0
    assert (core.reach, core.better) == (None, "lower")
    assert poses.figure > 1
    assert 0 < p50.figure <= p99.figure < 1000 * ROUND


def test_what_four_viewers_may_cost_is_asked_for() -> None:
    assert REACH == {4: 60.0}


LONG = 1200  # points


def test_a_longer_trajectory_sends_no_more() -> None:
    sent, used = measure_trajectory(rounds=1, long=LONG)
    # Updates that a busy machine sends together are fewer bytes. Who sent all points anew would send six times as much.
    assert 0.5 < sent.figure < LONG / SHORT / 3
    assert used.figure > 0


@pytest.mark.long  # it times answers of a loaded web process
def test_stops_are_timed_without_and_beside_pages_that_hardly_read() -> None:
    ratio, p99, turn, share = measure_slow_pages(rounds=1, stops=10, reading=2, slow=5)
    assert ratio.figure > 0
    assert p99.figure > 0
    assert '"slow pages opened": 5' in ratio.details
    assert 0 < turn.figure < 1000
    assert 0 < share.figure < 100


@pytest.mark.long
def test_each_kind_of_review_has_its_three_rows_and_every_request_is_answered() -> None:
    rows = measure_review(runs=1, rounds=1, stops=40, drives=1, seconds=1.0)
    assert len(rows) == 3 * len(KINDS)
    assert all(row.figure > 0 for row in rows)
    for stops in rows[::3]:
        words = stops.details.partition("by status: ")[2]
        assert words.startswith("{")
        assert not any(f'"{status}"' in words for status in (403, 404, 409, 422, 500))
