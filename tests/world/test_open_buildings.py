"""The outside of a building is never the plan unless it is chosen, also when entrances stand open."""

import numpy as np
import pytest
from PIL import Image

from app.world.imports.draft import plan_of
from app.world.imports.inside import inside_of_building
from app.world.imports.options import Options
from app.world.imports.plan_files import import_plan

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
    assert any("closed in the plan" in words for words in draft.messages) == (entrance > 0)
    assert any("16.0 x 12.0 m" in words for words in draft.messages)


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
