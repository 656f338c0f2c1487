"""Which messages a browser may send to a role's 3D server: few, whole, and nothing else."""

import math
from typing import Final

import msgspec

from app.scene.servers import Role

SUBPROTOCOL: Final = "viser-v1.1.1"
LARGEST_MESSAGE = 4096  # bytes; a camera's message has about 300
LARGEST_PICTURE = 16_384  # pixels

Triple = tuple[float, float, float]


class _Camera(msgspec.Struct, tag_field="type", tag="ViewerCameraMessage", forbid_unknown_fields=True):
    wxyz: tuple[float, float, float, float]
    position: Triple
    fov: float
    near: float
    far: float
    image_height: int
    image_width: int
    look_at: Triple
    up_direction: Triple


class _GuiUpdate(msgspec.Struct, tag_field="type", tag="GuiUpdateMessage", forbid_unknown_fields=True):
    uuid: str
    updates: dict[str, bool | int | float | str | None]


_DECODERS: Final[dict[Role, msgspec.msgpack.Decoder[_Camera | _GuiUpdate]]] = {
    "clinician": msgspec.msgpack.Decoder(_Camera | _GuiUpdate),
    "patient": msgspec.msgpack.Decoder(_Camera),
}


def may_pass(role: Role, message: bytes) -> bool:
    """Tell whether a browser's message may reach the 3D server of its role.

    The browser's camera tells the shape of its picture. A file, a click, a public share of the view, and whatever
    is cut off or not quite of the expected form does not pass.
    """
    if len(message) > LARGEST_MESSAGE:
        return False
    try:
        found = _DECODERS[role].decode(message)
    except (msgspec.DecodeError, UnicodeDecodeError, RecursionError):
        return False
    if isinstance(found, _GuiUpdate):
        return True
    numbers = (*found.wxyz, *found.position, *found.look_at, *found.up_direction, found.fov, found.near, found.far)
    sizes = (found.image_height, found.image_width)
    return all(map(math.isfinite, numbers)) and all(0 <= size <= LARGEST_PICTURE for size in sizes)
