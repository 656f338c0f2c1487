"""The monotonic clock counts the time in which the machine sleeps; neither clock knows a time zone."""

import time
from datetime import timedelta

import pytest

from app.clock import MonotonicClock, monotonic, utc_now


@pytest.mark.skipif(not hasattr(time, "CLOCK_BOOTTIME"), reason="This system's only clock is tested elsewhere.")
def test_a_machine_that_slept_shows_as_a_pause(monkeypatch):
    now = {time.CLOCK_BOOTTIME: 7200.0}  # it slept for an hour; the clock without sleep would say less
    monkeypatch.setattr(time, "clock_gettime", now.__getitem__)
    monkeypatch.setattr(time, "monotonic", lambda: 3600.0)
    assert monotonic() == MonotonicClock().now() == 7200.0


def test_sleep_ends_no_earlier_than_asked():
    clock = MonotonicClock()
    until = clock.now() + 0.01
    clock.sleep_until(until)
    assert clock.now() >= until
    clock.sleep_until(until)


def test_utc_is_the_same_in_every_time_zone(monkeypatch):
    monkeypatch.setenv("TZ", "EAST-14")
    time.tzset()
    try:
        now, counted = utc_now(), time.time()
    finally:
        monkeypatch.undo()
        time.tzset()
    assert now.utcoffset() == timedelta(0)
    assert abs(now.timestamp() - counted) < 3600.0
