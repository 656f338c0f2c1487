"""The 3D view behind our sign-in: serve viser's page, and bridge its websocket to the 3D server of the role.

The 3D servers listen on this machine only and know no sign-in. They answer this bridge only, which sends them the
secret of this start of the program.
"""

import asyncio
import gzip
import hashlib
import logging
from collections.abc import Callable
from contextlib import AbstractAsyncContextManager, suppress
from typing import Any

from fastapi import APIRouter, Depends, Request, Response, WebSocket
from starlette.websockets import WebSocketDisconnect
from websockets.asyncio.client import ClientConnection, connect
from websockets.exceptions import ConnectionClosed, InvalidHandshake
from websockets.typing import Subprotocol

from app.api.response_headers import view_headers
from app.scene.bridge_secret import BRIDGE_HEADERS
from app.scene.client_messages import SUBPROTOCOL, may_pass
from app.scene.role_servers import Role
from app.scene.viewer_page import client_page

Admission = Callable[[WebSocket, Role], AbstractAsyncContextManager[bool]]
"""Context of a websocket, entered before it is accepted; gives whether it is admitted."""

PortOf = Callable[[Role], int | None]
"""Returns the port of a role's 3D server, None while no session is open."""

SEND_WITHIN = (
    3.0  # s; a browser that takes nothing for this long is disconnected, and connects again for the current picture
)
OPEN_WITHIN = 3.0  # s
NO_VIEW = 4409  # close code: there is no 3D view at the moment
TOO_SLOW = 4408  # close code: the browser did not take what was sent

logger = logging.getLogger(__name__)


def view_router(port_of: PortOf, may_view: Admission, signed_in: Callable[..., Any]) -> APIRouter:
    """Return the routes `/view/ROLE/` and the websocket `/view/ROLE`.

    Parameters
    ----------
    port_of
        Returns the port of a role's 3D server.
    may_view
        Admits or refuses a websocket by sign-in and Origin.
    signed_in
        Dependency that refuses the page to somebody who is not signed in.
    """
    router = APIRouter()
    page = ViewPage(client_page())

    @router.get("/view/{role}/", dependencies=[Depends(signed_in)], include_in_schema=False)
    async def view_page(role: Role, request: Request) -> Response:  # noqa: ARG001
        return page.answer(request)

    @router.websocket("/view/{role}")
    @router.websocket("/view/{role}/")
    async def view_socket(websocket: WebSocket, role: Role) -> None:
        async with may_view(websocket, role) as admitted:
            if not admitted:
                return
            port = port_of(role)
            if port is None or SUBPROTOCOL not in websocket.scope.get("subprotocols", []):
                await websocket.close(NO_VIEW)
                return
            await bridge(websocket, role, port)

    return router


class ViewPage:
    """viser's page: compressed, with an ETag, so that a browser loads it again only when it has changed."""

    def __init__(self, page: bytes) -> None:
        self._page = page
        self._packed = gzip.compress(page, mtime=0)
        self._tag = f'"{hashlib.sha256(page).hexdigest()[:32]}"'

    def answer(self, request: Request) -> Response:
        """Return the page with its headers, or 304 when the browser has it."""
        headers = view_headers(request.headers.get("host", ""), request.url.scheme) | {"ETag": self._tag}
        if request.headers.get("if-none-match") == self._tag:
            return Response(status_code=304, headers=headers)
        if "gzip" in request.headers.get("accept-encoding", ""):
            return Response(self._packed, media_type="text/html", headers=headers | {"Content-Encoding": "gzip"})
        return Response(self._page, media_type="text/html", headers=headers)


async def bridge(websocket: WebSocket, role: Role, port: int) -> None:
    """Connect an admitted browser with the 3D server on `port`; pass only the messages that the role permits."""
    try:
        server = await connect(
            f"ws://127.0.0.1:{port}",
            subprotocols=[Subprotocol(SUBPROTOCOL)],
            additional_headers=BRIDGE_HEADERS,
            compression=None,
            max_size=None,
            # For a slow browser, messages must wait at the 3D server, where a newer one replaces an older one.
            max_queue=1,
            ping_interval=None,
            open_timeout=OPEN_WITHIN,
            close_timeout=1.0,
            proxy=None,
        )
    except (OSError, TimeoutError, InvalidHandshake):
        await websocket.close(NO_VIEW)
        return
    async with server:
        await websocket.accept(subprotocol=SUBPROTOCOL)
        tasks = [
            asyncio.create_task(_to_browser(server, websocket)),
            asyncio.create_task(_to_server(websocket, server, role)),
        ]
        try:
            await asyncio.wait(tasks, return_when=asyncio.FIRST_COMPLETED)
        finally:
            for task in tasks:
                task.cancel()
            ends = await asyncio.gather(*tasks, return_exceptions=True)
        code = next((end for end in ends if isinstance(end, int)), 1011)
        # The browser may have disconnected, or take nothing: ignore failures.
        with suppress(RuntimeError, WebSocketDisconnect, TimeoutError):
            async with asyncio.timeout(1.0):
                await websocket.close(code)
        for end in ends:
            if isinstance(end, Exception):
                raise end


async def _to_browser(server: ClientConnection, websocket: WebSocket) -> int:
    """Forward the messages of the 3D server; return the close code."""
    try:
        async for message in server:
            async with asyncio.timeout(SEND_WITHIN):
                await websocket.send_bytes(message if isinstance(message, bytes) else message.encode())
    except TimeoutError:
        return TOO_SLOW
    except (ConnectionClosed, WebSocketDisconnect, RuntimeError):
        return 1001
    return NO_VIEW


async def _to_server(websocket: WebSocket, server: ClientConnection, role: Role) -> int:
    """Forward the permitted messages of the browser; return the close code."""
    has_warned = False
    while True:
        message = await websocket.receive()
        if message["type"] == "websocket.disconnect":
            return 1000
        content: bytes | None = message.get("bytes")
        if content is not None and may_pass(role, content):
            try:
                async with asyncio.timeout(SEND_WITHIN):
                    await server.send(content)
            except (ConnectionClosed, TimeoutError):
                return NO_VIEW
        elif not has_warned:
            has_warned = True
            logger.warning("a message from the %s view's page was left out: it may only tell its camera", role)
