"""The places to drive in: scenes and buildings of the program, and the clinic's own floor plans."""

from contextlib import suppress
from pathlib import Path

from app.world.floorplan import FloorPlan, bundled_floorplans, load_floorplan
from app.world.path_titles import find_floorplan
from app.world.scene import DrivingPlace, bundled_places


class ClinicPlaces:
    """Finds the places to drive in by name; `folder` is that of the clinic's own floor plans."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder

    def all(self) -> dict[str, DrivingPlace]:
        """Return all places by name: scenes, buildings, then the clinic's own plans that can be read."""
        places: dict[str, DrivingPlace] = {}
        for file in sorted(self.folder.glob("*.json")):
            with suppress(ValueError):
                places[file.stem] = DrivingPlace(load_floorplan(file))
        bundled = bundled_places()
        return bundled | {name: offer for name, offer in places.items() if name not in bundled}

    def plan(self, name: str) -> FloorPlan | None:
        """Return a floor plan by its name, None when there is none; ValueError when it cannot be read."""
        return find_floorplan(self.folder, name)

    def first(self) -> tuple[FloorPlan, str] | tuple[None, None]:
        """Return the first readable floor plan and its first path, for the view before the first trial."""
        for name in bundled_floorplans():
            with suppress(ValueError):
                plan = self.plan(name)
                if plan is not None:
                    return plan, plan.paths[0].name
        return None, None
