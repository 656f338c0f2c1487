"""The title of a path for people, by the names of its floor plan and its own."""

from contextlib import suppress
from pathlib import Path

from app.texts import Text
from app.world.floorplan import FloorPlan, load_floorplan
from app.world.place_texts import place_text
from app.world.scene import find_place


def find_floorplan(folder: Path, name: str) -> FloorPlan | None:
    """Return the bundled floor plan of this name, or the clinic's in `folder`; None when there is none.

    Raises
    ------
    ValueError
        When its file cannot be read.
    """
    bundled = find_place(name)
    if bundled is not None:
        return bundled
    file = folder / f"{name}.json"
    return load_floorplan(file) if file.parent == folder and file.is_file() else None


def path_title(folder: Path, floorplan: str, path: str) -> Text | str:
    """Return the title of a path; its name where the floor plan or the path is gone, or the plan cannot be read."""
    with suppress(ValueError):
        plan = find_floorplan(folder, floorplan)
        if plan is not None:
            return place_text(floorplan, plan.path_named(path).title)
    return path
