import json
import math
from itertools import pairwise

import pytest
from pydantic import ValidationError
from world.storey import storey

from app.world.floorplan import MAX_WALLS, FloorPlan, bundled_floorplans, load_floorplan
from app.world.footprint import CHAIR_RADIUS
from app.world.imports.file_limits import MOST_PLAN_BYTES
from app.world.imports.map_draft import NARROW
from folders import ROOT


def document(**changes):
    plan = {
        "name": "test",
        "title": "Test",
        "walls": [[[0, 0], [10, 0], [10, 6], [0, 6], [0, 0]]],
        "obstacles": [{"kind": "box", "label": "table", "position": [5, 4.5], "size": [2, 1], "height": 0.74}],
        "paths": [{"name": "main", "title": "Main", "points": [[1, 1], [9, 1]], "instruction": "Follow the line."}],
    }
    return plan | changes


def path(points, **changes):
    return {"name": "main", "title": "Main", "points": points, "instruction": "Go."} | changes


def write(tmp_path, content):
    file = tmp_path / "plan.json"
    file.write_text(content if isinstance(content, str) else json.dumps(content))
    return file


def test_a_plan_in_numbers(tmp_path):
    plan = load_floorplan(write(tmp_path, document()))
    assert plan.bounds == (0, 0, 10, 6)
    assert plan.segments().shape == (8, 4)
    assert plan.segments()[0].tolist() == [0, 0, 10, 0]
    assert {tuple(row) for row in plan.segments()[4:, :2].tolist()} == {(4, 4), (6, 4), (6, 5), (4, 5)}
    assert plan.path_named("main").start == (1, 1, 0)
    assert FloorPlan.model_validate_json(plan.model_dump_json()) == plan


def test_a_turned_box():
    plan = storey(obstacles=[{"kind": "box", "label": "b", "position": (0, 0), "size": (2, 1), "angle": math.pi / 2}])
    box = plan.obstacles[0]
    for corner, expected in zip(box.corners(), [(0.5, -1), (0.5, 1), (-0.5, 1), (-0.5, -1)], strict=True):
        assert corner == pytest.approx(expected)
    assert box.covers(0, 0.9)
    assert not box.covers(0.9, 0)


def test_the_chair_starts_along_the_path_or_with_the_given_heading():
    plan = storey(path=[(0, 0), (0, 3)])
    assert plan.paths[0].start.theta == pytest.approx(math.pi / 2)
    told = FloorPlan.model_validate(document(paths=[path([[1, 1], [9, 1]], start_heading=-1.0)]))
    assert told.paths[0].start.theta == -1


def test_an_unknown_path_is_refused_with_the_known_ones():
    with pytest.raises(ValueError, match="no path 'nowhere': use one of main"):
        storey().path_named("nowhere")


@pytest.mark.parametrize(
    ("changes", "words"),
    [
        ({"paths": []}, "paths"),
        ({"paths": [path([[1, 1], [1, 1]])]}, "path 'main': a line needs at least two different points"),
        ({"paths": [path([[1, 1]])]}, "paths[0].points"),
        ({"paths": [path([[1, 1], [9, 1]]), path([[1, 2], [9, 2]])]}, "path 'main' stands there twice"),
        ({"paths": [path([[1, 1], [1, 9]])]}, "path 'main' comes within 0.00 m of a wall near (1.00, 6.00)"),
        ({"paths": [path([[1, 0.2], [9, 0.2]])]}, "within 0.15 m of a wall"),
        ({"paths": [path([[5, 4.5], [5, 2]])]}, "within 0.00 m of the obstacle 'table'"),
        ({"paths": [path([[1, 3.8], [9, 3.8]])]}, "within 0.20 m of the obstacle 'table'"),
        ({"paths": [path([[1, 1], [9, math.nan]])]}, "paths[0].points[1][1]"),
        ({"paths": [path([[1, 1], [9, 1]], goal_radius=True)]}, "paths[0].goal_radius"),
        ({"walls": [[[0, 0]]]}, "walls[0]"),
        ({"walls": [[[0, "1"], [1, 1]]]}, "walls[0][0][1]"),
        ({"wall_height": -1}, "wall_height"),
        ({"colour": "red"}, "colour"),
        ({"obstacles": [{"kind": "sphere"}]}, "obstacles[0]"),
        ({"name": "../plan"}, "name"),
    ],
)
def test_a_bad_plan_is_refused_in_one_sentence_with_file_and_place(tmp_path, changes, words):
    file = write(tmp_path, document(**changes))
    with pytest.raises(ValueError, match=r"plan\.json") as refused:
        load_floorplan(file)
    sentence = str(refused.value)
    assert sentence.startswith(str(file))
    assert words in sentence
    assert "\n" not in sentence


@pytest.mark.parametrize("content", ["", "[]", "{", "12", "\ud800".encode("utf-8", "surrogatepass").hex(), '"plan"'])
def test_what_is_no_document_is_refused(tmp_path, content):
    with pytest.raises(ValueError, match=r"plan\.json"):
        load_floorplan(write(tmp_path, content))


def test_a_missing_file_and_a_folder_are_refused(tmp_path):
    with pytest.raises(ValueError, match="no such file"):
        load_floorplan(tmp_path / "none.json")
    with pytest.raises(ValueError, match="cannot be read"):
        load_floorplan(tmp_path)


def test_the_bundled_plans_are_what_their_names_say():
    files = bundled_floorplans()
    assert list(files) == ["apartment", "clinic", "corridors"]
    plans = {name: load_floorplan(file) for name, file in files.items()}
    for name, plan in plans.items():
        assert plan.name == name
        assert plan.paths[0].name == "main"
        assert len(plan.paths) >= 2
        assert min(other.line.length for other in plan.paths) < plan.paths[0].line.length
        assert all(door.width >= 0.9 for door in plan.doors)
    clinic = plans["clinic"].path_named("main").line
    assert clinic.length == pytest.approx(28)
    turns = [clinic.heading_at(s) for s in (1, 5, 13, 17, 23)]
    bends = [abs(math.remainder(b - a, math.tau)) for a, b in pairwise(turns)]
    assert bends == pytest.approx([math.pi / 2] * 4)


@pytest.mark.parametrize("name", ["apartment", "clinic", "corridors"])
def test_a_bundled_door_stands_in_a_gap_of_its_width(name):
    plan = load_floorplan(bundled_floorplans()[name])
    ends = [wall[end] for wall in plan.walls for end in (0, -1)] + [point for wall in plan.walls for point in wall]
    for door in plan.doors:
        for side in (-1, 1):
            across = door.heading + side * math.pi / 2
            post = (
                door.position[0] + door.width / 2 * math.cos(across),
                door.position[1] + door.width / 2 * math.sin(across),
            )
            assert min(math.dist(post, end) for end in ends) < 0.01, door


@pytest.mark.parametrize("walls", [["x"] * 100_000, [[[0, "x"]] * 1000] * 100])
def test_of_a_long_list_the_first_error_is_reported(walls):
    """To collect every one of them would keep the web process from all other work."""
    with pytest.raises(ValidationError) as refused:
        FloorPlan.model_validate_json(json.dumps({"name": "a", "title": "A", "walls": walls, "paths": []}))
    assert refused.value.error_count() <= 3


def test_the_manual_has_the_numbers_of_the_program():
    manual = (ROOT / "docs" / "floorplans.md").read_text(encoding="utf-8")
    assert f"a circle of {CHAIR_RADIUS:g} m radius" in manual
    first, second, last = NARROW[1:]
    narrow = f"narrower than {first:g} m, {second:g} m, then {last:g} m close (a chair of {2 * CHAIR_RADIUS:g} m"
    assert f"Above {MAX_WALLS} wall pieces a map is made simpler, and the import says so: spaces {narrow}" in manual
    assert f"(`FILE.dxf`, at most {MOST_PLAN_BYTES // 1_000_000} MB)" in manual
