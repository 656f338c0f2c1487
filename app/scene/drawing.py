"""The drawing of a floor plan: its building, its 3D objects, its movers."""

import logging
from pathlib import Path
from typing import Final

from app.scene.meshes.building import building_parts
from app.scene.meshes.movers import mover_parts
from app.scene.models.objects import Model, stored_model
from app.scene.world_view import Drawing
from app.world.floorplan import FloorPlan, PrescribedPath

NOTHING: Final = Drawing({}, ())

logger = logging.getLogger(__name__)


def drawing_of(plan: FloorPlan | None, path: PrescribedPath | None, models: Path | None) -> Drawing:
    """Return the drawing of a plan; `models` is the folder of the 3D objects that its obstacles name."""
    if plan is None:
        return NOTHING
    return Drawing(
        building=building_parts(plan, lambda name: _model(models, name)),
        movers=[mover_parts(mover) for mover in plan.movers],
        bounds=plan.bounds,
        wall_height=plan.wall_height if plan.walls else 0.0,
        lights=plan.lights,
        start=None if path is None else path.start,
    )


def _model(models: Path | None, name: str) -> Model | None:
    """Return a stored 3D object; None, so that a plain box is drawn, when it cannot be read."""
    if models is None:
        return None
    try:
        return stored_model(models / f"{name}.glb")
    except ValueError as error:
        logger.warning("an object is drawn as a plain box: %s", error)
        return None
