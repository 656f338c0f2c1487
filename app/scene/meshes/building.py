"""The meshes of what stands still in a floor plan: walls, doors, ceiling, furniture, marks, ground."""

from typing import Final

from app.scene.meshes.bodies import Part
from app.scene.meshes.furniture import ModelOf, furniture, no_model
from app.scene.meshes.ground import ground_bounds, ground_parts
from app.scene.meshes.interior import ceiling_part, floor_part, has_ceiling
from app.scene.meshes.paint import PaintedPart, joined
from app.scene.meshes.walls import doors_part, skirting_part, walls_part
from app.scene.task_marks import gap_parts
from app.world.floorplan import FloorPlan

FURNITURE: Final = "furniture_"  # prefix of the names of its parts
WALLS: Final = "walls"  # name of the part that may be cut at a height
OVERHEAD: Final = "overhead"  # name of the part that hides the way from above: ceiling, lamps, door frames

BuildingParts = dict[str, Part | PaintedPart]


def building_parts(plan: FloorPlan, model_of: ModelOf = no_model) -> BuildingParts:
    """Return the parts of walls, doors, ceiling, furniture, marks and ground, in the order in which they are drawn.

    Parts that hide much come first, so that few pixels are painted twice: on a tablet, pixels cost more time than
    triangles.
    """
    standing = sorted(furniture(plan.obstacles, model_of).items())
    pieces = {f"{FURNITURE}{'_'.join(map(str, colour))}": Part(mesh, colour) for colour, mesh in standing}
    return _wall_parts(plan) | _overhead_parts(plan) | pieces | gap_parts(plan.gaps) | _floor_parts(plan)


def _wall_parts(plan: FloorPlan) -> BuildingParts:
    return {WALLS: walls_part(plan, has_ceiling(plan))} if plan.walls else {}


def _overhead_parts(plan: FloorPlan) -> BuildingParts:
    parts = []
    if plan.doors:
        parts.append(doors_part(plan, has_ceiling(plan)))
    if has_ceiling(plan):
        parts.append(ceiling_part(plan, ground_bounds(plan)))
    return {OVERHEAD: joined(parts)} if parts else {}


def _floor_parts(plan: FloorPlan) -> BuildingParts:
    """Return the floor of a hall, or open ground, and the skirting of the walls on it."""
    skirting = [skirting_part(plan)] if plan.walls else []
    if plan.ground.kind == "hall":
        return {"floor": joined([*skirting, floor_part(plan, ground_bounds(plan))])}
    return ({"skirting": joined(skirting)} if skirting else {}) | ground_parts(plan)
