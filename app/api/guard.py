"""Middleware of every route: the security headers of its answer, and the check of origin and size of a request."""

from fastapi import HTTPException
from fastapi.responses import JSONResponse
from starlette.datastructures import Headers, MutableHeaders
from starlette.requests import HTTPConnection
from starlette.types import ASGIApp, Message, Receive, Scope, Send

from app.api.origin import host_is_ours, may_pass
from app.api.sign_in.cookies import is_encrypted
from app.settings import Settings

# Our pages run only scripts of this program. The 3D view has its own policy (view_bridge.py).
PAGE_POLICY = "; ".join(
    (
        "default-src 'none'",
        "script-src 'self'",
        "worker-src 'self'",
        "style-src 'self' 'unsafe-inline'",
        "img-src 'self' data: blob:",
        "font-src 'self'",
        "connect-src 'self' {sockets}",
        "frame-src 'self'",
        "frame-ancestors 'self'",
        "form-action 'self'",
        "base-uri 'none'",
        "manifest-src 'self'",
        "media-src 'self'",
    )
)
HEADERS = {
    "X-Content-Type-Options": "nosniff",
    "Referrer-Policy": "no-referrer",
    "Cross-Origin-Opener-Policy": "same-origin",
    "Cross-Origin-Resource-Policy": "same-origin",
    "X-Frame-Options": "SAMEORIGIN",
}

NOT_OURS = "This address does not belong to this program: open the link that it printed."
NOT_OUR_PAGE = "This request does not come from our own page: open the page and try again."

TOO_LARGE = "This is too large: send at most {limit} MB here."
BODY_LIMIT = 2_000_000  # bytes
# Bytes by the beginning of the path: the largest file, plus the parts of its form.
LIMITS = {
    "/api/v1/equipment/files": 65_000_000,
    "/api/v1/floorplans/import": 41_000_000,  # a ROS map and its image
    "/api/v1/floorplans": 8_100_000,
    "/api/v1/models": 21_000_000,
    "/api/v1/archives": 8_000_000_000,  # a hundred hours of recordings
}


class Guard:
    """Checks host, origin and size of a request, and adds the headers of its answer."""

    def __init__(self, app: ASGIApp, settings: Settings) -> None:
        self._app = app
        self._settings = settings

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Check and answer a request; websockets are checked by their own routes before they are accepted."""
        if scope["type"] != "http":
            await self._app(scope, receive, send)
            return
        connection, path = HTTPConnection(scope), scope["path"]
        headers = connection.headers
        ours = host_is_ours(self._settings, headers)

        async def with_headers(message: Message) -> None:
            if message["type"] == "http.response.start":
                given = MutableHeaders(scope=message)
                for name, value in HEADERS.items():
                    given.setdefault(name, value)
                host = headers.get("host", "")
                sockets = f"{'wss' if is_encrypted(connection) else 'ws'}://{host}" if ours else ""
                given.setdefault("Content-Security-Policy", PAGE_POLICY.format(sockets=sockets))
                if path.startswith("/api/"):
                    given["Cache-Control"] = "no-store"
            await send(message)

        if not ours:
            answer = JSONResponse({"detail": NOT_OURS}, 421)
        elif not may_pass(scope["method"], path, connection):
            answer = JSONResponse({"detail": NOT_OUR_PAGE}, 403)
        elif _content_length(headers) > _limit(path):
            answer = JSONResponse({"detail": _too_large(_limit(path))}, 413)
        else:
            await self._app(scope, _limited(receive, _limit(path)), with_headers)
            return
        await answer(scope, receive, with_headers)


def _content_length(headers: Headers) -> int:
    length = headers.get("content-length", "0")
    return int(length) if length.isdecimal() else 0


def _limit(path: str) -> int:
    return next((limit for start, limit in LIMITS.items() if path.startswith(start)), BODY_LIMIT)


def _too_large(limit: int) -> str:
    return TOO_LARGE.format(limit=limit // 1_000_000)


def _limited(receive: Receive, limit: int) -> Receive:
    """Return `receive` with a limit: raise 413 when the body is larger than `limit` bytes."""
    received = 0

    async def counted() -> Message:
        nonlocal received
        message = await receive()
        received += len(message.get("body", b""))
        if received > limit:
            raise HTTPException(413, _too_large(limit))
        return message

    return counted
