"""The draft of a floor plan made from an imported file; it may not have a path yet."""

import json
import re
from typing import NamedTuple, TypedDict

from pydantic import ValidationError

from app.sentences import one_sentence
from app.texts import Text
from app.world.floorplan import FloorPlan
from app.world.path import Path as Line

SLOWEST = 0.25  # m/s, the mean speed for which the time limit suffices
SHORTEST_TIME = 60.0  # s


class PathDocument(TypedDict):
    """A proposed or drawn path, as a document of a floor plan has it."""

    name: str
    title: str
    points: list[list[float]]  # m
    time_limit: float  # s
    instruction: str


class PlanDocument(TypedDict):
    """The document of a FloorPlan, except that paths may be missing."""

    name: str
    title: str
    walls: list[list[tuple[float, float]]]  # m
    wall_thickness: float  # m
    paths: list[PathDocument]


class Draft(NamedTuple):
    """The draft of a floor plan, and how it was made."""

    document: PlanDocument
    messages: tuple[Text, ...] = ()
    layers: tuple[str, ...] = ()  # of a drawing, to choose from
    taken: tuple[str, ...] = ()  # the layers whose lines are walls


def path_document(points: list[list[float]], number: int | None = None) -> PathDocument:
    """Return the document of a path through `points` (m): the proposed one, or a drawn one with its number from 1."""
    return {
        "name": "main" if number in {None, 1} else f"path-{number}",
        "title": str(Text("plan-path-proposed") if number is None else Text("plan-path-drawn", number=number)),
        "points": points,
        "time_limit": round(max(SHORTEST_TIME, Line(points).length / SLOWEST)),
        "instruction": str(Text("plan-path-instruction")),
    }


def plain_name(text: str) -> str:
    """Return a valid name (letters, digits, dots, dashes) made of `text`."""
    return re.sub(r"[^A-Za-z0-9_.-]+", "-", text).strip("-_.")[:64] or "map"


def plan_of(draft: Draft, where: str) -> FloorPlan:
    """Return the draft as a floor plan.

    Raises
    ------
    ValueError
        One sentence that begins with `where` (the file's name).
    """
    try:
        return FloorPlan.model_validate_json(json.dumps(draft.document))
    except ValidationError as error:
        raise ValueError(one_sentence(error, where)) from error
