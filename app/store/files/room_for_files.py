"""Whether the disk has room for a file of a patient's recordings while it is made, and for recording beside it."""

from math import ceil, floor
from pathlib import Path
from typing import Literal

from app.disk_room import ROOM_TO_RECORD
from app.store.files.disk_watch import disk_room
from app.texts import Text


def room_refusal(what: Literal["archive", "export"], size: float, place: Path) -> Text | None:
    """Return why `what`, of this many bytes, cannot be made in the folder `place`; None when it can."""
    needed, free = size + ROOM_TO_RECORD, disk_room(place).free
    if free >= needed:
        return None
    return Text("store-no-room-to-make", what=what, needed=ceil(needed / 1e6), free=floor(free / 1e6))
