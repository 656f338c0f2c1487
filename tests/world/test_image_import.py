"""Floor plans from pictures, and the cells of a ROS map by the rules of nav2's map_server."""

import io
import struct
import zlib

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from PIL import Image

from app.world.imports import image
from app.world.imports.draft import plan_of
from app.world.imports.image import import_image
from app.world.imports.map_draft import draft_of_map
from app.world.imports.options import Options
from app.world.imports.plan_files import import_plan
from app.world.imports.ros_map import _number, read_occupancy_map

WHITE, BLACK = 255, 0


def building():
    """A room of 6 m x 4 m with walls of 0.2 m, on paper with a broad white margin; 0.02 m per pixel."""
    pixels = np.full((500, 800), WHITE, np.uint8)
    pixels[100:320, 200:520] = BLACK
    pixels[110:310, 210:510] = WHITE
    return pixels


@pytest.fixture
def save(tmp_path):
    def write(picture, name="plan.png"):
        file = tmp_path / name
        (Image.fromarray(picture) if isinstance(picture, np.ndarray) else picture).save(file)
        return file

    return write


@pytest.mark.parametrize("name", ["plan.png", "plan.jpg"])
def test_a_picture_becomes_walls_at_its_scale(save, name):
    plan = plan_of(import_image(save(building(), name), metres_per_pixel=0.02), name)
    # two pixels make a cell of 0.04 m; the room begins 210 pixels from the left and 190 from below
    assert plan.bounds == pytest.approx((4.2, 3.8, 10.2, 7.8), abs=0.05)
    assert plan.name == "plan"
    assert len(plan.segments()) == 4
    assert plan.paths[0].line.length > 2


def test_the_scale_may_be_the_width(save):
    file = save(building())
    assert import_image(file, width=16.0).document == import_image(file, metres_per_pixel=0.02).document


def test_transparent_paper_is_white(save):
    pixels = np.zeros((500, 800, 4), np.uint8)  # transparent black
    pixels[building() == BLACK] = (0, 0, 0, 255)
    file = save(Image.fromarray(pixels))
    assert import_image(file, width=16.0).document == import_image(save(building()), width=16.0).document


def test_sixteen_bits_and_palettes_are_read(save):
    wide = Image.fromarray(building().astype(np.uint16) * 257)
    one = import_image(save(wide, "plan.png"), width=16.0).document
    other = import_image(save(Image.fromarray(building()).convert("P"), "plan.png"), width=16.0).document
    assert one == other == import_image(save(building(), "plan.png"), width=16.0).document


def test_a_thin_wall_is_not_lost_in_a_fine_picture(save):
    pixels = np.full((2000, 2000), WHITE, np.uint8)
    pixels[100:1900, 100:1900] = BLACK
    pixels[110:1890, 110:1890] = WHITE
    pixels[:, 1000] = BLACK  # one pixel of 5 mm
    plan = plan_of(import_image(save(pixels), metres_per_pixel=0.005), "x")
    x_min, _, x_max, _ = plan.bounds
    assert x_max - x_min < 4.6


def test_the_threshold_decides_what_is_a_wall(save):
    pixels = building()
    pixels[110:310, 360] = 200  # a light line across the room
    assert len(plan_of(import_image(save(pixels), width=16.0), "x").segments()) == 4
    plan = plan_of(import_image(save(pixels), width=16.0, threshold=0.9), "x")
    assert plan.bounds[2] - plan.bounds[0] < 3.1


@pytest.mark.parametrize(
    ("options", "words"),
    [
        ({}, "no scale"),
        ({"metres_per_pixel": 0.02, "width": 16.0}, "no scale"),
        ({"metres_per_pixel": 1e-5}, "correct it"),
        ({"metres_per_pixel": 0.0}, "correct it"),
        ({"metres_per_pixel": float("nan")}, "correct it"),
        ({"metres_per_pixel": float("inf")}, "correct it"),
        ({"metres_per_pixel": 0.5}, "doorways"),
        ({"width": -3.0}, "correct it"),
        ({"width": 1e9}, "correct it"),
        ({"width": 2.0}, "fits nowhere"),
        ({"width": 16.0, "threshold": 0.0}, "threshold"),
        ({"width": 16.0, "threshold": float("nan")}, "threshold"),
    ],
)
def test_bad_options_are_refused_in_one_sentence(save, options, words):
    file = save(building())
    with pytest.raises(ValueError, match=words) as refused:
        import_image(file, **options)
    assert str(refused.value).startswith(f"{file}: ")


def test_black_and_missing_pictures_are_refused(save, tmp_path):
    with pytest.raises(ValueError, match="nothing in this picture"):
        import_image(save(np.zeros((200, 200), np.uint8)), width=10.0)
    with pytest.raises(ValueError, match="no such file"):
        import_image(tmp_path / "none.png", width=10.0)
    with pytest.raises(ValueError, match="cannot be read"):
        import_image(tmp_path, width=10.0)


@pytest.mark.parametrize("name", ["plan.gif", "plan.tiff", "plan.webp"])
def test_other_kinds_of_pictures_are_refused(save, tmp_path, name):
    file = save(building(), name).rename(tmp_path / "plan.png")
    with pytest.raises(ValueError, match="no PNG or JPEG"):
        import_image(file, width=10.0)


def bomb(width, height):
    """A PNG that says it is huge."""

    def chunk(kind, content):
        return struct.pack(">I", len(content)) + kind + content + struct.pack(">I", zlib.crc32(kind + content))

    head = struct.pack(">IIBBBBB", width, height, 1, 0, 0, 0, 0)
    return (
        b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", head) + chunk(b"IDAT", zlib.compress(bytes(1000))) + chunk(b"IEND", b"")
    )


@pytest.mark.parametrize(("width", "height"), [(7000, 7000), (10_000, 10_000), (60_000, 60_000), (2**31 - 1, 1)])
def test_a_picture_that_would_fill_the_memory_is_not_unpacked(tmp_path, width, height):
    file = tmp_path / "bomb.png"
    file.write_bytes(bomb(width, height))
    with pytest.raises(ValueError, match="pixels"):
        import_image(file, width=10.0)


def test_a_file_that_is_too_large_is_refused(save, monkeypatch):
    monkeypatch.setattr(image, "MOST_PLAN_BYTES", 100)
    with pytest.raises(ValueError, match="larger than"):
        import_image(save(building()), width=10.0)


def whole(kind):
    stream = io.BytesIO()
    pixels = np.full((60, 80), WHITE, np.uint8)
    pixels[10:50, 10:70] = BLACK
    pixels[12:48, 12:68] = WHITE
    Image.fromarray(pixels).save(stream, kind)
    return stream.getvalue()


WHOLE = {"png": whole("PNG"), "jpg": whole("JPEG")}


@pytest.mark.parametrize("kind", WHOLE)
@settings(max_examples=60, suppress_health_check=[HealthCheck.function_scoped_fixture], deadline=None)
@given(
    changes=st.lists(st.tuples(st.integers(0, 5000), st.binary(max_size=3), st.integers(0, 3)), max_size=5),
    cut=st.integers(0, 5000),
)
def test_a_damaged_picture_is_read_or_refused_in_one_sentence(tmp_path, kind, changes, cut):
    content = WHOLE[kind]
    for place, new, removed in changes:
        at = place % (len(content) + 1)
        content = content[:at] + new + content[at + removed :]
    file = tmp_path / f"damaged.{kind}"
    file.write_bytes(content[: max(cut, 30)])
    try:
        assert import_image(file, width=8.0).document["paths"]
    except ValueError as refused:
        assert str(refused).startswith(f"{file}: ")  # noqa: PT017
        assert "\n" not in str(refused)  # noqa: PT017


def test_other_files_are_refused_by_their_names(tmp_path):
    with pytest.raises(ValueError, match=r"this is no \.yaml"):
        import_plan(tmp_path / "plan.pdf", Options())


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


@pytest.mark.parametrize(
    ("lines", "image", "words"),
    [(("mode: costmap",), "map.png", r"map\.yaml, mode"), ((), "m" * 5000, r"cannot be read|no such image")],
)
def test_an_unknown_mode_and_a_name_that_no_file_can_have_are_refused(tmp_path, lines, image, words):
    with pytest.raises(ValueError, match=words):
        read_occupancy_map(write(tmp_path, in_greys(flat(), SAVED), *lines, image=image))


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
