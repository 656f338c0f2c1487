"""Whether a request comes from our own page: checked for everything that changes something, and every websocket."""

from urllib.parse import urlsplit

from starlette.datastructures import Headers

from app.settings import Settings

READING = frozenset({"GET", "HEAD"})
STOP = "/api/v1/control/stop"


def host_is_ours(settings: Settings, headers: Headers) -> bool:
    """Tell whether the request was addressed to us and not to a foreign name that points here."""
    try:
        host = urlsplit(f"//{headers.get('host', '')}").hostname
    except ValueError:
        return False
    return host is not None and settings.serves(host)


def origin_is_ours(headers: Headers) -> bool:
    """Tell whether the page that sends this request was loaded from the very address it sends it to."""
    origin = headers.get("origin")
    if not origin:
        return False
    try:
        parts = urlsplit(origin)
    except ValueError:
        return False
    return parts.scheme in {"http", "https"} and parts.netloc == headers.get("host")


def may_pass(method: str, path: str, headers: Headers) -> bool:
    """Tell whether a request may go on to its route as far as its origin is concerned.

    A stop may also come from a program that names no origin: it can only make things safer.
    """
    if method in READING or origin_is_ours(headers):
        return True
    return path == STOP and "origin" not in headers
