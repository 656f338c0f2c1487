"""The messages that a browser may send to a role's 3D server."""

import math
from typing import Final

import msgspec

from app.scene.role_servers import Role

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
    """Return whether a browser's message may be passed to the 3D server of its role.

    The message of the camera, which gives the size of the picture, may pass; from the clinician also that of a changed
    plot. All other messages, such as a file, a click or a public share of the view, may not; neither may a message that
    is cut off or has another form than expected.
    """
    if len(message) > LARGEST_MESSAGE:
        return False
    try:
        decoded = _DECODERS[role].decode(message)
    except (msgspec.DecodeError, UnicodeDecodeError, RecursionError):
        return False
    if isinstance(decoded, _GuiUpdate):
        return True
    camera = decoded
    vectors = (*camera.wxyz, *camera.position, *camera.look_at, *camera.up_direction)
    numbers = (*vectors, camera.fov, camera.near, camera.far)
    sizes = (camera.image_height, camera.image_width)
    return all(map(math.isfinite, numbers)) and all(0 <= size <= LARGEST_PICTURE for size in sizes)
