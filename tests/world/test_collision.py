"""Walls and obstacles stop the chair, and so does what moves by itself."""

import math
from itertools import pairwise

import pytest
from hypothesis import example, given
from hypothesis import strategies as st
from world.storey import storey

from app.world.clearance import between_segments
from app.world.collision import Collision
from app.world.floorplan import bundled_floorplans, load_floorplan

RADIUS = 0.32
HALF = 0.05
KEPT = RADIUS + HALF
WALL = storey(walls=[[(0, -10), (0, 10)]])
MAZE = storey(
    walls=[
        [(-4, -4), (4, -4), (4, 4), (-4, 4), (-4, -4)],
        [(-4, 1), (-1, 1)],
        [(0.2, 1), (4, 1)],
        [(1, -4), (1, -0.8)],
        [(1, -0.8), (2.2, 0.1)],  # an acute corner
        [(-2.5, -4), (-1.2, -1.5), (-2.6, -1.4)],
    ],
    obstacles=[
        {"kind": "cylinder", "label": "column", "position": (-2.8, 2.5), "radius": 0.3},
        {"kind": "box", "label": "table", "position": (2.4, 2.6), "size": (1.2, 0.6), "angle": 0.5},
    ],
)

coordinate = st.floats(-4, 4)
stride = st.floats(-5, 5)


def room(plan, x, y):
    """How far (m) a chair at (x, y) is from the nearest surface, negative inside; by a plain loop over everything."""
    distances = []
    for wall in plan.walls:
        for (x1, y1), (x2, y2) in pairwise(wall):
            length = math.hypot(x2 - x1, y2 - y1)
            share = ((x - x1) * (x2 - x1) + (y - y1) * (y2 - y1)) / length**2
            # the rounded ends of a wall lie within the drawn wall
            cut = HALF / length
            share = min(max(share, cut), 1 - cut)
            distances.append(math.hypot(x - x1 - share * (x2 - x1), y - y1 - share * (y2 - y1)) - HALF)
    for obstacle in plan.obstacles:
        if obstacle.kind == "cylinder":
            distances.append(math.dist((x, y), obstacle.position) - obstacle.radius)
        else:
            corners = obstacle.corners()
            for (x1, y1), (x2, y2) in pairwise([*corners, corners[0]]):
                share = ((x - x1) * (x2 - x1) + (y - y1) * (y2 - y1)) / math.hypot(x2 - x1, y2 - y1) ** 2
                share = min(max(share, 0), 1)
                distances.append(math.hypot(x - x1 - share * (x2 - x1), y - y1 - share * (y2 - y1)))
    return min(distances) - RADIUS


@given(coordinate, coordinate, st.lists(st.tuples(stride, stride), min_size=1, max_size=12))
def test_a_chair_is_never_inside_a_wall_nor_outside_the_storey(x, y, strides):
    collision = Collision(MAZE)
    if not collision.is_free(x, y):
        return
    inside = min(room(MAZE, x, y), 0)
    for dx, dy in strides:
        x, y, _ = collision.slide(x, y, x + dx, y + dy)
        assert room(MAZE, x, y) >= inside - 1e-6
        assert max(abs(x), abs(y)) < 4
        assert not any(obstacle.kind == "box" and obstacle.covers(x, y) for obstacle in MAZE.obstacles)


@given(st.floats(-5, -KEPT), st.floats(-5, 5), st.floats(0, 2 * math.pi), st.floats(0.001, 5))
def test_no_speed_gets_through_a_wall(x, y, heading, stride):
    collision = Collision(WALL)
    for _ in range(4):
        x, y, _ = collision.slide(x, y, x + stride * math.cos(heading), min(max(y + stride * math.sin(heading), -9), 9))
        assert x <= -KEPT + 1e-6


@given(st.floats(-0.9, 0.9), st.floats(0.001, 2))
def test_the_way_along_the_wall_is_kept(angle, stride):
    along, into = stride * math.sin(angle), stride * math.cos(angle)
    x, y, touching = Collision(WALL).slide(-KEPT, 0, -KEPT + into, along)
    assert touching
    assert (x, y) == pytest.approx((-KEPT, along), abs=1e-9)


@given(coordinate, coordinate, stride, stride)
def test_without_walls_nothing_changes(x, y, dx, dy):
    assert Collision(None).slide(x, y, x + dx, y + dy) == (x + dx, y + dy, False)
    assert Collision(storey()).slide(x, y, x + dx, y + dy) == (x + dx, y + dy, False)


@given(st.floats(-6, -0.6), st.floats(-8, 8), st.floats(-0.2, 0.2), st.floats(-1, 1))
def test_away_from_walls_nothing_changes(x, y, dx, dy):
    collision = Collision(WALL)
    x, y, _ = collision.slide(x, y, x, y)
    new_x, new_y, touching = collision.slide(x, y, min(x + dx, -0.5), y + dy)
    assert (new_x, new_y) == pytest.approx((min(x + dx, -0.5), y + dy), abs=1e-12)
    assert not touching


def test_out_of_a_corner_leads_the_way_back():
    collision = Collision(storey(walls=[[(0, 10), (0, 0), (3, 1)]]))  # less than a right angle
    x, y = 2.0, 4.0
    for _ in range(200):
        x, y, touching = collision.slide(x, y, x - 0.03, y - 0.03)
    assert touching
    stuck = x, y
    for _ in range(50):
        x, y, touching = collision.slide(x, y, x + 0.02, y + 0.03)
    assert not touching
    assert math.dist((x, y), stuck) > 1


@pytest.mark.parametrize(("gap", "through"), [(0.70, True), (0.62, False)])
def test_a_doorway_is_as_wide_as_its_gap(gap, through):
    collision = Collision(storey(walls=[[(0, -5), (0, -gap / 2)], [(0, gap / 2), (0, 5)]]))
    x, y = -2.0, 0.0
    for _ in range(400):
        x, y, _ = collision.slide(x, y, x + 0.01, y)
    assert (x > 1) is through
    assert through or x < -0.05


def test_a_chair_slides_round_a_door_post():
    collision = Collision(storey(walls=[[(0, -5), (0, -0.5)], [(0, 0.5), (0, 5)]]))
    x, y = -1.0, 0.3  # 0.12 m too far to the left
    contacts = 0
    for _ in range(400):
        x, y, touching = collision.slide(x, y, x + 0.01, y)
        contacts += touching
    assert x > 1
    assert contacts > 0
    assert y == pytest.approx(0.5 - RADIUS, abs=0.01)


def test_from_inside_a_wall_only_the_ways_out_are_open():
    collision = Collision(WALL)
    assert not collision.is_free(-0.1, 0)
    x, y, touching = collision.slide(-0.1, 0, -0.05, 0)
    assert x <= -0.1
    assert touching
    x, y = -0.1, 0.0
    for _ in range(60):
        x, y, touching = collision.slide(x, y, x - 0.01, y)
    assert x < -KEPT
    assert not touching


def test_standing_at_the_wall_is_touching_and_a_step_back_is_not():
    collision = Collision(WALL)
    x, y, _ = collision.slide(-1, 0, 1, 0)
    assert collision.slide(x, y, x, y)[2]
    assert not collision.slide(x, y, x - 0.01, y)[2]


@pytest.mark.parametrize("name", ["clinic", "apartment", "corridors"])
def test_every_bundled_path_can_be_driven_without_a_touch(name):
    plan = load_floorplan(bundled_floorplans()[name])
    for path in plan.paths:
        collision, line = Collision(plan), path.line
        x, y = line.points[0]
        for step in range(1, int(line.length / 0.05)):
            x, y, touching = collision.slide(x, y, *line.point_at(step * 0.05))
            assert not touching
            assert math.dist((x, y), line.point_at(step * 0.05)) < 1e-9


@example(0.0, 0.0, 0.0, 2.225073858507e-311, 1.0, 0.0, 0.0, 1.0)  # so short that nothing can be divided by it
@given(*[st.floats(-3, 3)] * 8)
def test_distance_between_segments_against_dense_sampling(ax, ay, bx, by, cx, cy, dx, dy):
    import numpy as np

    piece, other = np.array([ax, ay, bx, by]), np.array([[cx, cy, dx, dy]])
    distance, place = between_segments(piece, other)
    share = np.linspace(0, 1, 101)[:, np.newaxis]
    a, b = piece[:2] + share * (piece[2:] - piece[:2]), other[0, :2] + share * (other[0, 2:] - other[0, :2])
    sampled = np.hypot(*(a[:, np.newaxis] - b[np.newaxis]).reshape(-1, 2).T).min()
    assert distance[0] <= sampled + 1e-9
    assert sampled - distance[0] < 0.15
    assert np.isfinite(place).all()
