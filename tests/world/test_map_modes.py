"""The cells of a ROS map by the rules of nav2's map_server: modes, thresholds, transparency, numbers, images."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from PIL import Image

from app.world.imports.map_draft import draft_of_map
from app.world.imports.ros_map import _number, read_occupancy_map

FREE, OCCUPIED, UNKNOWN = 0, 1, 2
SAVED = {FREE: 254, OCCUPIED: 0, UNKNOWN: 205}  # the greys of a map saver


def flat():
    """A flat of 6 m x 4 m with walls of one cell, in 14 m x 11 m that nobody has seen; 0.05 m per cell."""
    cells = np.full((220, 280), UNKNOWN, np.uint8)
    cells[79:161, 99:221] = OCCUPIED
    cells[80:160, 100:220] = FREE
    return cells


def in_greys(cells, greys):
    return np.vectorize(greys.get)(cells).astype(np.uint8)


def write(folder, pixels, *lines, image="map.png", resolution="0.05"):
    (pixels if isinstance(pixels, Image.Image) else Image.fromarray(pixels)).save(folder / "map.png")
    file = folder / "map.yaml"
    file.write_text("\n".join([f"image: {image}", f"resolution: {resolution}", "origin: [0.0, 0.0, 0.0]", *lines]))
    return file


def assert_is_flat(file):
    occupancy = read_occupancy_map(file)
    assert np.array_equal(occupancy.free, np.flipud(flat() == FREE))
    assert occupancy.unknown == np.count_nonzero(flat() == UNKNOWN)
    draft = draft_of_map(occupancy, file)
    corners = np.array([point for wall in draft.document["walls"] for point in wall])
    assert corners.min(axis=0) == pytest.approx((5, 3))
    assert corners.max(axis=0) == pytest.approx((11, 7))


@pytest.mark.parametrize(
    "lines",
    [
        (),
        ("mode: trinary", "free_thresh: 0.196", "occupied_thresh: 0.65", "negate: 0"),
        ("free_thresh: 0.25",),  # what ROS 2's map saver writes, though 205 has an occupancy of 0.196
        ("free_thresh: 0.4", "occupied_thresh: 0.5"),
        ("free_thresh: 0.0039216",),  # one of 255
        ("negate: false",),
        ("negate: no",),
    ],
)
def test_unknown_cells_of_a_saved_map_stay_unknown(tmp_path, lines):
    assert_is_flat(write(tmp_path, in_greys(flat(), SAVED), *lines))


@pytest.mark.parametrize("kind", ["L", "RGB", "P", "I;16"])
def test_a_map_in_each_kind_of_picture(tmp_path, kind):
    greys = in_greys(flat(), SAVED)
    picture = Image.fromarray(greys.astype(np.uint16) * 257) if kind == "I;16" else Image.fromarray(greys).convert(kind)
    assert_is_flat(write(tmp_path, picture, "free_thresh: 0.25"))


def test_negate_makes_white_occupied(tmp_path):
    greys = {FREE: 1, OCCUPIED: 255, UNKNOWN: 100}
    assert_is_flat(write(tmp_path, in_greys(flat(), greys), "negate: 1"))
    assert_is_flat(write(tmp_path, in_greys(flat(), greys), "negate: true"))


def test_a_map_of_probabilities_has_no_grey_for_unknown(tmp_path):
    random = np.random.default_rng(1)
    cells = flat()
    pixels = in_greys(cells, {FREE: 0, OCCUPIED: 0, UNKNOWN: 128})
    pixels[cells == FREE] = random.integers(195, 256, np.count_nonzero(cells == FREE))
    assert_is_flat(write(tmp_path, pixels, "free_thresh: 0.25"))


def test_thresholds_count_with_their_own_value(tmp_path):
    greys = {FREE: 255, OCCUPIED: 0, UNKNOWN: 128}
    assert_is_flat(write(tmp_path, in_greys(flat(), greys), "free_thresh: 0.0", "occupied_thresh: 1.0"))
    greys = {FREE: 204, OCCUPIED: 102, UNKNOWN: 103}  # occupancies 0.2, 0.6 and a little less
    assert_is_flat(write(tmp_path, in_greys(flat(), greys), "free_thresh: 0.2", "occupied_thresh: 0.6"))


@pytest.mark.parametrize("negate", [0, 1])
def test_in_the_mode_raw_zero_is_free_and_up_to_a_hundred_occupied(tmp_path, negate):
    greys = in_greys(flat(), {FREE: 0, OCCUPIED: 1, UNKNOWN: 255})
    greys[79, 99:221], greys[0, 0] = 100, 101
    assert_is_flat(write(tmp_path, greys, "mode: raw", f"negate: {negate}"))


def test_in_the_mode_scale_what_is_partly_occupied_is_a_wall(tmp_path):
    cells = flat()
    pixels = np.zeros((*cells.shape, 2), np.uint8)
    pixels[..., 0] = in_greys(cells, {FREE: 254, OCCUPIED: 150, UNKNOWN: 254})  # an occupancy of 0.41
    pixels[..., 1] = in_greys(cells, {FREE: 255, OCCUPIED: 255, UNKNOWN: 0})
    assert_is_flat(write(tmp_path, Image.fromarray(pixels, "LA"), "mode: scale"))


@pytest.mark.parametrize("alpha", [0, 1, 254])
@pytest.mark.parametrize("mode", ["trinary", "scale", "raw"])
def test_what_is_not_opaque_is_unknown(tmp_path, mode, alpha):
    cells = flat()
    grey = in_greys(
        cells, {FREE: 0, OCCUPIED: 100, UNKNOWN: 0} if mode == "raw" else {FREE: 254, OCCUPIED: 0, UNKNOWN: 254}
    )
    opacity = in_greys(cells, {FREE: 255, OCCUPIED: 255, UNKNOWN: alpha})
    assert_is_flat(write(tmp_path, Image.fromarray(np.dstack([grey, grey, grey, opacity])), f"mode: {mode}"))


def test_a_palette_with_a_transparent_colour(tmp_path):
    picture = Image.fromarray(in_greys(flat(), {FREE: 1, OCCUPIED: 0, UNKNOWN: 2}), "P")
    picture.putpalette([0, 0, 0, 254, 254, 254, 255, 255, 255])
    picture.info["transparency"] = 2
    assert_is_flat(write(tmp_path, picture))


def test_an_unknown_mode_is_refused(tmp_path):
    with pytest.raises(ValueError, match=r"map\.yaml, mode"):
        read_occupancy_map(write(tmp_path, in_greys(flat(), SAVED), "mode: costmap"))


@pytest.mark.parametrize("written", ["5e-2", "5E-2", "+.05", "0.5e-1", "0.05e0", ".5e-1", "'0.05'", "050.0e-3"])
def test_numbers_are_those_of_yaml_1_2(tmp_path, written):
    assert_is_flat(write(tmp_path, in_greys(flat(), SAVED), resolution=written))


@pytest.mark.parametrize("written", ["3:00", "1_0", "0x1", ".nan", ".inf", "five", "[0.05]", "true"])
def test_other_words_are_no_numbers(tmp_path, written):
    with pytest.raises(ValueError, match=r"map\.yaml, resolution"):
        read_occupancy_map(write(tmp_path, in_greys(flat(), SAVED), resolution=written))


@given(st.floats(allow_nan=False, allow_infinity=False))
def test_every_number_is_read_as_it_is_written(value):
    assert _number(repr(value)) == value


@pytest.mark.parametrize("named", ["/home/somebody/maps/map.png", "C:\\maps\\map.png", "maps/map.png", "../map.png"])
def test_an_image_beside_the_map_is_found_by_its_name(tmp_path, named):
    folder = tmp_path / "copied"
    folder.mkdir()
    assert_is_flat(write(folder, in_greys(flat(), SAVED), image=named))


def test_an_image_that_is_where_the_map_says_is_preferred(tmp_path):
    (tmp_path / "maps").mkdir()
    write(tmp_path / "maps", in_greys(flat(), SAVED))
    assert_is_flat(write(tmp_path, np.zeros((10, 10), np.uint8), image="maps/map.png"))


def test_a_name_that_no_file_can_have_is_refused(tmp_path):
    with pytest.raises(ValueError, match=r"cannot be read|no such image"):
        read_occupancy_map(write(tmp_path, in_greys(flat(), SAVED), image="m" * 5000))
