"""The program's cookies: over https they have the prefixes that a browser accepts from an encrypted answer only.

Cookies are shared by all ports of an address. With two names, a page that somebody else serves there over http can
neither read nor replace the cookie that counts over https.
"""

from typing import Any

from starlette.requests import HTTPConnection
from starlette.responses import Response


def is_encrypted(connection: HTTPConnection) -> bool:
    """Return whether a request or a websocket came over https."""
    return connection.scope["scheme"] in {"https", "wss"}


def cookie_name(connection: HTTPConnection, name: str, path: str = "/") -> str:
    """Return the full name of a cookie on this connection; browsers accept `__Host-` for the path / only."""
    if not is_encrypted(connection):
        return name
    return f"__Host-{name}" if path == "/" else f"__Secure-{name}"


def read_cookie(connection: HTTPConnection, name: str, path: str = "/") -> str | None:
    """Return the value of a cookie, None when the browser did not send it."""
    return connection.cookies.get(cookie_name(connection, name, path))


def set_cookie(
    connection: HTTPConnection, response: Response, name: str, value: str, path: str = "/", **more: Any
) -> None:
    """Set a cookie that scripts cannot read; `more` is for Starlette's `set_cookie`."""
    more = {"samesite": "lax", **more}
    full = cookie_name(connection, name, path)
    response.set_cookie(full, value, path=path, httponly=True, secure=is_encrypted(connection), **more)


def delete_cookie(connection: HTTPConnection, response: Response, name: str) -> None:
    """Delete a cookie with the path /."""
    full = cookie_name(connection, name)
    response.delete_cookie(full, path="/", httponly=True, samesite="lax", secure=is_encrypted(connection))
