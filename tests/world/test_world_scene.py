import json

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from app.world.collision import Collision
from app.world.floorplan import bundled_floorplans
from app.world.scene import bundled_places, bundled_scenes, find_place, is_scene, load_scene
from app.world.tasks import Turn

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


@settings(max_examples=60, deadline=None)
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
    places = bundled_places()
    assert {path.task.kind for offer in places.values() for path in offer.plan.paths} == {
        "path",
        "follow",
        "turn",
        "back",
        "course",
    }
    assert not set(bundled_floorplans()) & set(bundled_scenes()), "a name means one place"
    assert all(name == offer.plan.name for name, offer in places.items())
    assert [is_scene(file) for file in (*bundled_scenes().values(), *bundled_floorplans().values())] == [
        *[True] * len(bundled_scenes()),
        *[False] * len(bundled_floorplans()),
    ]


@pytest.mark.parametrize("name", bundled_places())
def test_each_task_can_be_begun_and_each_cone_can_be_missed(name):
    plan = find_place(name)
    collision = Collision(plan)
    for path in plan.paths:
        assert collision.is_free(path.start.x, path.start.y)
        if isinstance(path.task, Turn):
            continue
        line = path.line
        for step in range(int(line.length / 0.05) + 1):
            x, y = line.point_at(0.05 * step)
            assert all((x - c.position[0]) ** 2 + (y - c.position[1]) ** 2 > (c.radius + 0.4) ** 2 for c in plan.cones)


@pytest.mark.parametrize("name", sorted({name.partition(".")[0] for name in bundled_places() if "." in name}))
def test_a_harder_level_is_harder(name):
    easy, hard = find_place(f"{name}.easy"), find_place(f"{name}.hard")
    assert easy is not None
    assert easy.model_dump(exclude={"name", "title"}) != hard.model_dump(exclude={"name", "title"})
    assert [path.name for path in easy.paths] == [path.name for path in hard.paths]
