"""Floor plans from DXF drawings: units, shapes, blocks, layers, the path."""

import math

import pytest
from world.drawings import drawing, room, room_drawing

from app.world.imports.draft import plan_of
from app.world.imports.dxf import import_dxf


def corners(draft):
    return {tuple(point) for wall in draft.document["walls"] for point in wall}


@pytest.mark.parametrize(("code", "scale"), [(1, 0.0254), (2, 0.3048), (4, 0.001), (5, 0.01), (6, 1.0)])
def test_a_room_in_each_unit_is_as_large_as_it_is(save, code, scale):
    document, space = drawing(code)
    room(space, 1 / scale, at=(1000, -500))
    draft = import_dxf(save(document))
    plan = plan_of(draft, "hall.dxf")
    assert plan.bounds == pytest.approx((0, 0, 8, 6), abs=2e-3)
    assert str(draft.messages[0]) == "4 wall pieces."
    assert "proposal" in str(draft.messages[1])
    assert plan.paths[0].line.length > 2


def test_without_a_unit_it_must_be_given(save):
    document, _ = room_drawing(0)
    file = save(document)
    with pytest.raises(ValueError, match="does not say in which unit"):
        import_dxf(file)
    assert plan_of(import_dxf(file, unit="m"), "x").bounds == pytest.approx((0, 0, 8, 6))
    with pytest.raises(ValueError, match="'yard' is not known"):
        import_dxf(file, unit="yard")
    with pytest.raises(ValueError, match="give its unit"):
        import_dxf(file, unit="mm")


def test_what_the_drawing_says_can_be_overruled(save):
    document, _ = room_drawing(4)
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
    document, space = room_drawing()
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
    assert "1 SPLINE" in str(draft.messages[-1])
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
    assert "no path yet" in str(draft.messages[1])
