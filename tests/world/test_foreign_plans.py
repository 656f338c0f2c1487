"""Small files as other programs write them, each with the plan that is right for it."""

import pytest

from app.world.imports.draft import plan_of
from app.world.imports.options import Options
from app.world.imports.plan_files import import_plan
from folders import SHARED

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
    assert "8.0 x 5.0 m large" in draft.messages[1]
    assert "unknown" in draft.messages[2]


def test_a_small_flat_has_a_way():
    _, plan = imported("map-small-flat.yaml")
    assert plan.paths[0].line.length >= 6


def test_a_noisy_scan_is_made_simpler_and_says_so():
    draft, plan = imported("map-noisy-scan.yaml")
    assert len(plan.segments()) < 5000
    area = float(draft.messages[1].partition("with ")[2].split(" ")[0])
    assert area == pytest.approx(137, abs=6)
    assert any("too many wall pieces" in words for words in draft.messages)


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
    assert "1 invisible" in " ".join(draft.messages)


def test_another_file_is_named():
    assert "1 WALLS_EG" in " ".join(imported("dxf-xref.dxf")[0].messages)


def test_the_size_in_inches_and_in_centimetres_is_said():
    words = " ".join(imported("dxf-inch-flag-drawn-in-cm.dxf")[0].messages)
    assert "30.5 x 20.3 m large, in inch as it says (12.0 x 8.0 m in cm)" in words
