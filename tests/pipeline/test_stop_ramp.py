"""The ramp of a stop: its deceleration, and each of its steps."""

import pytest

from app.pipeline.stop_ramp import stop_rate, towards_zero


def test_the_way_to_standstill():
    assert stop_rate(0.4, 3.0) == 3.0
    assert stop_rate(-1.5, 3.0) == 6.0
    assert towards_zero(0.5, 0.2) == pytest.approx(0.3)
    assert towards_zero(-0.5, 0.2) == pytest.approx(-0.3)
    assert towards_zero(0.1, 0.2) == towards_zero(-0.1, 0.2) == towards_zero(0.0, 0.2) == 0.0
