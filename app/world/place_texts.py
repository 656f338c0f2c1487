"""The texts of the bundled floor plans and scenes in the reader's language; those of a clinic's own plan stay.

The documents are English; the messages stand in web_static/words/LANGUAGE/server/places.ftl. Labels of obstacles and
gaps have no messages: the label of an obstacle chooses its shape in 3D, and only the editor of floor plans shows them.
"""

import re
from collections.abc import Iterator, Mapping
from contextlib import suppress
from functools import lru_cache

from app.texts import Text
from app.world.floorplan import FloorPlan, PrescribedPath
from app.world.scene import DrivingPlace, bundled_place
from app.world.tasks import Course


def place_text(plan: str, text: str) -> Text | str:
    """Return the message of a text of a bundled floor plan.

    Parameters
    ----------
    plan
        Name of the floor plan, such as `clinic` or `desert.hard`.
    text
        A title, an instruction or the label of a room, as it stands in the plan's document.

    Returns
    -------
    Text or str
        `text` itself when the plan is not bundled, or has no such text.
    """
    with suppress(ValueError):  # a damaged file has no messages
        return _messages(plan).get(text, text)
    return text


def plan_for_reader(plan: FloorPlan) -> FloorPlan:
    """Return a floor plan with its titles, instructions and labels of rooms in the language of the reader."""

    def shown(text: str) -> str:
        return str(place_text(plan.name, text))

    def shown_path(path: PrescribedPath) -> PrescribedPath:
        task = path.task
        if isinstance(task, Course):
            stages = (
                stage.model_copy(update={"title": shown(stage.title), "instruction": shown(stage.instruction)})
                for stage in task.stages
            )
            task = task.model_copy(update={"stages": tuple(stages)})
        words = {"title": shown(path.title), "instruction": shown(path.instruction)}
        return path.model_copy(update={**words, "task": task})

    return plan.model_copy(
        update={
            "title": shown(plan.title),
            "rooms": tuple(room.model_copy(update={"label": shown(room.label)}) for room in plan.rooms),
            "paths": tuple(map(shown_path, plan.paths)),
        }
    )


def messages_in(place: DrivingPlace) -> Iterator[tuple[str, Text]]:
    """Yield the texts of a bundled place that people see, each with its message.

    Rooms and stages have no names: their messages are named after their English labels and titles.
    """
    plan, scene, level = place
    document = plan.name.partition(".")[0]
    title = _message(document, "title")
    if scene is not None:
        yield scene.title, title
        yield scene.about, _message(document, "about")
    if level is None:
        yield plan.title, title
    else:
        yield level.title, _message("level", level.name)
        yield plan.title, Text(f"scene-at-{level.name}", scene=title)
    for room in plan.rooms:
        yield room.label, _message("room", room.label)
    for path in plan.paths:
        yield path.title, _message(document, path.name, "title")
        yield path.instruction, _message(document, path.name, "instruction")
        for stage in path.task.stages if isinstance(path.task, Course) else ():
            yield stage.title, _message(document, path.name, stage.title, "title")
            yield stage.instruction, _message(document, path.name, stage.title, "instruction")


@lru_cache(maxsize=256)
def _messages(plan: str) -> Mapping[str, Text]:
    place = bundled_place(plan)
    return {} if place is None else dict(messages_in(place))


def _message(*words: str) -> Text:
    key = re.sub("[^a-z0-9]+", "-", " ".join(words).lower())
    return Text(f"place-{key}")
