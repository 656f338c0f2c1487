"""Check that a request comes from our own page: for every change, and every websocket."""

from urllib.parse import urlsplit

from starlette.datastructures import Headers
from starlette.requests import HTTPConnection

from app.api.sign_in.cookies import is_encrypted
from app.settings import Settings

READING = frozenset({"GET", "HEAD"})
STOP = "/api/v1/control/stop"


def host_is_ours(settings: Settings, headers: Headers) -> bool:
    """Return whether the request's host is one of ours, and not a foreign name that resolves to this machine."""
    try:
        host = urlsplit(f"//{headers.get('host', '')}").hostname
    except ValueError:
        return False
    return host is not None and settings.serves(host)


def origin_is_ours(connection: HTTPConnection) -> bool:
    """Return whether the page that sends this request was loaded from the address that it sends it to.

    The page must have been loaded over https when the request comes over https: anybody can serve pages over http.
    """
    origin = connection.headers.get("origin")
    if not origin:
        return False
    try:
        parts = urlsplit(origin)
    except ValueError:
        return False
    scheme = "https" if is_encrypted(connection) else "http"
    return parts.scheme == scheme and parts.netloc == connection.headers.get("host")


def may_pass(method: str, path: str, connection: HTTPConnection) -> bool:
    """Return whether the origin of a request permits it.

    A stop may also come from a program that sends no origin, such as a button on the wall: it can only make things
    safer. A page of another site is no such program, also in a browser that leaves the origin out.
    """
    if method in READING or origin_is_ours(connection):
        return True
    from_a_program = connection.headers.get("sec-fetch-site", "none") in {"none", "same-origin"}
    return path == STOP and "origin" not in connection.headers and from_a_program
