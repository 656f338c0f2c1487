import io
import json
import math
import re
from itertools import pairwise

import ezdxf
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from app.world.imports import dxf_lines
from app.world.imports.draft import plan_of
from app.world.imports.dxf import import_dxf

ROOM = [(0, 0), (8, 0), (8, 6), (0, 6), (0, 0)]


def drawing(unit=6):
    document = ezdxf.new("R2010")
    document.header["$INSUNITS"] = unit
    return document, document.modelspace()


@pytest.fixture
def save(tmp_path):
    def write(document, name="hall.dxf"):
        file = tmp_path / name
        document.saveas(file)
        return file

    return write


def room(space, scale=1.0, at=(0.0, 0.0), layer="WALLS"):
    points = [(at[0] + x * scale, at[1] + y * scale) for x, y in ROOM]
    for a, b in pairwise(points):
        space.add_line(a, b, dxfattribs={"layer": layer})


def corners(draft):
    return {tuple(point) for wall in draft.document["walls"] for point in wall}


@pytest.mark.parametrize(("code", "scale"), [(1, 0.0254), (2, 0.3048), (4, 0.001), (5, 0.01), (6, 1.0)])
def test_a_room_in_each_unit_is_as_large_as_it_is(save, code, scale):
    document, space = drawing(code)
    room(space, 1 / scale, at=(1000, -500))
    draft = import_dxf(save(document))
    plan = plan_of(draft, "hall.dxf")
    assert plan.bounds == pytest.approx((0, 0, 8, 6), abs=2e-3)
    assert draft.words[0] == "4 wall pieces."
    assert "proposal" in draft.words[1]
    assert plan.paths[0].line.length > 2


def test_without_a_unit_it_must_be_given(save):
    document, space = drawing(0)
    room(space)
    file = save(document)
    with pytest.raises(ValueError, match="does not say in which unit"):
        import_dxf(file)
    assert plan_of(import_dxf(file, unit="m"), "x").bounds == pytest.approx((0, 0, 8, 6))
    with pytest.raises(ValueError, match="'yard' is not known"):
        import_dxf(file, unit="yard")
    with pytest.raises(ValueError, match="give its unit"):
        import_dxf(file, unit="mm")


def test_what_the_drawing_says_can_be_overruled(save):
    document, space = drawing(4)
    room(space)
    assert plan_of(import_dxf(save(document), unit="m"), "x").bounds == pytest.approx((0, 0, 8, 6))


def test_polylines_bulges_arcs_and_circles_become_chords(save):
    document, space = drawing()
    space.add_lwpolyline([(0, 0, 0), (10, 0, 1), (10, 6, 0), (0, 6, 0)], format="xyb", close=True)
    space.add_circle((3, 3), 0.5)
    space.add_arc((6, 3), 0.4, 90, 270)
    space.add_polyline2d([(1, 1), (1, 2), (2, 2)])
    draft = import_dxf(save(document))
    points = corners(draft)
    half_circle = [p for p in points if p[0] > 10.001]
    assert max(x for x, _ in half_circle) == pytest.approx(13, abs=0.03)  # a bulge of 1 is half a circle
    assert all(math.dist(p, (10, 3)) == pytest.approx(3, abs=2e-3) for p in half_circle)
    on_circle = [p for p in points if 0.4 < math.dist(p, (3, 3)) < 0.6]
    assert len(on_circle) >= 8
    assert all(math.dist(p, (3, 3)) == pytest.approx(0.5, abs=2e-3) for p in on_circle)
    assert any(math.dist(p, (5.6, 3)) < 0.1 for p in points)
    assert {(1, 1), (1, 2), (2, 2)} <= points


def test_blocks_are_taken_apart_where_they_stand(save):
    document, space = drawing(4)
    block = document.blocks.new("DESK", base_point=(100, 0))
    block.add_line((100, 0), (1100, 0), dxfattribs={"layer": "0"})
    inner = document.blocks.new("LEG")
    inner.add_line((0, 0), (0, 200))
    block.add_blockref("LEG", (1100, 0))
    room(space, 1000)
    space.add_blockref("DESK", (2000, 3000), {"rotation": 90, "xscale": 2, "layer": "THINGS"})
    draft = import_dxf(save(document))
    points = corners(draft)
    # 1 m, twice as long, turned to the left, from (2, 3) on; the leg at its end points to the left then
    assert {(2, 3), (2, 5), (1.8, 5)} <= points
    assert draft.layers == ("THINGS", "WALLS")
    assert (2, 3) not in corners(import_dxf(save(document), layers=("WALLS",)))


def test_blocks_in_rows_and_columns(save):
    document, space = drawing()
    document.blocks.new("POST").add_line((0, 0), (0.1, 0))
    room(space)
    space.add_blockref(
        "POST", (1, 1), {"row_count": 2, "column_count": 3, "row_spacing": 1, "column_spacing": 2, "layer": "P"}
    )
    found = corners(import_dxf(save(document), layers=("P",)))
    assert {(round(x + 1, 3), round(y + 1, 3)) for x, y in found} >= {(x, y) for x in (1, 3, 5) for y in (1, 2)}


def test_layers_for_words_and_hidden_ones_are_left_out(save):
    document, space = drawing()
    room(space)
    document.layers.add("HIDDEN").off()
    document.layers.add("COLD").freeze()
    for layer in ("DIM-1", "Text", "HIDDEN", "COLD"):
        space.add_line((20, 0), (30, 30), dxfattribs={"layer": layer})
    space.add_text("HALL").set_placement((3, 3))
    space.add_spline([(0, 0), (5, 5), (9, 9)])
    draft = import_dxf(save(document))
    assert plan_of(draft, "x").bounds == pytest.approx((0, 0, 8, 6))
    assert draft.layers == ("DIM-1", "Text", "WALLS")
    assert draft.taken == ("WALLS",)
    assert "1 SPLINE" in draft.words[-1]
    with pytest.raises(ValueError, match="no layer 'HIDDEN'"):
        import_dxf(save(document), layers=("HIDDEN",))


def test_the_path_is_taken_from_its_layer_in_the_direction_drawn(save):
    document, space = drawing(5)
    room(space, 100)
    space.add_line((700, 100), (700, 500), dxfattribs={"layer": "Path"})
    space.add_line((700, 500), (100, 500), dxfattribs={"layer": "Path"})
    plan = plan_of(import_dxf(save(document)), "x")
    assert plan.paths[0].points == ((7, 1), (7, 5), (1, 5))


def test_a_proposed_path_stays_inside_though_there_is_more_room_outside(save):
    document, space = drawing()
    outline = [(0, 0), (30, 0), (30, 3), (3, 3), (3, 30), (0, 30), (0, 0)]  # an L in a far larger square
    space.add_lwpolyline(outline)
    plan = plan_of(import_dxf(save(document)), "x")
    assert all(x < 3 or y < 3 for x, y in plan.paths[0].points)
    assert plan.paths[0].line.length > 25


def test_where_no_chair_fits_there_is_no_path_and_it_is_said(save):
    document, space = drawing()
    space.add_lwpolyline([(0, 0), (4, 0), (4, 0.5), (0, 0.5), (0, 0)])
    draft = import_dxf(save(document))
    assert draft.document["paths"] == []
    assert "no path yet" in draft.words[1]


def nested(document, levels, times):
    """Blocks in blocks, `times` in each: times ** levels lines."""
    document.blocks.new("B0").add_line((0, 0), (1, 0))
    for level in range(1, levels + 1):
        block = document.blocks.new(f"B{level}")
        for number in range(times):
            block.add_blockref(f"B{level - 1}", (number, level))
    document.modelspace().add_blockref(f"B{levels}", (0, 0))


def test_what_grows_without_end_is_refused(save, monkeypatch):
    monkeypatch.setattr(dxf_lines, "MOST_ENTITIES", 2000)
    document, _ = drawing()
    nested(document, 8, 8)
    with pytest.raises(ValueError, match="things in it"):
        import_dxf(save(document))
    document, _ = drawing()
    nested(document, 20, 1)
    with pytest.raises(ValueError, match="deep"):
        import_dxf(save(document))
    document, space = drawing()
    document.blocks.new("POST").add_line((0, 0), (1, 0))
    space.add_blockref("POST", (0, 0), {"row_count": 30_000, "column_count": 30_000})
    with pytest.raises(ValueError, match="900,000,000 times"):
        import_dxf(save(document))


def test_a_block_in_itself_is_refused(save):
    document, space = drawing()
    block = document.blocks.new("LOOP")
    block.add_line((0, 0), (1, 0))
    block.add_blockref("LOOP", (1, 1))
    space.add_blockref("LOOP", (0, 0))
    with pytest.raises(ValueError, match=r"hall\.dxf: "):
        import_dxf(save(document))


@pytest.mark.parametrize("x", [1e9, 1e30, -1e300])
def test_places_far_away_are_refused(save, x):
    document, space = drawing()
    room(space)
    space.add_line((0, 0), (x, 0))
    with pytest.raises(ValueError, match="far away"):
        import_dxf(save(document))


def test_places_that_are_no_numbers_are_refused(save):
    document, space = drawing()
    room(space)
    space.add_line((0, 0), (123.25, 0))
    file = save(document)
    file.write_text(file.read_text().replace("123.25", "nan"))
    with pytest.raises(ValueError, match=r"hall\.dxf: ") as refused:
        import_dxf(file)
    assert "\n" not in str(refused.value)


@pytest.mark.parametrize(
    ("content", "words"),
    [
        (b"", "no DXF drawing"),
        (b"AC1027 and more", "DWG"),
        (b"hello", "no DXF drawing"),
        (b"\x89PNG\r\n\x1a\n", "no DXF drawing"),
    ],
)
def test_what_is_no_drawing_is_refused(tmp_path, content, words):
    file = tmp_path / "plan.dxf"
    file.write_bytes(content)
    with pytest.raises(ValueError, match=words):
        import_dxf(file)


def test_missing_empty_and_too_large_files_are_refused(tmp_path, save, monkeypatch):
    with pytest.raises(ValueError, match="no such file"):
        import_dxf(tmp_path / "none.dxf")
    document, _ = drawing()
    with pytest.raises(ValueError, match="no lines"):
        import_dxf(save(document))
    monkeypatch.setattr(dxf_lines, "MOST_BYTES", 1000)
    with pytest.raises(ValueError, match="larger than"):
        import_dxf(save(document))


def test_too_many_wall_pieces_are_refused_and_collinear_ones_do_not_count(save):
    document, space = drawing()
    for number in range(5200):
        space.add_line((number * 0.01, 0), (number * 0.01 + 0.01, 0))
    room(space)
    assert import_dxf(save(document)).words[0] == "4 wall pieces."
    for number in range(5200):
        space.add_line((number * 0.01, 7), (number * 0.01, 7.5))
    with pytest.raises(ValueError, match=r"wall pieces and at most 5,000"):
        import_dxf(save(document))


def as_bytes():
    document, space = drawing()
    room(space)
    block = document.blocks.new("B")
    block.add_lwpolyline([(0, 0, 1), (1, 1, 0)], format="xyb")
    space.add_blockref("B", (2, 2), {"row_count": 2, "row_spacing": 1})
    space.add_arc((3, 3), 1, 0, 90)
    text = io.StringIO()
    document.write(text)
    return text.getvalue().encode()


WHOLE = as_bytes()
START = WHOLE.rindex(b"ENTITIES")
mutations = st.lists(
    st.tuples(
        st.integers(START - 3000, len(WHOLE) - 1) | st.integers(0, len(WHOLE) - 1),
        st.sampled_from([b"", b"\0", b"nan", b"1e308", b"-1", b"\n", b"INSERT", b"999999999", b"\xff"])
        | st.binary(max_size=4),
        st.integers(0, 12),
    ),
    min_size=1,
    max_size=6,
)


@settings(max_examples=40, suppress_health_check=[HealthCheck.function_scoped_fixture], deadline=None)
@given(mutations)
def test_a_damaged_drawing_is_read_or_refused_in_one_sentence(tmp_path, changes):
    content = WHOLE
    for at, new, removed in changes:
        content = content[:at] + new + content[at + removed :]
    file = tmp_path / "damaged.dxf"
    file.write_bytes(content)
    try:
        draft = import_dxf(file)
    except ValueError as refused:
        sentence = str(refused)
        assert sentence.startswith(f"{file}: ")
        assert "\n" not in sentence
    else:
        assert json.loads(json.dumps(draft.document, allow_nan=False))["walls"]


@settings(max_examples=25, suppress_health_check=[HealthCheck.function_scoped_fixture], deadline=None)
@given(st.integers(0, len(WHOLE)))
def test_a_drawing_that_is_cut_off_is_read_or_refused(tmp_path, end):
    file = tmp_path / "cut.dxf"
    file.write_bytes(WHOLE[:end])
    try:
        assert import_dxf(file).document["walls"]
    except ValueError as refused:
        assert re.match(rf"{re.escape(str(file))}: [^\n]+$", str(refused))  # noqa: PT017


def test_the_drawing_of_the_mutations_is_whole(tmp_path):
    file = tmp_path / "whole.dxf"
    file.write_bytes(WHOLE)
    assert import_dxf(file).document["paths"]
