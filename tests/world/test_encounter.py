import math

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from app.world.encounter import TOUCH, Encounters
from app.world.footprint import CHAIR_RADIUS
from app.world.movers import Mover, Track

STANDS = Mover(name="post", kind="ball", points=((2.0, 0.0), (3.0, 0.0)), pace=((0.0, 0.0),), radius=0.3)
REACH = CHAIR_RADIUS + 0.3
NUMBERS = st.floats(-3, 6)


def test_a_standing_mover_stops_the_chair():
    meets = Encounters([STANDS])
    x, touching = 0.0, False
    for _ in range(400):
        x, y, touching = meets.slide(x, 0.0, x + 0.01, 0.0, 0.0)
    assert x == pytest.approx(2.0 - REACH, abs=0.011)
    assert (y, touching) == (0.0, True)


def test_beside_a_mover_the_movement_along_it_is_kept():
    meets = Encounters([STANDS])
    at = (2.0 - REACH * math.cos(0.3), REACH * math.sin(0.3))
    x, y, touching = meets.slide(*at, at[0] + 0.05, at[1], 0.0)
    assert touching
    assert y > at[1]
    assert math.hypot(x - 2.0, y) >= REACH - 1e-3


@settings(max_examples=60, deadline=None)
@given(NUMBERS, NUMBERS, NUMBERS, NUMBERS)
def test_moving_away_is_free_and_no_movement_leads_nearer_than_before(x, y, new_x, new_y):
    came_x, came_y, touching = Encounters([STANDS]).slide(x, y, new_x, new_y, 1.0)
    before, wanted, came = (math.hypot(a - 2.0, b) for a, b in ((x, y), (new_x, new_y), (came_x, came_y)))
    if wanted >= min(before, REACH):
        assert (came_x, came_y) == (new_x, new_y)
    else:
        assert came >= min(wanted, before) - 1e-9
        assert math.hypot(came_x - x, came_y - y) <= math.hypot(new_x - x, new_y - y) + 1e-9
    assert touching == (wanted <= REACH + TOUCH)


PACES = st.lists(st.tuples(st.floats(0.1, 10), st.floats(0, 2)), min_size=0, max_size=5)


@settings(max_examples=60, deadline=None)
@given(PACES, st.booleans(), st.floats(0, 60), st.floats(0, 0.5))
def test_a_mover_goes_its_line_at_its_pace_and_never_jumps(steps, returns, t, dt):
    pace, at = [(0.0, 0.5)], 0.0
    for wait, v in steps:
        at += wait
        pace.append((at, v))
    mover = Mover(name="m", kind="person", points=((0, 0), (3, 0), (3, 4)), pace=tuple(pace), returns=returns)
    track = Track(mover)
    a, b = track.at(t), track.at(t + dt)
    fastest = max(v for _, v in pace)
    assert math.dist(a.pose[:2], b.pose[:2]) <= fastest * dt + 1e-9
    assert 0.0 <= a.v <= fastest
    x, y = a.pose[:2]
    assert (abs(y) < 1e-9 and -1e-9 <= x <= 3 + 1e-9) or (abs(x - 3) < 1e-9 and -1e-9 <= y <= 4 + 1e-9)
    if not returns and mover.way(t)[0] >= track.length:
        assert a.pose[:2] == (3, 4)
        assert a.v == 0.0


@pytest.mark.parametrize("pace", [(), ((1.0, 0.3),), ((0.0, 0.3), (0.0, 0.4)), ((0.0, 0.3), (2.0, 0.4), (1.0, 0.4))])
def test_a_pace_begins_at_once_and_goes_on(pace):
    with pytest.raises(ValueError, match="pace"):
        Mover(name="m", kind="person", points=((0, 0), (3, 0)), pace=pace)
