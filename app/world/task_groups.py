"""The groups of tasks on the page where a person chooses one."""

from typing import Literal

from app.world.scene import DrivingPlace

TaskGroup = Literal["first", "corridors", "doors", "obstacles", "following", "outdoors", "own"]

_SCENES: dict[str, TaskGroup] = {
    "turning": "first",
    "backing": "first",
    "skills": "first",
    "building": "corridors",
    "door": "doors",
    "obstacles": "obstacles",
    "follow_me": "following",
    "follow_chair": "following",
    "desert": "outdoors",
}
_BUILDINGS: dict[str, TaskGroup] = {"corridors": "first", "clinic": "corridors", "apartment": "doors"}


def group_of(place: DrivingPlace) -> TaskGroup:
    """Return the group of a place to drive in; what does not come with the software is the clinic's own."""
    if place.scene is not None:
        return _SCENES.get(place.scene.name, "own")
    return _BUILDINGS.get(place.plan.name, "own")
