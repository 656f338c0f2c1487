"""Under which address another screen in the building finds this program."""

import ipaddress
import socket
from contextlib import suppress
from typing import NamedTuple
from urllib.parse import urlsplit

from starlette.requests import HTTPConnection

from app.settings import Settings

# Addresses that are for documentation only (RFC 5737, 3849): asking for the way to them sends nothing.
FAR_AWAY = {socket.AF_INET: ("192.0.2.1", 9), socket.AF_INET6: ("2001:db8::1", 9)}


class OwnAddress(NamedTuple):
    """Where the pages are, and whether another machine can open them."""

    base: str  # ends in a slash
    only_here: bool


def own_address(settings: Settings, connection: HTTPConnection) -> OwnAddress:
    """Return the address for another screen.

    The one that this very request came by is known to work when it is no loopback; otherwise what the program was
    told to listen on counts, and when that is everything, the machine's own address on the network.
    """
    scheme = "https" if connection.url.scheme in {"https", "wss"} else "http"
    asked = urlsplit(f"//{connection.headers.get('host', '')}")
    if asked.hostname and not is_loopback(asked.hostname) and not is_loopback(settings.host):
        return OwnAddress(f"{scheme}://{asked.netloc}/", only_here=False)
    host = settings.host
    with suppress(ValueError):
        if ipaddress.ip_address(host).is_unspecified:
            host = address_on_network(socket.AF_INET6 if ":" in host else socket.AF_INET) or "127.0.0.1"
    shown = f"[{host}]" if ":" in host else host
    return OwnAddress(f"{scheme}://{shown}:{settings.port}/", only_here=is_loopback(host))


def is_loopback(host: str) -> bool:
    """Tell whether a host is this machine for whoever names it."""
    try:
        return ipaddress.ip_address(host.strip("[]")).is_loopback
    except ValueError:
        return host == "localhost" or host.endswith(".localhost")


def address_on_network(family: socket.AddressFamily) -> str | None:
    """Return this machine's address on the network by which it reaches others, None when it is on none."""
    try:
        with socket.socket(family, socket.SOCK_DGRAM) as asking:
            asking.connect(FAR_AWAY[family])
            return str(asking.getsockname()[0])
    except OSError:
        return None
