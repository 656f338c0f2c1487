import math
from itertools import pairwise

import pytest
from hypothesis import given
from hypothesis import strategies as st

from app.world.imports.wall_pieces import chain_pieces, join_pieces

places = st.tuples(st.integers(-20, 20), st.integers(-20, 20)).map(lambda p: (p[0] / 10, p[1] / 10))


def test_collinear_pieces_that_touch_are_merged():
    pieces = [((0, 0), (1, 0)), ((3, 0), (1, 0)), ((0.5, 0), (2, 0)), ((4, 0), (5, 0)), ((0, 0), (1, 0))]
    assert sorted(join_pieces(pieces)) == [[(0, 0), (3, 0)], [(4, 0), (5, 0)]]


def test_a_square_of_loose_pieces_is_one_closed_line():
    corners = [(0, 0), (4, 0), (4, 3), (0, 3), (0, 0)]
    (line,) = join_pieces(reversed(list(pairwise(corners))))
    assert line[0] == line[-1]
    assert set(line) == set(corners)
    assert len(line) == 5


def test_pieces_without_length_are_left_out():
    assert join_pieces([((1, 1), (1, 1)), ((2, 2), (2.0001, 2))]) == []


@given(st.lists(st.tuples(places, places), max_size=12))
def test_every_place_on_a_piece_stays_on_a_line_and_nothing_is_added(pieces):
    lines = [(a, b) for line in join_pieces(pieces) for a, b in pairwise(line)]

    def near(place, segments):
        return min((_distance(place, a, b) for a, b in segments), default=math.inf)

    for a, b in pieces:
        if a != b:
            for share in (0, 0.3, 0.5, 1):
                place = a[0] + share * (b[0] - a[0]), a[1] + share * (b[1] - a[1])
                assert near(place, lines) < 2e-3
    for a, b in lines:
        for share in (0, 0.25, 0.5, 0.9, 1):
            assert near((a[0] + share * (b[0] - a[0]), a[1] + share * (b[1] - a[1])), pieces) < 2e-3


@given(st.lists(st.tuples(places, places), max_size=12))
def test_a_chain_uses_every_piece_once(pieces):
    found = [tuple(sorted(pair)) for line in chain_pieces(pieces) for pair in pairwise(line)]
    assert sorted(found) == sorted({tuple(sorted(piece)) for piece in pieces if piece[0] != piece[1]})


def _distance(place, a, b):
    along = b[0] - a[0], b[1] - a[1]
    square = along[0] ** 2 + along[1] ** 2
    share = 0 if square == 0 else ((place[0] - a[0]) * along[0] + (place[1] - a[1]) * along[1]) / square
    share = min(1, max(0, share))
    return math.dist(place, (a[0] + share * along[0], a[1] + share * along[1]))


def test_chains_of_one_direction():
    assert chain_pieces([((0, 0), (1, 0)), ((1, 0), (1, 1))]) in (
        [[(0, 0), (1, 0), (1, 1)]],
        [[(1, 1), (1, 0), (0, 0)]],
    )
    assert pytest.approx(0) == len(chain_pieces([]))
