import json
import math
import shutil

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from app.settings import data_folder
from app.world.collision import Collision
from app.world.encounter import Encounters
from app.world.floorplan import bundled_floorplans
from app.world.progress import leader_of, parts_of
from app.world.scene import at_level, bundled_places, bundled_scenes, find_place, is_scene, load_scene
from app.world.tasks import Course

PLACES = bundled_places()
LEVELS = [{"name": "easy", "title": "Easy"}, {"name": "hard", "title": "Hard"}]
PATH = {"name": "main", "title": "Main", "points": [[0, 0], [4, 0]], "instruction": "Go."}


def scene(tmp_path, **changes):
    file = tmp_path / "mine.json"
    document = {"name": "mine", "title": "Mine", "about": "A place.", "paths": [PATH], **changes}
    file.write_text(json.dumps(document))
    return file


def test_a_value_may_differ_between_levels_wherever_it_stands(tmp_path):
    gap = {"label": "gap", "position": [2, 0], "width": {"easy": 1.2, "hard": 0.8}}
    far = {**PATH, "points": {"easy": [[0, 0], [4, 0]], "hard": [[0, 0], [{"easy": 1, "hard": 9}, 0]]}}
    read = load_scene(scene(tmp_path, levels=LEVELS, gaps=[gap], paths=[far]))
    assert {level: plan.name for level, plan in read.plans.items()} == {"easy": "mine.easy", "hard": "mine.hard"}
    assert [plan.gaps[0].width for plan in read.plans.values()] == [1.2, 0.8]
    assert [plan.paths[0].points[1][0] for plan in read.plans.values()] == [4, 9]
    assert read.plans["hard"].title == "Mine, hard"


VALUES = st.recursive(
    st.none() | st.integers() | st.text(max_size=3),
    lambda x: st.lists(x, max_size=3) | st.dictionaries(st.sampled_from("abc"), x, max_size=3),
    max_leaves=6,
)


@settings(max_examples=60, deadline=None)
@given(VALUES, VALUES, VALUES)
def test_only_what_is_graded_differs_between_levels(same, easy, hard):
    document = {"same": same, "list": [same, {"easy": easy, "hard": hard}]}
    for level, value in (("easy", easy), ("hard", hard)):
        assert at_level(document, level, ["easy", "hard"], "any") == {"same": same, "list": [same, value]}


def test_a_scene_without_levels_is_one_plan(tmp_path):
    assert list(load_scene(scene(tmp_path)).plans) == [None]
    assert load_scene(scene(tmp_path)).plans[None].name == "mine"


def test_what_stands_in_its_building_stands_in_the_scene(tmp_path):
    crate = {"kind": "box", "label": "crate", "position": [1, 13], "size": [0.5, 0.5]}
    path = {**PATH, "points": [[1.2, 7], [9, 7]]}
    plan = load_scene(scene(tmp_path, floorplan="clinic", obstacles=[crate], paths=[path])).plans[None]
    clinic = find_place("clinic")
    assert plan.walls == clinic.walls
    assert plan.obstacles[:-1] == clinic.obstacles
    assert plan.obstacles[-1].label == "crate"
    assert [path.name for path in plan.paths] == ["main"]


@pytest.mark.parametrize(
    ("changes", "words"),
    [
        ({"about": None}, "about"),
        ({"levels": [*LEVELS, LEVELS[0]]}, "levels: a level stands there twice"),
        ({"levels": [{"name": "insane", "title": "Insane"}]}, "levels[0].name"),
        ({"floorplan": "nowhere"}, "there is no floor plan 'nowhere'"),
        ({"paths": []}, "paths"),
        ({"cones": [{"position": [0, "x"]}]}, "cones[0].position[1]"),
        (
            {"levels": LEVELS, "cones": [{"position": [0, {"easy": 1, "hard": "x"}]}]},
            "level hard, cones[0].position[1]",
        ),
        (
            {"levels": LEVELS, "gaps": [{"label": "gap", "position": [2, 0], "width": {"easy": 1.2}}]},
            "level hard, gaps[0].width: there is no value for level hard, add it",
        ),
        (
            {"levels": LEVELS, "wall_height": {"easy": 2, "medium": 2, "hard": 2}},
            "wall_height: the scene has no level medium",
        ),
        ({"wall_height": {"easy": 2}}, "wall_height: without levels give one value"),
        ({"levels": LEVELS[:1], "easy": 5}, "easy: this is not known here"),
        ({"rooms": json.loads("[" * 40 + "]" * 40)}, "not nested so deeply"),
        ({"cones": [{"position": [2, 0.4]}]}, "the obstacle 'cone 1' near (2.00, 0.00)"),
        ({"ground": {"dunes": [{"position": [0, 0], "radius": 3}]}}, "give the ground its area"),
        ({"ground": {"area": [0, 0, 4, 4], "dunes": [{"position": [6, 2], "radius": 3}]}}, "dune 1 reaches into"),
        ({"unknown": 1}, "unknown: this is not known here"),
        (
            {"obstacles": [{"kind": "cylinder", "label": "rock", "position": [2, 0.5], "radius": 0.4}]},
            "the obstacle 'rock'",
        ),
    ],
)
def test_what_is_wrong_is_said_with_its_place(tmp_path, changes, words):
    with pytest.raises(ValueError) as error:  # noqa: PT011  (the words are looked at below)
        load_scene(scene(tmp_path, **changes))
    assert str(error.value).startswith(str(tmp_path / "mine.json"))
    assert words in str(error.value)


@given(
    st.recursive(
        st.none() | st.booleans() | st.floats() | st.text(max_size=5),
        lambda x: st.lists(x) | st.dictionaries(st.text(max_size=5), x),
        max_leaves=8,
    )
)
def test_any_document_is_a_scene_or_a_sentence(tmp_path_factory, document):
    file = tmp_path_factory.mktemp("scenes") / "any.json"
    file.write_text(json.dumps(document))
    with pytest.raises(ValueError, match=r"any\.json"):
        load_scene(file)


@pytest.mark.parametrize("content", [b"", b"[", b"\xff", b"[" * 100_000])
def test_what_is_no_json_is_said(tmp_path, content):
    file = tmp_path / "cut.json"
    file.write_bytes(content)
    with pytest.raises(ValueError, match="this is not JSON"):
        load_scene(file)
    with pytest.raises(ValueError, match="no such file"):
        load_scene(tmp_path / "nowhere.json")


def test_the_bundled_places_hold_every_kind_of_task():
    assert {path.task.kind for offer in PLACES.values() for path in offer.plan.paths} == {
        "path",
        "follow",
        "turn",
        "back",
        "course",
    }
    assert not set(bundled_floorplans()) & set(bundled_scenes()), "a name means one place"
    assert all(name == offer.plan.name for name, offer in PLACES.items())
    assert all(find_place(name) == PLACES[name].plan for name in ("desert.hard", "clinic"))
    assert [find_place(name) for name in ("desert", "desert.", "nowhere.easy", "")] == [None] * 4
    assert [is_scene(file) for file in (*bundled_scenes().values(), *bundled_floorplans().values())] == [
        *[True] * len(bundled_scenes()),
        *[False] * len(bundled_floorplans()),
    ]


@pytest.mark.parametrize("name", PLACES)
def test_each_task_can_be_begun_with_nobody_in_the_way(name):
    plan = PLACES[name].plan
    collision, movers = Collision(plan), Encounters(plan.movers)
    for path in plan.paths:
        x, y, _ = path.start
        assert collision.is_free(x, y)
        assert movers.slide(x, y, x, y, 0.0) == (x, y, False)


@pytest.mark.parametrize("name", PLACES)
def test_each_line_stays_on_the_ground_and_clear_of_cones(name):
    plan = PLACES[name].plan
    x_min, y_min, x_max, y_max = plan.ground.area or plan.bounds
    lines = [mover.line for mover in plan.movers]
    for path in plan.paths:
        lines += [part.line for part in (parts_of(path, path.task) if isinstance(path.task, Course) else [path])]
    for line in lines:
        for s in np.arange(0.0, line.length, 0.1):
            x, y = line.point_at(s)
            assert x_min < x < x_max
            assert y_min < y < y_max
            assert all(math.dist((x, y), cone.position) > cone.radius + 0.4 for cone in plan.cones)


@pytest.mark.parametrize("name", [name for name, offer in PLACES.items() if offer.scene])
def test_a_scene_leaves_a_novice_time_enough(name):
    for path in PLACES[name].plan.paths:
        assert path.time_limit >= 60
        assert path.line.length / path.time_limit < 0.15, "m/s, on the whole way"


@pytest.mark.parametrize("name", [name for name, offer in PLACES.items() if offer.plan.movers])
def test_a_leader_waits_where_the_asked_distance_is_kept_and_arrives_in_time(name):
    plan = PLACES[name].plan
    for path in plan.paths:
        track = leader_of(plan, path)
        assert track is not None
        ahead = track.at(0.0).pose
        assert math.dist(ahead[:2], path.start[:2]) == pytest.approx(path.task.distance, abs=0.01)
        assert track.mover.way(path.time_limit / 2)[0] > track.length
        speeds = {v for _, v in track.mover.pace if v > 0}
        assert len(speeds) >= 4
        assert max(speeds) <= 0.7, "m/s, what a patient's chair can follow"
        assert track._line.points[-1] == path.points[-1]


@pytest.mark.parametrize("name", [name for name, offer in PLACES.items() if offer.plan.gaps])
def test_a_gap_is_as_wide_as_it_says(name):
    plan = PLACES[name].plan
    for gap in plan.gaps:
        across = gap.heading + math.pi / 2
        for side in (-1, 1):
            edge = [
                p + side * (gap.width / 2 - 0.002) * f(across)
                for p, f in zip(gap.position, (math.cos, math.sin), strict=True)
            ]
            assert 0.0 < Collision(plan, 0.0).room(*edge) < 0.003, gap.label


@pytest.mark.parametrize("name", sorted({name.partition(".")[0] for name in PLACES if "." in name}))
def test_a_harder_level_is_harder(name):
    easy, hard = PLACES[f"{name}.easy"].plan, PLACES[f"{name}.hard"].plan
    assert easy.model_dump(exclude={"name", "title"}) != hard.model_dump(exclude={"name", "title"})
    assert [path.name for path in easy.paths] == [path.name for path in hard.paths]


def test_the_bundled_places_are_validated_once_and_again_after_a_change(tmp_path, monkeypatch):
    for folder in ("scenes", "floorplans"):
        shutil.copytree(data_folder() / folder, tmp_path / folder)
    for module in ("scene", "floorplan"):
        monkeypatch.setattr(f"app.world.{module}.data_folder", lambda: tmp_path)
    before = bundled_places()
    assert all(place is before[name] for name, place in bundled_places().items())
    base = tmp_path / "floorplans" / "clinic.json"  # other scenes are made from it
    document = json.loads(base.read_text())
    base.write_text(json.dumps(document | {"wall_height": 2.25}))
    after = bundled_places()
    inherited = [name for name, place in after.items() if place.scene and place.scene.floorplan == "clinic"]
    assert inherited
    assert {after[name].plan.wall_height for name in ("clinic", *inherited)} == {2.25}
