"""Answers the requests of a test in the application's event loop, which it enters once for each request.

Starlette's own transport enters it eight times, to have the beginning of an answer before its end; each time one thread
waits for the other, and most tests of the API are many small requests.
"""

import asyncio
from contextlib import suppress
from typing import Any
from urllib.parse import unquote

import httpx
from starlette.types import ASGIApp, Message

PORTS = {"http": 80, "https": 443}


class OneHop(httpx.BaseTransport):
    """Sends requests to an application that runs in `loop`, in another thread; `sockets` opens its websockets."""

    def __init__(
        self, app: ASGIApp, loop: asyncio.AbstractEventLoop, client: tuple[str, int], sockets: httpx.BaseTransport
    ) -> None:
        self._app = app
        self._loop = loop
        self._client = client
        self._sockets = sockets

    def handle_request(self, request: httpx.Request) -> httpx.Response:
        """Return the whole answer, or 500 where the application gave none, once the application has ended its work."""
        if request.url.scheme not in PORTS:
            return self._sockets.handle_request(request)
        answer = asyncio.run_coroutine_threadsafe(self._answered(self._scope(request), request.read()), self._loop)
        status, headers, content = answer.result()
        body = b"" if request.method == "HEAD" else content
        return httpx.Response(status, headers=headers, stream=httpx.ByteStream(body), request=request)

    def close(self) -> None:
        """Close the transport of the websockets, too."""
        self._sockets.close()

    def _scope(self, request: httpx.Request) -> dict[str, Any]:
        url = request.url
        return {
            "type": "http",
            "http_version": "1.1",
            "method": request.method,
            "path": unquote(url.path),
            "raw_path": url.raw_path.split(b"?", 1)[0],
            "root_path": "",
            "scheme": url.scheme,
            "query_string": url.query,
            "headers": [(name.lower(), value) for name, value in request.headers.raw],
            "client": self._client,
            "server": (url.host, url.port or PORTS[url.scheme]),
            "state": {},
        }

    async def _answered(self, scope: dict[str, Any], content: bytes) -> tuple[int, list[tuple[bytes, bytes]], bytes]:
        ended = asyncio.Event()
        waiting = [{"type": "http.request", "body": content, "more_body": False}]
        messages: list[Message] = []

        async def receive() -> Message:
            if waiting:
                return waiting.pop()
            await ended.wait()
            return {"type": "http.disconnect"}

        async def send(message: Message) -> None:
            messages.append(message)
            if message["type"] == "http.response.body" and not message.get("more_body", False):
                ended.set()

        with suppress(Exception):  # answered with 500, and logged, by the application itself
            await self._app(scope, receive, send)
        if not messages:
            return 500, [], b""
        start, *pieces = messages
        return start["status"], start["headers"], b"".join(piece.get("body", b"") for piece in pieces)
