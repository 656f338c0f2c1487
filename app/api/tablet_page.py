"""The page that explains to a tablet how to trust this machine: the only thing that is served over plain http.

It is an application of its own, beside the clinic's. It knows no database and no person, and answers these paths only:
the page and its parts, the facts that the page shows, and the two files that a device installs.
"""

from typing import Final
from urllib.parse import urlsplit

from starlette.datastructures import Headers
from starlette.responses import JSONResponse, PlainTextResponse, Response
from starlette.types import Receive, Scope, Send
from starlette.websockets import WebSocketClose

from app.api.pages import ASK_AGAIN, read_entry
from app.api.response_headers import TABLET_HEADERS, TABLET_POLICY
from app.clock import utc_now
from app.host.authority_files import apple_profile, root_pem
from app.network import NetworkService
from app.settings import static_folder
from app.texts import LANGUAGES, Text, current_language

PAGE: Final = "tablet.html"
NOTHING_ELSE: Final = Text("api-only-tablet-page")
NO_ROOT: Final = Text("api-own-certificate")


class TabletPage:
    """ASGI application of the page that explains."""

    def __init__(self, network: NetworkService) -> None:
        self._network = network
        self._files = {language: read_entry(static_folder(), PAGE, language) for language in LANGUAGES}

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Answer a request."""
        if scope["type"] == "websocket":
            await WebSocketClose()(scope, receive, send)
            return
        answer = self._answer(scope)
        answer.headers.update(TABLET_HEADERS)
        await answer(scope, receive, send)

    def _answer(self, scope: Scope) -> Response:
        if scope["method"] not in {"GET", "HEAD"}:
            return PlainTextResponse(str(NOTHING_ELSE), 405)
        link = self._network.link(self._host(Headers(scope=scope)))
        name = scope["path"].lstrip("/") or PAGE
        if name == "facts.json":
            return JSONResponse(self._facts(link), headers={"Cache-Control": "no-store"})
        if name == "bodydrive.mobileconfig":
            return self._download("application/x-apple-aspen-config", name)
        if name == "bodydrive-authority.crt":
            return self._download("application/x-x509-ca-cert", name)
        files = self._files[current_language()]
        if name not in files:
            return PlainTextResponse(str(NOTHING_ELSE), 404)
        file = files[name]
        headers = {"Content-Type": file.kind, "Cache-Control": ASK_AGAIN, "Vary": "Accept-Language, Cookie"}
        if name == PAGE:
            headers["Content-Security-Policy"] = TABLET_POLICY.format(https=link.rstrip("/"))
        return Response(file.content, headers=headers)

    def _host(self, headers: Headers) -> str | None:
        """Return the host by which the page was opened, None when the certificate does not name it."""
        try:
            host = urlsplit(f"//{headers.get('host', '')}").hostname
        except ValueError:
            return None
        return host if host is not None and self._network.covers(host) else None

    def _facts(self, link: str) -> dict[str, object]:
        trust = self._network.trust
        return {
            "link": link,
            "check": f"{link}api/v1/trust",
            "name": next((name for name in trust.names if name.endswith(".local")), link),
            "fingerprint": trust.fingerprint,
            "installs": trust.root is not None,
            "start": trust.start.isoformat(),
            "end": trust.end.isoformat(),
            "now": utc_now().isoformat(),
        }

    def _download(self, kind: str, name: str) -> Response:
        trust = self._network.trust
        if trust.root is None:
            return PlainTextResponse(str(NO_ROOT), 404)
        names = [each.removesuffix(".local") for each in trust.names if each.endswith(".local")]
        machine: Text | str = names[0] if names else Text("host-nameless-machine")
        content = apple_profile(trust.root, machine) if name.endswith(".mobileconfig") else root_pem(trust.root)
        disposition = f'attachment; filename="{name}"'
        return Response(content, media_type=kind, headers={"Content-Disposition": disposition})
