"""The watch of what arrives at a shirt: its verdict, and the rate of what comes."""

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from app.hardware.shirt.arrival_watch import RATE_ERROR, ArrivalWatch, LeftOut, RateMeter


def test_a_verdict_waits_and_takes_the_newest_reason():
    watch = ArrivalWatch(10.0)
    assert watch.verdict(12.9) == "waiting"
    assert watch.verdict(13.1) == "nothing"
    watch.leave_out(LeftOut(13.2, "foreign"))
    watch.leave_out(LeftOut(13.3, "late"), 2)
    assert (watch.verdict(13.4), watch.left_out) == ("late", 3)
    watch.accept(13.5, 4)
    assert (watch.verdict(13.6), watch.accepted) == ("arrives", 4)
    watch.leave_out(LeftOut(13.7, "senders"))
    assert watch.verdict(13.8) == "senders"  # also while frames come
    assert watch.verdict(14.1) == "waiting"
    assert watch.verdict(16.6) == "senders"
    assert watch.verdict(16.8) == "nothing"


@given(st.floats(10, 500), st.floats(10, 500))
def test_a_rate_is_measured_and_told_from_the_one_that_is_set(rate, expected):
    assume(abs(abs(rate / expected - 1.0) - RATE_ERROR) > 0.01)
    meter = RateMeter(expected)
    for seq in range(round(6 * rate)):
        meter.add(seq, 1000.0 + seq / rate)
    assert meter.rate == pytest.approx(rate, rel=1e-6)
    assert meter.is_wrong == (abs(rate / expected - 1.0) > RATE_ERROR)
    assert meter.is_low == (meter.is_wrong and rate < expected)


def test_a_pause_and_a_restart_are_no_rate():
    meter = RateMeter(100.0)
    assert not meter.is_wrong
    for seq, t in ((0, 0.0), (1, 0.01), (2, 9.0), (3, 9.01), (0, 9.02), (1, 9.03)):
        meter.add(seq, t)
    assert np.isnan(meter.rate)
    assert not meter.is_wrong
    assert not meter.is_low
