"""Requests that come through the clinic's own reverse proxy: its forwarded headers are believed, no others are."""

from typing import Any

from fastapi.responses import JSONResponse
from starlette.datastructures import Headers, MutableHeaders
from starlette.types import ASGIApp, Receive, Scope, Send

from app.api.nearby import parsed_address
from app.api.response_headers import HEADERS
from app.settings import ProxyNetwork, Settings
from app.texts import Text

CLIENT, SCHEME, HOST = "x-forwarded-for", "x-forwarded-proto", "x-forwarded-host"
REFUSED = 1008  # close code of a websocket; before it is accepted, uvicorn answers 403

NOT_THE_PROXY = Text("api-not-the-proxy")
INCOMPLETE = Text("api-proxy-incomplete")
NOT_ENCRYPTED = Text("api-proxy-not-encrypted")


class ForwardingError(Exception):
    """Why a request is refused, as one sentence."""


class BehindProxy:
    """Replaces client, scheme and host of a request by those that the proxy reports, or refuses the request.

    All that comes after it sees the request as the browser sent it to the proxy. The headers stay, so that a real
    chair is not set in motion through a proxy (app/api/nearby.py). Without a proxy in the settings nothing is changed.
    """

    def __init__(self, app: ASGIApp, settings: Settings) -> None:
        self._app = app
        self._settings = settings

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Pass on a request of a browser, or refuse it."""
        proxy = self._settings.proxy
        if proxy is None or scope["type"] not in {"http", "websocket"}:
            await self._app(scope, receive, send)
            return
        try:
            scope = forwarded(scope, proxy)
        except ForwardingError as reason:
            if scope["type"] == "websocket":
                await send({"type": "websocket.close", "code": REFUSED})
            else:
                await JSONResponse({"detail": str(reason)}, 403, HEADERS)(scope, receive, send)
            return
        await self._app(scope, receive, send)


def forwarded(scope: Scope, proxy: ProxyNetwork) -> dict[str, Any]:
    """Return the scope of a request as the browser sent it to the proxy.

    Of X-Forwarded-For the last address counts: the proxy itself has added it, whatever the browser has sent.

    Raises
    ------
    ForwardingError
        When the request does not come from the proxy, says too little, or was not encrypted on its way to the proxy.
    """
    headers = Headers(scope=scope)
    sender = parsed_address((scope.get("client") or [""])[0])
    if sender is None or sender not in proxy:
        raise ForwardingError(NOT_THE_PROXY)
    client = parsed_address(",".join(headers.getlist(CLIENT)).rpartition(",")[2].strip())
    schemes, hosts = headers.getlist(SCHEME), headers.getlist(HOST)
    if client is None or len(schemes) != 1 or len(hosts) != 1:
        raise ForwardingError(INCOMPLETE)
    if schemes[0].lower() != "https":
        raise ForwardingError(NOT_ENCRYPTED)
    scheme = "wss" if scope["type"] == "websocket" else "https"
    as_sent = {**scope, "client": (str(client), 0), "scheme": scheme, "headers": list(scope["headers"])}
    MutableHeaders(scope=as_sent)["host"] = hosts[0]
    return as_sent
