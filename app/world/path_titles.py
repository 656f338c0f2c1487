"""The title of a path for people, by the names of its floor plan and its own."""

from contextlib import suppress
from pathlib import Path

from app.world.floorplan import FloorPlan, load_floorplan
from app.world.scene import find_place


def find_floorplan(own: Path, name: str) -> FloorPlan | None:
    """Return the bundled floor plan of this name, or the clinic's in the folder `own`; None when there is none.

    Raises
    ------
    ValueError
        When its file cannot be read.
    """
    bundled = find_place(name)
    if bundled is not None:
        return bundled
    file = own / f"{name}.json"
    return load_floorplan(file) if file.parent == own and file.is_file() else None


def path_title(own: Path, floorplan: str, path: str) -> str:
    """Return the title of a path; its name where the floor plan or the path is gone, or the plan cannot be read."""
    with suppress(ValueError):
        found = find_floorplan(own, floorplan)
        if found is not None:
            return found.path_named(path).title
    return path
