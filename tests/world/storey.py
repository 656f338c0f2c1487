"""Small floor plans for tests."""

from app.world.floorplan import FloorPlan


def storey(walls=(), obstacles=(), thickness=0.1, path=((50, 50), (60, 50))):
    line = {"name": "main", "title": "Main", "points": path, "instruction": "Follow the line."}
    plan = {"name": "test", "title": "Test", "wall_thickness": thickness, "paths": [line]}
    return FloorPlan.model_validate(plan | {"walls": walls, "obstacles": obstacles})
