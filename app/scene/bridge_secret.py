"""The secret between the view bridge and viser's servers: viser's ports refuse every connection without it.

viser listens on ports of its own, without a sign-in and without a check of the Origin header. Without the secret, any
page in a browser on this machine could read the scene from these ports. A new secret is made at each start of the
program, and only the bridge sends it.
"""

import logging
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

from app.texts import Text

LOGGER: Final = "websockets.server"
HEADER: Final = "X-Bodydrive-Bridge"
SECRET: Final = secrets.token_urlsafe(32)
BRIDGE_HEADERS: Final = {HEADER: SECRET}
"""Headers with which the bridge connects to a viser server."""

ProcessRequest = Callable[[ServerConnection, Request], Response | None]

_guarded: weakref.WeakSet[threading.Thread] = weakref.WeakSet()  # threads of viser servers that require the secret


def guard_viser() -> None:
    """Make every server that viser opens from now on require the secret, for its page and for its websocket."""
    # viser 1.1.1 offers no hook for requests, but it calls `websockets.asyncio.server.serve` by this name.
    _infra.websockets = _GuardedWebsockets()  # type: ignore[assignment, attr-defined]


def require_guarded(server: viser.ViserServer) -> None:
    """Stop a server whose port does not require the secret, and raise RuntimeError."""
    if server._websock_server._server_thread not in _guarded:  # noqa: SLF001
        server.stop()
        raise RuntimeError(Text("object-viser-port"))


class _GuardedWebsockets:
    """Replacement of the websockets library inside viser; its servers require the secret."""

    def __init__(self) -> None:
        self.asyncio = SimpleNamespace(server=SimpleNamespace(serve=_serve))

    def __getattr__(self, name: str) -> object:
        return getattr(websockets, name)


def _serve(*arguments: Any, process_request: ProcessRequest, **options: Any) -> Any:
    def admit(connection: ServerConnection, request: Request) -> Response | None:
        secrets_sent = request.headers.get_all(HEADER)
        if len(secrets_sent) == 1 and secrets.compare_digest(
            secrets_sent[0].encode(errors="surrogateescape"), SECRET.encode()
        ):
            return process_request(connection, request)
        return connection.respond(HTTPStatus.FORBIDDEN, f"{Text('object-port-closed')}\n")

    _guarded.add(threading.current_thread())
    return websockets.asyncio.server.serve(*arguments, process_request=admit, logger=_own_logger(), **options)


def _own_logger() -> logging.Logger:
    """Return a logger for one server, which passes on to that of the websockets library.

    Each viser server adds a filter to the logger of its connections, and never removes it.
    """
    logger = logging.Logger(LOGGER)
    logger.parent = logging.getLogger(LOGGER)
    return logger
