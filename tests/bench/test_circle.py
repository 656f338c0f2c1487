import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from bench.circle import RADIUS, ROUND, age_at, driving


@given(st.floats(0, 1e5), st.floats(0, ROUND - 0.01))
def test_the_place_tells_its_age(then: float, age: float) -> None:
    tick = driving(then)
    assert math.hypot(tick["x"], tick["y"]) == pytest.approx(RADIUS)
    found = age_at(float(tick["x"]), float(tick["y"]), then + age)
    assert math.remainder(found - age, ROUND) == pytest.approx(0, abs=1e-6)
    assert 0 <= found <= ROUND


@given(st.floats(0, 1e5))
def test_the_chair_looks_where_it_drives(now: float) -> None:
    here, there = driving(now), driving(now + 0.01)
    heading = math.atan2(there["y"] - here["y"], there["x"] - here["x"])
    assert math.remainder(heading - here["theta"], math.tau) == pytest.approx(0, abs=0.01)
