"""The count of tries at passwords and codes, for a minute."""

from concurrent.futures import ThreadPoolExecutor
from threading import Barrier

import pytest

from app.api.sign_in import sign_in_limits
from app.api.sign_in.sign_in_limits import WITHIN, Tries, whole_seconds
from app.texts import Text


def test_of_sixty_tries_side_by_side_five_are_let_through():
    counted, start = Tries(5), Barrier(60)

    def attempt(_number):
        start.wait()
        return counted.count("Ada")

    with ThreadPoolExecutor(60) as side_by_side:
        waits = list(side_by_side.map(attempt, range(60)))
    assert waits.count(0.0) == 5
    assert all(0 < wait <= WITHIN for wait in waits if wait)


def test_each_try_is_forgotten_after_a_minute_and_the_wait_says_when(monkeypatch):
    now = 1000.0
    monkeypatch.setattr(sign_in_limits, "monotonic", lambda: now)
    counted = Tries(2)
    assert counted.count("Ada") == 0
    now += 20
    assert counted.count("Ada") == 0
    now += 10
    assert counted.count("Ada") == pytest.approx(30)
    assert counted.count("Eve") == 0
    now += 30
    assert counted.count("Ada") == 0
    assert counted.count("Ada") == pytest.approx(20)


def test_a_try_that_succeeded_does_not_count(monkeypatch):
    counted = Tries(2)
    for _ in range(10):
        assert counted.count("Ada") == 0
        counted.take_back("Ada")
    assert not counted._times


def test_what_is_remembered_is_bounded(monkeypatch):
    monkeypatch.setattr(sign_in_limits, "MOST_KEYS", 10)
    counted = Tries(1)
    for i in range(100):
        counted.count(f"name {i}")
    assert len(counted._times) == 10
    assert counted.count("name 99") > 0


@pytest.mark.parametrize(
    ("wait", "words"), [(0.2, "1 second"), (1.0, "1 second"), (1.1, "2 seconds"), (60, "60 seconds")]
)
def test_a_wait_is_rounded_up(wait, words):
    assert f"wait {words}," in str(Text("api-tries-here", seconds=whole_seconds(wait)))
