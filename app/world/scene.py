"""Scenes: practice places with tasks, some at several levels of difficulty. A scene at one level is a floor plan."""

import json
from collections.abc import Mapping, Sequence
from functools import lru_cache
from pathlib import Path
from typing import Annotated, Literal, NamedTuple, get_args

from pydantic import Field, ValidationError

from app.files import Stamp, stamp
from app.json_values import JsonObject, JsonValue
from app.quantities import Document, Line, Name, Title
from app.sentences import one_sentence
from app.settings import data_folder
from app.texts import Text
from app.world.floorplan import MAX_BYTES, FloorPlan, bundled_floorplans, load_floorplan

LevelName = Literal["easy", "medium", "hard"]
LEVEL_NAMES = frozenset(get_args(LevelName))
INHERITED = ("walls", "obstacles", "rooms", "doors", "wall_height", "wall_thickness")  # from a scene's floor plan
DEEPEST = 20  # levels of nesting in a document


class Level(Document):
    """A level of difficulty: its name in the plan's name, and its title for people."""

    name: LevelName
    title: Title


class SceneHead(Document):
    """The fields of a scene that a floor plan does not have."""

    name: Name
    title: Title
    about: Annotated[Line, Field(min_length=1, max_length=300)]
    levels: Annotated[tuple[Level, ...], Field(min_length=1, max_length=3)] | None = None
    floorplan: Name | None = None  # a bundled one, from which walls, obstacles, rooms and doors are inherited


class Scene(NamedTuple):
    """A scene with its floor plan for each level, or one plan under None when it has no levels."""

    head: SceneHead
    plans: dict[LevelName | None, FloorPlan]


def load_scene(file: Path) -> Scene:
    """Read a scene from a JSON file.

    A value that differs between levels is an object with one entry for each level.

    Raises
    ------
    ValueError
        One sentence that names the file, the place in it, the level, and what to do.
    """
    document = _read(file)
    try:
        head = SceneHead.model_validate(
            {name: document.pop(name) for name in SceneHead.model_fields if name in document}
        )
    except ValidationError as error:
        raise ValueError(one_sentence(error, str(file))) from error
    base = {} if head.floorplan is None else _inherited_fields(file, head.floorplan)
    names = [level.name for level in head.levels or ()]
    if len(set(names)) < len(names):
        raise ValueError(Text("plan-scene-level-twice", file=str(file)))
    plans: dict[LevelName | None, FloorPlan] = {}
    for level in head.levels or (None,):
        where: Text | str = Text("plan-scene-level", file=str(file), level=level.name) if level else str(file)
        try:
            graded = {
                name: at_level(value, level.name if level else None, names, name) for name, value in document.items()
            }
        except ValueError as error:
            raise ValueError(Text("plan-scene-problem", where=where, problem=error)) from error
        if level:
            # English, as the rest of the document: people see the message of app/world/place_texts.py.
            names_of_level = {"name": f"{head.name}.{level.name}", "title": f"{head.title}, {level.title.lower()}"}
        else:
            names_of_level = {"name": head.name, "title": head.title}
        try:
            plans[level.name if level else None] = FloorPlan.model_validate_json(
                json.dumps({"walls": [], **base, **graded, **_merge_lists(base, graded), **names_of_level})
            )
        except ValidationError as error:
            raise ValueError(one_sentence(error, where)) from error
    return Scene(head, plans)


class DrivingPlace(NamedTuple):
    """A floor plan to drive in: a building, or a scene at one level."""

    plan: FloorPlan
    scene: SceneHead | None = None
    level: Level | None = None


def bundled_places() -> dict[str, DrivingPlace]:
    """Return all bundled places by the names of their floor plans: scenes, easiest level first, then buildings.

    Raises
    ------
    ValueError
        When one of the files is damaged.
    """
    files = (*bundled_scenes().values(), *bundled_floorplans().values())
    return {name: place for file in files for name, place in _bundled_in(file).items()}


def bundled_place(name: str) -> DrivingPlace | None:
    """Return the bundled place whose floor plan has this name, or None; raise ValueError when its file is damaged."""
    file = bundled_floorplans().get(name) or bundled_scenes().get(name.partition(".")[0])
    return None if file is None else _bundled_in(file).get(name)


def _bundled_in(file: Path) -> Mapping[str, DrivingPlace]:
    """Return the places of a bundled file, read again only when it or a floor plan, which it may inherit, changed."""
    return _read_bundled(file, tuple(stamp(read) for read in (file, *bundled_floorplans().values())))


@lru_cache(maxsize=64)
def _read_bundled(file: Path, _stamps: tuple[Stamp, ...]) -> Mapping[str, DrivingPlace]:
    return places_in(file) if file.parent.name == "scenes" else {file.stem: DrivingPlace(load_floorplan(file))}


def places_in(file: Path) -> dict[str, DrivingPlace]:
    """Return the floor plans of a scene's file by name, easiest level first; raise ValueError as `load_scene`."""
    head, plans = load_scene(file)
    levels = head.levels or (None,)
    return {
        plan.name: DrivingPlace(plan, head, level)
        for level, plan in ((level, plans[level.name if level else None]) for level in levels)
    }


def find_place(name: str) -> FloorPlan | None:
    """Return the bundled floor plan of this name (SCENE.LEVEL for a scene), or None; raise ValueError when damaged."""
    place = bundled_place(name)
    return None if place is None else place.plan


def is_scene(file: Path) -> bool:
    """Return whether a file is a scene and not a plain floor plan; raise ValueError when it cannot be read."""
    return "about" in _read(file)


def bundled_scenes() -> dict[str, Path]:
    """Return the files of the scenes that come with the software, by name, in alphabetical order."""
    return {file.stem: file for file in sorted((data_folder() / "scenes").glob("*.json"))}


def _read(file: Path) -> JsonObject:
    try:
        if file.stat().st_size > MAX_BYTES:
            raise ValueError(Text("plan-scene-large", file=str(file), most=MAX_BYTES // 1_000_000))
        document: JsonValue = json.loads(file.read_bytes())
    except FileNotFoundError as error:
        raise ValueError(Text("plan-file-missing", file=str(file))) from error
    except OSError as error:
        reason = error.strerror or str(error)
        raise ValueError(Text("plan-file-unreadable", file=str(file), reason=reason)) from error
    except (ValueError, RecursionError) as error:
        if type(error) is ValueError:
            raise
        raise ValueError(Text("plan-scene-no-json", file=str(file), problem=error)) from error
    if not isinstance(document, dict):
        raise ValueError(Text("plan-scene-no-object", file=str(file)))
    return document


def _inherited_fields(file: Path, name: str) -> JsonObject:
    bundled = bundled_floorplans()
    if name not in bundled:
        raise ValueError(Text("plan-scene-no-plan", file=str(file), plan=name, names=", ".join(bundled)))
    return load_floorplan(bundled[name]).model_dump(mode="json", include=set(INHERITED))


def _merge_lists(base: JsonObject, graded: JsonObject) -> JsonObject:
    """Return the lists that both the floor plan and the scene have, each with the scene's items after the plan's."""
    merged: JsonObject = {}
    for name, items in base.items():
        added = graded.get(name)
        if isinstance(items, list) and isinstance(added, list):
            merged[name] = [*items, *added]
    return merged


def at_level(
    value: JsonValue, level: LevelName | None, levels: Sequence[LevelName], place: str, depth: int = 0
) -> JsonValue:
    """Return `value` with each graded value in it replaced by that of one level; raise ValueError with the place."""
    if depth > DEEPEST:
        raise ValueError(Text("plan-scene-too-deep", place=place[:40]))
    if isinstance(value, dict):
        if value and value.keys() <= LEVEL_NAMES:
            if level not in value:
                if level is None:
                    raise ValueError(Text("plan-scene-one-value", place=place))
                raise ValueError(Text("plan-scene-value-missing", place=place, level=level))
            if extra := sorted(value.keys() - set(levels)):
                raise ValueError(Text("plan-scene-level-unknown", place=place, level=extra[0]))
            return at_level(value[level], level, levels, place, depth + 1)
        return {name: at_level(inner, level, levels, f"{place}.{name}", depth + 1) for name, inner in value.items()}
    if isinstance(value, list):
        return [at_level(inner, level, levels, f"{place}[{i}]", depth + 1) for i, inner in enumerate(value)]
    return value
