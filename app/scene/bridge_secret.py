"""The secret of this start of the program: viser's own ports refuse every connection that does not show it.

viser listens on ports of its own, knows no sign-in and looks at no Origin. Without the secret any page in a browser on
this machine could read the scene there. Only our bridge knows it.
"""

import secrets
import threading
import weakref
from collections.abc import Callable
from http import HTTPStatus
from types import SimpleNamespace
from typing import Any, Final

import viser
import websockets
import websockets.asyncio.server
from viser.infra import _infra
from websockets.asyncio.server import ServerConnection
from websockets.http11 import Request, Response

HEADER: Final = "X-Bodydrive-Bridge"
SECRET: Final = secrets.token_urlsafe(32)
BRIDGE_HEADERS: Final = {HEADER: SECRET}
"""What our bridge sends along when it connects."""

ProcessRequest = Callable[[ServerConnection, Request], Response | None]

_guarded: weakref.WeakSet[threading.Thread] = weakref.WeakSet()  # of viser's servers that ask for the secret


def guard_viser() -> None:
    """Let every server that viser opens from now on ask for the secret, before it answers a page or a websocket."""
    # viser 1.1.1 gives no way to look at a request: it calls `websockets.asyncio.server.serve` by this name.
    _infra.websockets = _GuardedWebsockets()  # type: ignore[assignment, attr-defined]


def require_guarded(server: viser.ViserServer) -> None:
    """Stop a server whose port was opened without the guard, and raise RuntimeError."""
    if server._websock_server._server_thread not in _guarded:  # noqa: SLF001
        server.stop()
        raise RuntimeError("viser opened a port that everybody may read: install viser 1.1.1")


class _GuardedWebsockets:
    """Stands in for the websockets library inside viser: its servers ask for the secret."""

    def __init__(self) -> None:
        self.asyncio = SimpleNamespace(server=SimpleNamespace(serve=_serve))

    def __getattr__(self, name: str) -> Any:
        return getattr(websockets, name)


def _serve(*given: Any, process_request: ProcessRequest, **more: Any) -> Any:
    def admit(connection: ServerConnection, request: Request) -> Response | None:
        shown = request.headers.get_all(HEADER)
        if len(shown) == 1 and secrets.compare_digest(shown[0].encode(errors="surrogateescape"), SECRET.encode()):
            return process_request(connection, request)
        return connection.respond(HTTPStatus.FORBIDDEN, "This port is for the program itself: open its own pages.\n")

    _guarded.add(threading.current_thread())
    return websockets.asyncio.server.serve(*given, process_request=admit, **more)
