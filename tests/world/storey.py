"""Small floor plans for tests."""

from app.world.floorplan import FloorPlan


def storey(walls=(), obstacles=(), thickness=0.1, path=((50, 50), (60, 50))):
    return FloorPlan.model_validate(
        {
            "name": "test",
            "title": "Test",
            "walls": walls,
            "obstacles": obstacles,
            "wall_thickness": thickness,
            "paths": [{"name": "main", "title": "Main", "points": path, "instruction": "Follow the line."}],
        }
    )
