"""The 3D view behind our sign-in: viser's page served by us, its websocket bridged to the server of the role.

The 3D servers listen on this machine only, know no sign-in, and answer nobody but this bridge, which shows them the
secret of this start.
"""

import asyncio
import gzip
import hashlib
import logging
import re
from collections.abc import Callable
from contextlib import AbstractAsyncContextManager, suppress
from typing import Any

from fastapi import APIRouter, Depends, Request, Response, WebSocket
from starlette.websockets import WebSocketDisconnect
from websockets.asyncio.client import ClientConnection, connect
from websockets.exceptions import ConnectionClosed, InvalidHandshake
from websockets.typing import Subprotocol

from app.scene.bridge_secret import BRIDGE_HEADERS
from app.scene.client_messages import SUBPROTOCOL, may_pass
from app.scene.servers import Role
from app.scene.viewer_page import client_page

Admission = Callable[[WebSocket, Role], AbstractAsyncContextManager[bool]]
"""Entered before a websocket is accepted: gives whether it may look, and holds as long as it looks."""

PortOf = Callable[[Role], int | None]
"""Returns the port of a role's 3D server, None while no session is open."""

SEND_WITHIN = 3.0  # s; a browser that takes nothing for this long is cut off, and comes back with the present picture
OPEN_WITHIN = 3.0  # s
NO_VIEW = 4409  # close code: there is no 3D view at the moment
TOO_SLOW = 4408  # close code: the browser did not take what was sent

logger = logging.getLogger(__name__)


def view_router(port_of: PortOf, may_view: Admission, signed_in: Callable[..., Any]) -> APIRouter:
    """Return the routes `/view/ROLE/` and the websocket `/view/ROLE`.

    Parameters
    ----------
    port_of
        Where a role's 3D server listens now.
    may_view
        Decides about a websocket, by session and Origin.
    signed_in
        Dependency that refuses a request for the page from somebody who is not signed in.
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
    """viser's page as it is served: compressed, and sent again only when it is another one."""

    def __init__(self, page: bytes) -> None:
        self._page = page
        self._packed = gzip.compress(page, mtime=0)
        self._tag = f'"{hashlib.sha256(page).hexdigest()[:32]}"'

    def answer(self, request: Request) -> Response:
        """Return the page with its policy, or that it has not changed."""
        headers = page_headers(request.headers.get("host", ""), request.url.scheme) | {"ETag": self._tag}
        if request.headers.get("if-none-match") == self._tag:
            return Response(status_code=304, headers=headers)
        if "gzip" in request.headers.get("accept-encoding", ""):
            return Response(self._packed, media_type="text/html", headers=headers | {"Content-Encoding": "gzip"})
        return Response(self._page, media_type="text/html", headers=headers)


def page_headers(host: str, scheme: str) -> dict[str, str]:
    """Return the headers of viser's page: what its scripts may do, and that they reach nobody but this host.

    viser's page opens any websocket that its address names; `connect-src` is what keeps a foreign one closed.
    """
    sockets = "wss" if scheme == "https" else "ws"
    ours = f" {sockets}://{host}" if re.fullmatch(r"[A-Za-z0-9.\-]+(:\d+)?|\[[0-9A-Fa-f:.]+\](:\d+)?", host) else ""
    policy = {
        "default-src": "'none'",
        "script-src": "'unsafe-inline' 'wasm-unsafe-eval' blob:",
        "worker-src": "blob: data:",
        "style-src": "'unsafe-inline'",
        "img-src": "'self' data: blob:",
        "font-src": "data:",
        "connect-src": f"'self'{ours} blob: data:",
        "frame-ancestors": "'self'",
        "base-uri": "'none'",
        "form-action": "'none'",
    }
    return {
        "Content-Security-Policy": "; ".join(f"{name} {value}" for name, value in policy.items()),
        "Cache-Control": "private, no-cache",
        "Vary": "Accept-Encoding",
        "X-Content-Type-Options": "nosniff",
        "Referrer-Policy": "no-referrer",
    }


async def bridge(websocket: WebSocket, role: Role, port: int) -> None:
    """Join an admitted browser and the 3D server on `port`; the browser may send what one of this role may."""
    try:
        server = await connect(
            f"ws://127.0.0.1:{port}",
            subprotocols=[Subprotocol(SUBPROTOCOL)],
            additional_headers=BRIDGE_HEADERS,
            compression=None,
            max_size=None,
            # What a slow browser has not taken yet must wait at the 3D server, where newer replaces older.
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
        # The browser may have gone, or take nothing: closing is a courtesy.
        with suppress(RuntimeError, WebSocketDisconnect, TimeoutError):
            async with asyncio.timeout(1.0):
                await websocket.close(code)
        for end in ends:
            if isinstance(end, Exception):
                raise end


async def _to_browser(server: ClientConnection, websocket: WebSocket) -> int:
    """Send on what the 3D server says; return the code to close with."""
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
    """Send on what the browser may say; return the code to close with."""
    told = False
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
        elif not told:
            told = True
            logger.warning("a message from the %s view's page was left out: it may only tell its camera", role)
