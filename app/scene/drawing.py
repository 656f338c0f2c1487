"""The drawing of a floor plan: its building, its 3D objects, its movers."""

import logging
from contextlib import closing
from pathlib import Path
from typing import Final

from app.computing_process import ComputingProcess
from app.scene.meshes.building import building_parts
from app.scene.meshes.movers import mover_parts
from app.scene.models.objects import Model, stored_model
from app.scene.world_view import DrawnPlan
from app.world.floorplan import FloorPlan, PrescribedPath

NOTHING: Final = DrawnPlan({}, ())
LARGE: Final = 300  # points of walls, and obstacles

logger = logging.getLogger(__name__)


def prepared_drawing(plan: FloorPlan | None, path: PrescribedPath | None, models: Path | None) -> DrawnPlan:
    """Return `drawing_of` a plan; that of a large plan is made in a process of its own.

    It takes seconds, in which the web process would keep its other threads waiting, Stop among them.

    Raises
    ------
    Unavailable
        In one sentence, when the process ended or gave no answer.
    """
    if plan is None or sum(len(wall) for wall in plan.walls) + len(plan.obstacles) <= LARGE:
        return drawing_of(plan, path, models)
    with closing(ComputingProcess()) as computing:
        return computing.ask(drawing_of, plan, path, models)


def drawing_of(plan: FloorPlan | None, path: PrescribedPath | None, models: Path | None) -> DrawnPlan:
    """Return the drawing of a plan; `models` is the folder of the 3D objects that its obstacles name."""
    if plan is None:
        return NOTHING
    return DrawnPlan(
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
