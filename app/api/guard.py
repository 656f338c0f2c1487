"""Middleware of every route: the security headers of its answer, and the check of origin and size of a request."""

from fastapi import HTTPException
from fastapi.responses import JSONResponse
from starlette.datastructures import MutableHeaders
from starlette.requests import HTTPConnection
from starlette.types import ASGIApp, Message, Receive, Scope, Send

from app.api.origin import host_is_ours, may_pass
from app.api.request_bodies import Bodies
from app.api.sign_in.cookies import is_encrypted
from app.settings import Settings
from app.store.access.visible_patients import NOBODY, VISIBLE_PATIENTS

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

# A browser that was here over https asks for no page of this name over http for 30 days (decisions/0041).
ONLY_HTTPS = "max-age=2592000"

NOT_OURS = "This address does not belong to this program: open the link that it printed."
NOT_OUR_PAGE = "This request does not come from our own page: open the page and try again."


class Guard:
    """Checks host, origin and size of a request, and adds the headers of its answer."""

    def __init__(self, app: ASGIApp, settings: Settings) -> None:
        self._app = app
        self._settings = settings
        self._bodies = Bodies()

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Check and answer a request; websockets are checked by their own routes before they are accepted."""
        if scope["type"] != "lifespan":
            VISIBLE_PATIENTS.set(NOBODY)  # until it is known who asks
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
                if is_encrypted(connection):
                    given.setdefault("Strict-Transport-Security", ONLY_HTTPS)
                if path.startswith("/api/"):
                    given["Cache-Control"] = "no-store"
            await send(message)

        if not ours:
            answer = JSONResponse({"detail": NOT_OURS}, 421)
        elif not may_pass(scope["method"], path, connection):
            answer = JSONResponse({"detail": NOT_OUR_PAGE}, 403)
        else:
            body = self._bodies.of(connection, receive)
            try:
                await body.begin()
            except HTTPException as refused:
                answer = JSONResponse({"detail": refused.detail}, refused.status_code)
            else:
                try:
                    await self._app(scope, body.receive, with_headers)
                finally:
                    body.end()
                return
        await answer(scope, receive, with_headers)
