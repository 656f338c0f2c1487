"""The camera's socket: a page sends what it reads in its camera's pictures (`app/hardware/shirt/camera.py`)."""

import math
from typing import Annotated

from fastapi import APIRouter, Depends, WebSocket

from app.api.deps import ControlPart, EquipmentPart, SocketsPart
from app.api.live.page_samples import receive_samples
from app.api.parts import part

router = APIRouter()

FLOOD = 120  # messages within a second; our page sends at most 36
CAMERA_SILENCE = 2.0  # s without a message, after which another page may be the camera: an armed chair has stopped
IN_USE = 4409  # close codes: another page is the camera
UNWANTED = 4410  # the shirt in use is no camera


class ActiveCamera:
    """The socket of the page that is the camera: one at a time, for two would be mixed into one body."""

    def __init__(self) -> None:
        self._socket: object = None
        self._newest = -math.inf  # monotonic s, when its newest message came
        self._number = 0

    def number(self, socket: object, t: float) -> int | None:
        """Return the number of the camera that a socket is at `t` (monotonic s); None while another one sends.

        Each change of the page gives another number.
        """
        if socket is not self._socket:
            if self._socket is not None and t - self._newest < CAMERA_SILENCE:
                return None
            self._socket = socket
            self._number += 1
        self._newest = t
        return self._number

    def forget(self, socket: object) -> None:
        """Let another page be the camera: this socket has ended."""
        if socket is self._socket:
            self._socket = None


@router.websocket("/camera")
async def camera_socket(
    websocket: WebSocket,
    sockets: SocketsPart,
    control: ControlPart,
    equipment: EquipmentPart,
    active: Annotated[ActiveCamera, Depends(part(ActiveCamera))],
) -> None:
    """Receive the samples of one page, of a person who drives or of the patient's screen.

    What a page sends that may be no sensor, such as one that is locked, counts for nothing.
    """

    def take(sample: bytes, t: float) -> int | None:
        if not equipment.is_camera:
            return UNWANTED
        if not sockets.may_be_sensor(websocket):
            return None
        number = active.number(websocket, t)
        if number is None:
            return IN_USE
        control.add_sample(number, sample, t)
        return None

    viewer = await sockets.admit_viewer(websocket)
    if viewer is None:
        return
    await websocket.accept()
    async with sockets.guarded(websocket, viewer):
        try:
            code = await receive_samples(websocket, FLOOD, take)
            if code is not None:
                await websocket.close(code)
        except RuntimeError:
            pass  # closed by us
        finally:
            active.forget(websocket)
