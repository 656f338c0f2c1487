import numpy as np
from hypothesis import given, settings
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays

from app.world.imports.boundary import TOLERANCE, corner_count, exact_outlines, outlines

SIDES = ((0, -1), (1, 0), (0, 1), (-1, 0))  # columns and rows to the neighbours of a cell

regions = arrays(np.bool_, st.tuples(st.integers(1, 12), st.integers(1, 12)))


def edges(loops):
    return [(a, b) for loop in loops for a, b in zip(loop, loop[1:] + loop[:1], strict=True)]


def area(loops):
    return sum(a[0] * b[1] - b[0] * a[1] for a, b in edges(loops)) / 2


@given(regions)
def test_exact_outlines_enclose_exactly_the_region(region):
    loops = exact_outlines(region)
    assert area(loops) == np.count_nonzero(region)
    sides = sum(
        1
        for row, column in np.argwhere(region)
        for across, up in SIDES
        if not (0 <= row + up < region.shape[0] and 0 <= column + across < region.shape[1])
        or not region[row + up, column + across]
    )
    assert sum(abs(a[0] - b[0]) + abs(a[1] - b[1]) for a, b in edges(loops)) == sides
    assert sum(map(len, loops)) == corner_count(region)
    for loop in loops:
        for a, b, c in zip(loop, loop[1:] + loop[:1], loop[2:] + loop[:2], strict=True):
            assert (a[0] == b[0]) != (b[0] == c[0])  # every corner turns


@given(regions)
@settings(max_examples=300)
def test_no_wall_lies_in_the_region(region):
    for a, b in edges(outlines(region)):
        share = np.linspace(0, 1, 97)[1:-1, np.newaxis]
        x, y = (np.array(a) + share * (np.array(b) - np.array(a))).T
        strictly = (np.abs(x - np.rint(x)) > 1e-6) & (np.abs(y - np.rint(y)) > 1e-6)
        column, row = np.floor(x[strictly]).astype(int), np.floor(y[strictly]).astype(int)
        inside = (column >= 0) & (row >= 0) & (column < region.shape[1]) & (row < region.shape[0])
        assert not region[row[inside], column[inside]].any()


@given(regions)
def test_every_exact_corner_is_near_a_wall(region):
    walls = edges(outlines(region))
    for loop in exact_outlines(region):
        for corner in loop:
            away = [np.subtract(corner, a) for a, _ in walls]
            along = [np.subtract(b, a) for a, b in walls]
            share = [np.clip(v @ w / (w @ w), 0, 1) for v, w in zip(away, along, strict=True)]
            nearest = min(np.hypot(*(v - s * w)) for v, w, s in zip(away, along, share, strict=True))
            assert nearest <= np.hypot(TOLERANCE, TOLERANCE)


def test_a_slanted_wall_becomes_few_pieces():
    rows, columns = np.mgrid[0:100, 0:200]
    region = rows > 10 + 0.13 * columns
    assert len(exact_outlines(region)[0]) > 40
    assert len(outlines(region)[0]) <= 24


def test_a_small_outline_is_not_simplified():
    region = np.ones((9, 9), bool)
    region[4, 4] = False
    outer, inner = sorted(outlines(region), key=len, reverse=True)
    assert set(outer) | set(inner) == {(0, 0), (9, 0), (9, 9), (0, 9), (4, 4), (5, 4), (5, 5), (4, 5)}
