"""Maps, scans and drawings of whole buildings: each becomes a plan with its rooms inside, and the outside left out."""

import re
from itertools import pairwise

import numpy as np
import pytest
from PIL import Image
from world.scanned_homes import OCCUPIED, scanned_home, write_map
from world.scanned_hospital import scanned_hospital

from app.world.imports import map_draft
from app.world.imports.draft import plan_of
from app.world.imports.inside import inside_of_building
from app.world.imports.options import Options
from app.world.imports.plan_files import import_plan
from folders import SHARED

RESOLUTIONS = (0.02, 0.025, 0.03, 0.04, 0.05, 0.06, 0.08, 0.1)
SEEDS = (0, 1, *(pytest.param(seed, marks=pytest.mark.long) for seed in (2, 3, 4)))


def rooms_inside(plan, rooms):
    """Return how many rooms are in the free space; a spurious return may stand in the very middle of one."""
    around = np.array([(0, 0), (0.3, 0), (-0.3, 0), (0, 0.3), (0, -0.3)])
    return sum(sum(is_inside(plan, room + step) for step in around) >= 3 for room in rooms)


def is_inside(plan, place):
    """Return whether a place is in the free space: a ray from it crosses the walls an odd number of times."""
    crossings = 0
    for wall in plan.walls:
        for (ax, ay), (bx, by) in pairwise(wall):
            if (ay > place[1]) != (by > place[1]):
                crossings += place[0] < ax + (place[1] - ay) / (by - ay) * (bx - ax)
    return crossings % 2 == 1


@pytest.mark.parametrize("resolution", RESOLUTIONS)
@pytest.mark.parametrize("seed", SEEDS)
def test_the_rooms_of_a_scanned_home_are_in_its_plan(tmp_path, seed, resolution):
    home = scanned_home(100 * seed + round(resolution * 1000), resolution)
    plan = plan_of(import_plan(write_map(home, tmp_path), Options()), "home.yaml")
    assert rooms_inside(plan, home.rooms) == len(home.rooms)
    assert not is_inside(plan, (0.2, 0.2))  # nobody has seen the map's corner
    assert plan.paths[0].line.length >= 0.7 * home.length


@pytest.mark.parametrize(("seed", "size"), [(1, 22.0), (2, 35.0), pytest.param(3, 50.0, marks=pytest.mark.long)])
def test_the_rooms_of_a_scanned_hospital_are_in_its_plan(tmp_path, seed, size):
    hospital = scanned_hospital(seed, size)
    plan = plan_of(import_plan(write_map(hospital, tmp_path), Options()), "home.yaml")
    assert rooms_inside(plan, hospital.rooms) >= 0.9 * len(hospital.rooms)
    assert plan.paths[0].line.length >= size


def test_a_storey_of_too_many_pieces_is_taken_when_the_share_that_its_refusal_names_is_kept(tmp_path, monkeypatch):
    monkeypatch.setattr(map_draft, "MAX_WALLS", 250)
    hospital = scanned_hospital(1, 30.0)
    rows = first = hospital.pixels.shape[0]
    for _ in range(3):  # the share is about right: pieces are not spread evenly
        try:
            plan = plan_of(import_plan(write_map(hospital, tmp_path), Options()), "home.yaml")
        except ValueError as refused:
            words = str(refused)
            assert re.search(r"this map has [\d,]+ wall pieces when it is made as simple as .* at most 250 are", words)
            rows = round(rows * int(re.search(r"keep about (\d+) % of it and paint the rest as wall", words)[1]) / 100)
            hospital.pixels[: first - rows] = OCCUPIED
    assert 0 < rows < first
    assert rooms_inside(plan, hospital.rooms) > 0


RESOLUTION = 0.05
WHITE, BLACK = 255, 0


def home(entrance=1.0, wall=0.2, hollow=False, store=True):
    """A home of 10 m x 6 m on paper of 16 m x 12 m: two rooms, a closed store of 2 m x 2 m, an entrance below.

    Walls are solid, or two lines with a hollow between them.
    """
    pixels = np.full((240, 320), WHITE, np.uint8)

    def draw(x_min, y_min, x_max, y_max, value=BLACK):
        # From the lower left corner of the home at (3, 3), m.
        left, right = (round((x + 3) / RESOLUTION) for x in (x_min, x_max))
        low, high = (round((y + 3) / RESOLUTION) for y in (y_min, y_max))
        pixels[240 - high : 240 - low, left:right] = value

    def draw_wall(x_min, y_min, x_max, y_max):
        draw(x_min, y_min, x_max, y_max)
        if hollow:
            draw(x_min + 0.05, y_min + 0.05, x_max - 0.05, y_max - 0.05, WHITE)

    half = entrance / 2
    draw_wall(0, 6 - wall, 10, 6)
    draw_wall(0, 0, wall, 6)
    draw_wall(10 - wall, 0, 10, 6)
    draw_wall(0, 0, 3 - half, wall)
    draw_wall(3 + half, 0, 10, wall)
    draw_wall(5, 1.6, 5.2, 6)  # between the rooms, with 1.4 m of way
    if store:
        draw(7, 3, 9.2, 5.2)
        draw(7.1, 3.1, 9.1, 5.1, WHITE)
    return pixels


def save(folder, pixels, kind):
    Image.fromarray(pixels).save(folder / "home.png")
    if kind == "picture":
        return folder / "home.png", {"metres_per_pixel": RESOLUTION}
    file = folder / "home.yaml"
    file.write_text(f"image: home.png\nresolution: {RESOLUTION}\norigin: [0.0, 0.0, 0.0]\nfree_thresh: 0.25\n")
    return file, {}


@pytest.mark.parametrize("kind", ["picture", "map"])
@pytest.mark.parametrize("hollow", [False, True])
@pytest.mark.parametrize("entrance", [0.0, 0.9, 1.3, 2.0, 3.0])
def test_the_rooms_are_the_plan_and_not_the_store_or_the_outside(tmp_path, kind, hollow, entrance):
    file, options = save(tmp_path, home(entrance, hollow=hollow), kind)
    draft = import_plan(file, Options(**options))
    plan = plan_of(draft, "home")
    assert plan.bounds == pytest.approx((3.2, 3.2, 12.8, 8.8), abs=0.3)
    assert plan.paths[0].line.length > 8
    assert any("closed in the plan" in str(words) for words in draft.messages) == (entrance > 0)
    assert any("16.0 x 12.0 m" in str(words) for words in draft.messages)


@pytest.mark.parametrize("kind", ["picture", "map"])
def test_the_outside_is_used_when_it_is_chosen(tmp_path, kind):
    file, options = save(tmp_path, home(), kind)
    plan = plan_of(import_plan(file, Options(outside=True, **options)), "home")
    assert plan.bounds == pytest.approx((0, 0, 16, 12), abs=0.1)


@pytest.mark.parametrize("kind", ["picture", "map"])
def test_without_a_building_the_outside_has_to_be_chosen(tmp_path, kind):
    pixels = np.full((240, 320), WHITE, np.uint8)
    pixels[100:140, 150:160] = BLACK
    file, options = save(tmp_path, pixels, kind)
    with pytest.raises(ValueError, match="--outside"):
        import_plan(file, Options(**options))
    assert plan_of(import_plan(file, Options(outside=True, **options)), "hall").paths[0].line.length > 10


def test_rooms_at_the_edge_of_a_scan_are_kept(tmp_path):
    pixels = np.full((100, 200), 205, np.uint8)
    pixels[5:95, 0:180] = 254  # the picture ends where the robot turned back
    file, options = save(tmp_path, pixels, "map")
    plan = plan_of(import_plan(file, Options(**options)), "scan")
    assert plan.bounds == pytest.approx((0, 0.25, 9, 4.75), abs=0.1)


def test_a_white_outside_of_a_scan_is_left_out(tmp_path):
    pixels = np.where(home(0.0) == WHITE, 254, 0).astype(np.uint8)
    pixels[60:100, 75:100] = 205  # somewhere in a room nobody has looked
    file, options = save(tmp_path, pixels, "map")
    assert plan_of(import_plan(file, Options(**options)), "scan").bounds == pytest.approx(
        (3.2, 3.2, 12.8, 8.8), abs=0.1
    )


@pytest.mark.parametrize("side", [1, 3])
def test_the_inside_of_a_fine_grid_is_that_of_a_coarse_one(side):
    free = np.repeat(np.repeat(home() == WHITE, side, axis=0), side, axis=1)
    inside = inside_of_building(free, RESOLUTION / side)
    area = np.count_nonzero(inside.free) * (RESOLUTION / side) ** 2
    assert area == pytest.approx(9.6 * 5.6 - 0.2 * 4.2 - (2.2**2 - 2.0**2) + 0.2, abs=0.7)


CASES = SHARED / "data" / "cases"


def imported(name):
    file = CASES / name
    if not file.exists():
        pytest.skip("the small files of other programs are not beside this checkout")
    draft = import_plan(file, Options())
    return draft, plan_of(draft, name)


@pytest.mark.parametrize(
    "name", ["control", "unknown-free-025", "raw", "alpha", "thresholds-0-1", "absolute-path", "exponent"]
)
def test_the_flat_is_the_plan_in_each_form_of_a_map(name):
    draft, plan = imported(f"map-{name}.yaml")
    assert plan.bounds == pytest.approx((5, 5, 13, 10), abs=0.11)
    assert plan.paths[0].line.length == pytest.approx(9.0, abs=0.3)
    assert "8.0 x 5.0 m large" in str(draft.messages[1])
    assert "unknown" in str(draft.messages[2])


def test_a_small_flat_has_a_way():
    _, plan = imported("map-small-flat.yaml")
    assert plan.paths[0].line.length >= 6


def test_a_noisy_scan_is_made_simpler_and_says_so():
    draft, plan = imported("map-noisy-scan.yaml")
    assert len(plan.segments()) < 5000
    area = float(str(draft.messages[1]).partition("with ")[2].split(" ")[0])
    assert area == pytest.approx(137, abs=6)
    assert any("too many wall pieces" in str(words) for words in draft.messages)


@pytest.mark.parametrize("name", ["open", "closed"])
def test_an_open_entrance_changes_nothing(name):
    _, plan = imported(f"dxf-entrance-{name}.dxf")
    assert plan.paths[0].line.length == pytest.approx(11.3, abs=0.3)


@pytest.mark.parametrize(
    ("name", "places"),
    [
        ("invisible", {(5.0, 0.0), (5.0, 2.0)}),
        ("layer-massivwand", {(5.0, 0.0)}),
        ("layer-framed-wall", {(5.0, 0.0)}),
        ("array-mirrored", {(9.6, 2.0), (6.6, 2.0), (3.6, 2.0)}),
    ],
)
def test_a_drawing_has_the_walls_that_it_shows(name, places):
    _, plan = imported(f"dxf-{name}.dxf")
    assert places <= {point for wall in plan.walls for point in wall}


def test_the_invisible_line_is_not_there():
    draft, plan = imported("dxf-invisible.dxf")
    assert (5.0, 6.0) not in {point for wall in plan.walls for point in wall}
    assert "1 invisible" in " ".join(map(str, draft.messages))


def test_another_file_is_named():
    assert "1 WALLS_EG" in " ".join(map(str, imported("dxf-xref.dxf")[0].messages))


def test_the_size_in_inches_and_in_centimetres_is_said():
    words = " ".join(map(str, imported("dxf-inch-flag-drawn-in-cm.dxf")[0].messages))
    assert "30.5 x 20.3 m large, in inches as it says (12.0 x 8.0 m in cm)" in words
