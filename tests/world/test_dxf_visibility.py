"""What a drawing shows and hides: layers, invisible things, blocks, arrays, other files, units; all is said."""

import math

import ezdxf.xclip
import pytest
from world.drawings import drawing, room, room_drawing

from app.world.imports.dxf import import_dxf


def corners(draft):
    return {tuple(round(value, 3) for value in point) for wall in draft.document["walls"] for point in wall}


def said(draft):
    return " ".join(map(str, draft.messages))


def test_invisible_lines_and_blocks_are_left_out_and_counted(save):
    document, space = room_drawing()
    space.add_line((1, 1), (2, 2), dxfattribs={"layer": "WALLS", "invisible": 1})
    block = document.blocks.new("DOOR")
    block.add_line((0, 0), (1, 0))
    block.add_line((0, 0), (0, 1), dxfattribs={"invisible": 1})
    space.add_blockref("DOOR", (3, 3), {"layer": "WALLS"})
    space.add_blockref("DOOR", (5, 5), {"layer": "WALLS", "invisible": 1})
    draft = import_dxf(save(document))
    assert {(3, 3), (4, 3)} <= corners(draft)
    assert not corners(draft) & {(1, 1), (3, 4), (5, 5), (6, 5)}
    assert "3 invisible" in said(draft)


def block_with_two_layers(document):
    block = document.blocks.new("BED")
    block.add_line((0, 0), (1, 0), dxfattribs={"layer": "0"})
    block.add_line((0, 0), (0, 1), dxfattribs={"layer": "BEDS"})


@pytest.mark.parametrize(("hide", "shown"), [("off", {(3, 4)}), ("freeze", set())])
def test_of_a_block_on_a_layer_that_is_off_the_other_layers_are_shown_and_of_a_frozen_one_nothing(save, hide, shown):
    document, space = room_drawing()
    getattr(document.layers.add("THINGS"), hide)()
    block_with_two_layers(document)
    space.add_blockref("BED", (3, 3), {"layer": "THINGS"})
    draft = import_dxf(save(document))
    assert corners(draft) & {(3, 4), (4, 3)} == shown
    assert "off or frozen: 1 THINGS" in said(draft)


@pytest.mark.parametrize("layer", ["massivwand", "framed-wall", "Trockenbau_Massiv", "GRIDWALL", "textured", "CONTEXT"])
def test_a_layer_is_no_layer_of_words_because_of_a_part_of_a_word(save, layer):
    document, space = room_drawing()
    space.add_line((4, 0), (4, 4), dxfattribs={"layer": layer})
    assert (4, 4) in corners(import_dxf(save(document)))


@pytest.mark.parametrize(
    "layer", ["Text", "DIM-1", "A-ANNO-DIMS", "Bemaßung", "VERMASSUNG_1", "Defpoints", "Grid", "title block"]
)
def test_a_layer_that_is_left_out_by_its_name_is_named_with_its_lines(save, layer):
    document, space = room_drawing()
    for x in (2, 3):
        space.add_line((x, 1), (x, 4), dxfattribs={"layer": layer})
    draft = import_dxf(save(document))
    assert (3, 4) not in corners(draft)
    assert f"2 {layer}" in said(draft)
    chosen = import_dxf(save(document), layers=("WALLS", layer))
    assert (3, 4) in corners(chosen)
    assert "Left out" not in said(chosen)


def test_other_files_and_missing_blocks_are_named(save):
    document, space = room_drawing()
    document.add_xref_def("ground.dwg", "WALLS_EG")
    for _ in range(2):
        space.add_blockref("WALLS_EG", (0, 0))
    space.add_blockref("NOWHERE", (0, 0))
    draft = import_dxf(save(document))
    assert "other files, bind them to the drawing to have them: 2 WALLS_EG." in said(draft)
    assert "1 missing block" in said(draft)


def test_a_clipped_block_is_named(save):
    document, space = room_drawing()
    block_with_two_layers(document)
    clip = ezdxf.xclip.XClip(space.add_blockref("BED", (3, 3)))
    clip.set_block_clipping_path([(0, 0), (0.5, 0.5)])
    assert "1 clipped block, which is read whole" in said(import_dxf(save(document)))


@pytest.mark.parametrize("rotation", [0, 90, 30])
@pytest.mark.parametrize("scale", [1, -1, 2])
@pytest.mark.parametrize("extrusion", [(0, 0, 1), (0, 0, -1)])
def test_an_array_counts_in_the_axes_of_its_block_reference(save, rotation, scale, extrusion):
    document, space = drawing()
    room(space, 5, at=(-20, -15))
    document.blocks.new("COLUMN").add_line((0, 0), (0.4, 0), dxfattribs={"layer": "WALLS"})
    attributes = {"rotation": rotation, "xscale": scale, "extrusion": extrusion, "layer": "P"}
    attributes |= {"column_count": 3, "column_spacing": 3, "row_count": 2, "row_spacing": 2}
    space.add_blockref("COLUMN", (1, 2), attributes)
    turn, mirror = math.radians(rotation), extrusion[2]
    expected = set()
    for row in range(2):
        for column in range(3):
            x = 1 + column * 3 * math.cos(turn) - row * 2 * math.sin(turn)
            y = 2 + column * 3 * math.sin(turn) + row * 2 * math.cos(turn)
            expected.add((round(mirror * x + 20, 2), round(y + 15, 2)))  # from the lower left corner of the walls
    found = {(round(x, 2), round(y, 2)) for x, y in corners(import_dxf(save(document)))}
    near = {place for place in expected if any(math.dist(place, other) < 0.02 for other in found)}
    assert near == expected


def test_walls_that_are_drawn_as_multiple_lines_are_read(save):
    document, space = room_drawing()
    space.add_mline([(3, 0), (3, 4)], dxfattribs={"layer": "WALLS", "scale_factor": 0.2})
    assert {(3, 4), (3.2, 4)} <= corners(import_dxf(save(document)))


def test_texts_are_counted(save):
    document, space = room_drawing()
    space.add_text("HALL").set_placement((3, 3))
    space.add_mtext("KITCHEN")
    assert "2 texts and dimensions" in said(import_dxf(save(document)))


def test_the_size_and_where_its_unit_comes_from_are_said(save):
    document, _ = room_drawing()
    assert "The drawing is 8.0 x 6.0 m large, in m as it says." in said(import_dxf(save(document)))
    assert "as given, in m." in said(import_dxf(save(document), unit="m"))


def test_an_inch_that_may_be_a_centimetre_is_said(save):
    document, space = drawing(1)
    room(space, 100)
    assert "20.3 x 15.2 m large, in inches as it says (8.0 x 6.0 m in cm)" in said(import_dxf(save(document)))


@pytest.mark.parametrize(
    ("code", "scale", "other"),
    [(1, 1000, "8.0 x 6.0 m in mm"), (4, 100, "8.0 x 6.0 m in cm"), (6, 30, "73.2 x 54.9 m in feet")],
)
def test_the_unit_is_asked_for_when_the_size_is_improbable(save, code, scale, other):
    document, space = drawing(code)
    room(space, scale)
    with pytest.raises(ValueError, match="improbable for a storey, give its unit") as refused:
        import_dxf(save(document))
    assert other in str(refused.value)
    unit = {1: "mm", 4: "cm", 6: "foot"}[code]
    assert import_dxf(save(document), unit=unit).document["walls"]
