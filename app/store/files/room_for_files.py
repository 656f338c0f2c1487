"""Whether the disk has room for a file of a patient's recordings while it is made, and for recording beside it."""

from math import ceil, floor
from pathlib import Path

from app.disk_room import ROOM_TO_RECORD
from app.store.files.disk_watch import disk_room

NO_ROOM_TO_MAKE = (
    "There is no room for this {what}: {needed} MB must be free on the disk where it is made, and {free} MB are. "
    "Make room, then try again; nothing was made."
)


def room_refusal(what: str, size: float, place: Path) -> str:
    """Return why `what`, of this many bytes, cannot be made in the folder `place`; an empty text when it can."""
    needed, free = size + ROOM_TO_RECORD, disk_room(place).free
    return (
        "" if free >= needed else NO_ROOM_TO_MAKE.format(what=what, needed=ceil(needed / 1e6), free=floor(free / 1e6))
    )
