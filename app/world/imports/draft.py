"""A floor plan that is proposed: the document, and what to know about it. It may not have a path yet."""

import json
import re
from typing import Any, NamedTuple

from pydantic import ValidationError

from app.sentences import one_sentence
from app.world.floorplan import FloorPlan
from app.world.path import Path as Line

SLOWEST = 0.25  # m/s, the mean speed that the time limit allows
SHORTEST_TIME = 60.0  # s
INSTRUCTION = "Follow the white line to its end."


class Draft(NamedTuple):
    """A document as FloorPlan takes it, except that paths may be missing, and sentences about how it was made."""

    document: dict[str, Any]
    words: tuple[str, ...] = ()
    layers: tuple[str, ...] = ()  # of a drawing, to choose from
    taken: tuple[str, ...] = ()  # those of them whose lines are walls now


def path_document(points: list[list[float]], name: str = "main", title: str = "Across the building") -> dict[str, Any]:
    """Return a path's document through `points` (m)."""
    return {
        "name": name,
        "title": title,
        "points": points,
        "time_limit": round(max(SHORTEST_TIME, Line(points).length / SLOWEST)),
        "instruction": INSTRUCTION,
    }


def plain_name(words: str) -> str:
    """Return a name (letters, digits, dots, dashes) made of words."""
    return re.sub(r"[^A-Za-z0-9_.-]+", "-", words).strip("-_.")[:64] or "map"


def plan_of(draft: Draft, where: str) -> FloorPlan:
    """Return the draft as a floor plan.

    Raises
    ------
    ValueError
        One sentence that begins with `where` (a file).
    """
    try:
        return FloorPlan.model_validate_json(json.dumps(draft.document))
    except ValidationError as error:
        raise ValueError(one_sentence(error, where)) from error
