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
from app.world.imports.options import Options
from app.world.imports.plan_files import import_plan

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
    monkeypatch.setattr(image, "MOST_BYTES", 100)
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
