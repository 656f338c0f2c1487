"""The titles of paths: of bundled and of own floor plans; the name where there is none."""

import json
from pathlib import Path

import pytest

from app.world.path_titles import find_floorplan, path_title
from app.world.scene import bundled_places

OWN = {
    "name": "storey",
    "title": "First floor",
    "walls": [],
    "paths": [
        {"name": "a1", "title": "To the lift", "points": [[0, 0], [4, 0]], "instruction": "Go.", "time_limit": 60.0}
    ],
}


@pytest.fixture
def own(tmp_path: Path) -> Path:
    folder = tmp_path / "floorplans"
    folder.mkdir()
    (folder / "storey.json").write_text(json.dumps(OWN))
    (folder / "damaged.json").write_text("{")
    (tmp_path / "outside.json").write_text(json.dumps(OWN))
    return folder


def test_every_bundled_path_has_its_title(own: Path) -> None:
    places = bundled_places()
    assert "apartment" in places
    for name, place in places.items():
        assert [str(path_title(own, name, path.name)) for path in place.plan.paths] == [
            path.title for path in place.plan.paths
        ]


def test_a_path_of_an_own_floor_plan_has_its_title(own: Path) -> None:
    assert path_title(own, "storey", "a1") == "To the lift"


@pytest.mark.parametrize(
    ("floorplan", "path"),
    [("storey", "b2"), ("gone", "a1"), ("damaged", "a1"), ("../outside", "a1"), ("apartment", "x")],
)
def test_a_path_that_is_gone_keeps_its_name(own: Path, floorplan: str, path: str) -> None:
    assert path_title(own, floorplan, path) == path


def test_only_floor_plans_of_the_folder_are_read(own: Path) -> None:
    assert find_floorplan(own, "../outside") is None
