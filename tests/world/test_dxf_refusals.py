"""DXF drawings that are refused: growing without end, damaged, far away, no drawings at all."""

import io
import json
import re

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from world.drawings import drawing, room, room_drawing

from app.world.imports import dxf_lines
from app.world.imports.dxf import import_dxf


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
    document, space = room_drawing()
    space.add_line((0, 0), (x, 0))
    with pytest.raises(ValueError, match="far away"):
        import_dxf(save(document))


def test_places_that_are_no_numbers_are_refused(save):
    document, space = room_drawing()
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
    monkeypatch.setattr(dxf_lines, "MOST_PLAN_BYTES", 1000)
    with pytest.raises(ValueError, match="larger than"):
        import_dxf(save(document))


def test_too_many_wall_pieces_are_refused_and_collinear_ones_do_not_count(save):
    document, space = drawing()
    for number in range(5200):
        space.add_line((number * 0.01, 0), (number * 0.01 + 0.01, 0))
    room(space)
    assert str(import_dxf(save(document)).messages[0]) == "4 wall pieces."
    for number in range(5200):
        space.add_line((number * 0.01, 7), (number * 0.01, 7.5))
    with pytest.raises(ValueError, match=r"wall pieces and at most 5,000"):
        import_dxf(save(document))


def as_bytes():
    document, space = room_drawing()
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
