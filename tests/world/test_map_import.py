import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays
from PIL import Image

from app.world.clearance import Clearance
from app.world.collision import Collision
from app.world.floorplan import FloorPlan
from app.world.imports.draft import plan_of
from app.world.imports.map_draft import TOLERANCE, corner_count, draft_of_map, exact_outlines, outlines
from app.world.imports.ros_map import read_occupancy_map
from folders import SHARED

MAPS = SHARED / "data" / "maps"
FREE, UNKNOWN, OCCUPIED = 254, 205, 0
DOCUMENT = """image: map.pgm
resolution: 0.05
origin: [-1.0, 2.0, 0.0]
negate: 0
occupied_thresh: 0.65
free_thresh: 0.196
"""


def two_rooms():
    """Two rooms of 4 m x 4 m with a 1 m door between them; pixels, the first row being the top of the plan."""
    pixels = np.full((100, 190), UNKNOWN, np.uint8)
    pixels[8:92, 8:182] = OCCUPIED
    pixels[10:90, 10:90] = FREE
    pixels[10:90, 100:180] = FREE
    pixels[60:80, 90:100] = FREE
    return pixels


def write(folder, pixels, document=DOCUMENT):
    Image.fromarray(pixels).save(folder / "map.pgm")
    file = folder / "map.yaml"
    file.write_text(document)
    return file


def import_ros_map(file, title=None):
    return plan_of(draft_of_map(read_occupancy_map(file), file, title), str(file))


def drive_along(plan, path):
    """Move a chair along the path and return how far it was pushed off at most, and whether it ever touched."""
    collision, line = Collision(plan), path.line
    x, y = line.points[0]
    off, touched = 0.0, False
    for step in range(1, int(line.length / 0.04)):
        x, y, touching = collision.slide(x, y, *line.point_at(step * 0.04))
        touched |= touching
        off = max(off, math.dist((x, y), line.point_at(step * 0.04)))
    return off, touched


def test_two_rooms_become_walls_where_they_are(tmp_path):
    plan = import_ros_map(write(tmp_path, two_rooms()), title="Two rooms")
    assert (plan.name, plan.title) == ("map", "Two rooms")
    walls = {tuple(corner) for wall in plan.walls for corner in wall}
    # rows 60..79 from the top are 1.0 to 2.0 m from the bottom, which is y = 2
    x, y = [-1 + cell * 0.05 for cell in (10, 90, 100, 180)], [2.5, 3.0, 4.0, 6.5]
    corners = {(x[i], y[j]) for i in range(4) for j in (0, 3)} | {(x[i], y[j]) for i in (1, 2) for j in (1, 2)}
    assert {(round(a, 3), round(b, 3)) for a, b in walls} == {(round(a, 3), round(b, 3)) for a, b in corners}
    path = plan.paths[0]
    assert path.line.length > 4
    assert (path.points[0][0] < 3.5) != (path.points[-1][0] < 3.5)  # from one room to the other
    assert Clearance(plan.walls, plan.wall_thickness, ()).along(path.points).distance >= 0.4
    assert drive_along(plan, path) == (pytest.approx(0, abs=1e-9), False)


def test_the_yaw_of_the_origin_rotates_the_plan(tmp_path):
    straight = import_ros_map(write(tmp_path, two_rooms()))
    turned = import_ros_map(write(tmp_path, two_rooms(), DOCUMENT.replace("2.0, 0.0]", "2.0, 1.5707963267948966]")))
    for a, b in zip(straight.paths[0].points, turned.paths[0].points, strict=True):
        assert b == pytest.approx((-1 - (a[1] - 2), 2 + (a[0] + 1)), abs=1e-3)


def test_negate_swaps_black_and_white(tmp_path):
    pixels = np.where(two_rooms() == FREE, OCCUPIED, 255).astype(np.uint8)
    plan = import_ros_map(write(tmp_path, pixels, DOCUMENT.replace("negate: 0", "negate: 1")))
    assert plan.walls == import_ros_map(write(tmp_path, two_rooms())).walls


def test_rooms_without_a_door_are_left_out(tmp_path):
    pixels = two_rooms()
    pixels[60:80, 90:100] = OCCUPIED
    pixels[10:50, 100:180] = OCCUPIED
    plan = import_ros_map(write(tmp_path, pixels))
    assert plan.bounds == pytest.approx((-0.5, 2.5, 3.5, 6.5))


def test_the_fields_of_other_programs_are_ignored(tmp_path):
    import_ros_map(write(tmp_path, two_rooms(), DOCUMENT + "mode: trinary\n"))


@pytest.mark.parametrize(
    ("document", "words"),
    [
        ("", "not a map's document"),
        ("- 1\n- 2\n", "not a map's document"),
        ("image: [", "not a YAML document"),
        (DOCUMENT.replace("resolution: 0.05\n", ""), "resolution: this is missing"),
        (DOCUMENT.replace("0.05", "-1"), "resolution"),
        (DOCUMENT.replace("0.05", ".nan"), "resolution"),
        (DOCUMENT.replace("[-1.0, 2.0, 0.0]", "[0, 0]"), "origin"),
        (DOCUMENT.replace("map.pgm", "other.pgm"), "no such image"),
        (DOCUMENT.replace("map.pgm", "map.yaml"), "not an image"),
        (DOCUMENT.replace("free_thresh: 0.196", "free_thresh: 0.0"), "no pixel is free"),
        (DOCUMENT.replace("-1.0, 2.0", "999.0, 999.0"), "walls"),
        (DOCUMENT.replace("0.05", "0.005"), "fits nowhere"),
    ],
)
def test_a_bad_map_is_refused_in_one_sentence(tmp_path, document, words):
    with pytest.raises(ValueError, match=r"map\.yaml|\.pgm") as refused:
        import_ros_map(write(tmp_path, two_rooms(), document))
    assert words in str(refused.value)
    assert "\n" not in str(refused.value)


def test_a_torn_image_is_refused(tmp_path):
    file = write(tmp_path, two_rooms())
    image = tmp_path / "map.pgm"
    image.write_bytes(image.read_bytes()[:2000])
    with pytest.raises(ValueError, match="cannot be read"):
        import_ros_map(file)


def test_a_real_building_can_be_driven_in():
    file = MAPS / "ipa-apartment.yaml"
    if not file.exists():
        pytest.skip("the recorded map ipa-apartment is not beside this checkout")
    plan = import_ros_map(file)
    assert plan.name == "ipa-apartment"
    assert 200 < len(plan.segments()) < 2000
    path = plan.paths[0]
    assert path.line.length > 20
    assert drive_along(plan, path) == (pytest.approx(0, abs=1e-9), False)
    assert FloorPlan.model_validate_json(plan.model_dump_json()) == plan
    occupancy = read_occupancy_map(file)
    free_around = np.zeros(0)
    for x, y in (point for wall in plan.walls for point in wall):  # no corner of a wall is inside free space
        column, row = (x + 19.2) / 0.05, (y + 19.2) / 0.05
        r, c = round(row), round(column)
        free_around = np.append(free_around, occupancy.free[r - 1 : r + 1, c - 1 : c + 1].sum())
    assert free_around.max() < 4


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
