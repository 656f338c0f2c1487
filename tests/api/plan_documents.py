"""Floor plans as a page sends them."""

from typing import Any

ROOM = [[[0.0, 0.0], [6.0, 0.0], [6.0, 4.0], [0.0, 4.0], [0.0, 0.0]]]
PATH = {"name": "main", "title": "Across", "points": [[1.0, 2.0], [5.0, 2.0]], "instruction": "Go."}


def plan(name: str = "my-room", **more: Any) -> dict[str, Any]:
    """Return the document of a room with one path."""
    return {"name": name, "title": "My room", "walls": ROOM, "paths": [PATH], **more}
