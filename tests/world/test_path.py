import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from app.world.path import Path

CORNER = Path([(0, 0), (4, 0), (4, 3)])

places = st.floats(-20, 20)
points = st.lists(st.tuples(places, places), min_size=2, max_size=8).filter(
    lambda line: max(math.dist(line[0], point) for point in line) > 0.1
)


def test_length_places_and_headings():
    assert CORNER.length == 7
    assert CORNER.point_at(5) == (4, 1)
    assert CORNER.point_at(-1) == (0, 0)
    assert CORNER.point_at(99) == (4, 3)
    assert CORNER.heading_at(3.9) == 0
    assert CORNER.heading_at(4) == pytest.approx(math.pi / 2)
    assert CORNER.heading_at(99) == pytest.approx(math.pi / 2)


def test_repeated_points_count_once():
    assert Path([(0, 0), (0, 0), (4, 0), (4, 0), (4, 3)]).points == CORNER.points


@pytest.mark.parametrize("line", [[], [(1, 1)], [(1, 1), (1, 1)], [(0, 0), (math.nan, 1)], [(0, 0), (math.inf, 1)]])
def test_an_invalid_line_is_refused(line):
    with pytest.raises(ValueError, match="line"):
        Path(line)


@pytest.mark.parametrize(
    ("place", "expected"),
    [
        ((2, 1), (2, 1)),
        ((2, -1), (2, -1)),
        ((3, 2), (6, 1)),
        ((5, 1), (5, -1)),
        ((5, -1), (4, -math.sqrt(2))),  # beyond the outer corner: right of the path
        ((-3, 4), (0, 5)),
        ((4, 5), (7, 2)),
    ],
)
def test_projection_is_left_positive(place, expected):
    assert CORNER.project(*place) == pytest.approx(expected)


def test_a_sharp_turn_keeps_its_sides():
    hairpin = Path([(0, 0), (4, 0), (0, 1)])  # turns left by far more than a right angle
    assert hairpin.project(5, 0)[1] == pytest.approx(-1)  # outside
    assert hairpin.project(2, 0.2)[1] > 0  # between the two legs


def test_at_a_crossing_of_the_path_the_previous_place_decides():
    cross = Path([(0, 0), (10, 0), (10, 5), (5, 5), (5, -5)])
    assert cross.project_near(5, 0.1, s_hint=4.8, window=2)[0] == pytest.approx(5)
    assert cross.project_near(5.1, 0, s_hint=24.8, window=2)[0] == pytest.approx(25)
    assert cross.project_near(5, 0, s_hint=-3, window=2) == pytest.approx((2, 3))  # no further than the window


@given(points, places, places)
def test_projection_is_the_nearest_place(line, x, y):
    path = Path(line)
    s, cross_track = path.project(x, y)
    assert 0 <= s <= path.length
    assert math.dist(path.point_at(s), (x, y)) == pytest.approx(abs(cross_track), abs=1e-6)
    for share in range(21):
        assert math.dist(path.point_at(path.length * share / 20), (x, y)) >= abs(cross_track) - 1e-9


@given(points, places, places)
def test_backwards_left_is_right(line, x, y):
    there, back = Path(line).project(x, y), Path(line[::-1]).project(x, y)
    assert abs(there[1]) == pytest.approx(abs(back[1]), abs=1e-9)


@given(points, st.floats(0, 1))
def test_a_place_on_the_path_projects_to_itself(line, share):
    path = Path(line)
    x, y = path.point_at(share * path.length)
    assert abs(path.project(x, y)[1]) < 1e-6
    assert path.project_near(x, y, share * path.length, 0.5)[1] == pytest.approx(0, abs=1e-6)
