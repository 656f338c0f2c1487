"""A 3D view for a test of who may see it: the bridge accepts an admitted browser, and shows nothing."""

from typing import Any

import pytest
from api.fake_clinic import BASE
from fastapi import WebSocket

from app.api.view import view_bridge
from app.api.view.view_keeper import ViewKeeper
from app.scene.client_messages import SUBPROTOCOL
from app.scene.role_servers import Role

VIEW: dict[str, Any] = {
    "url": f"{BASE.replace('http', 'ws')}/view/clinician/",
    "subprotocols": [SUBPROTOCOL],
    "headers": {"Origin": BASE},
}


def serve_view(monkeypatch: pytest.MonkeyPatch) -> None:
    async def bridge(websocket: WebSocket, _role: Role, _port: int) -> None:
        await websocket.accept(subprotocol=SUBPROTOCOL)
        await websocket.receive()

    monkeypatch.setattr(view_bridge, "bridge", bridge)
    monkeypatch.setattr(ViewKeeper, "port", lambda _self, _role: 1)
