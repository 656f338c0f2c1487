"""The address by which another screen in the building reaches this program."""

import ipaddress
import socket
from contextlib import suppress
from typing import NamedTuple
from urllib.parse import urlsplit

from starlette.requests import HTTPConnection

from app.settings import Settings

# Addresses for documentation only (RFC 5737, 3849): connecting a UDP socket to them sends nothing.
FAR_AWAY = {socket.AF_INET: ("192.0.2.1", 9), socket.AF_INET6: ("2001:db8::1", 9)}


class OwnAddress(NamedTuple):
    """The address of the pages, and whether only this machine can open them."""

    base: str  # ends in a slash
    only_here: bool


def own_address(settings: Settings, connection: HTTPConnection) -> OwnAddress:
    """Return the address for another screen.

    This is the address of the request itself, unless that is a loopback address; otherwise the address that the
    program listens on, or this machine's address on the network when it listens on all. Behind a proxy it is the
    proxy's.
    """
    if settings.public_name:
        return OwnAddress(f"https://{settings.public_name}/", only_here=False)
    scheme = "https" if connection.url.scheme in {"https", "wss"} else "http"
    requested = urlsplit(f"//{connection.headers.get('host', '')}")
    if requested.hostname and not is_loopback(requested.hostname) and not is_loopback(settings.host):
        return OwnAddress(f"{scheme}://{requested.netloc}/", only_here=False)
    host = settings.host
    with suppress(ValueError):
        if ipaddress.ip_address(host).is_unspecified:
            host = address_on_network(socket.AF_INET6 if ":" in host else socket.AF_INET) or "127.0.0.1"
    shown = f"[{host}]" if ":" in host else host
    return OwnAddress(f"{scheme}://{shown}:{settings.port}/", only_here=is_loopback(host))


def is_loopback(host: str) -> bool:
    """Return whether a host is a loopback address or name, which means this machine."""
    try:
        return ipaddress.ip_address(host.strip("[]")).is_loopback
    except ValueError:
        return host == "localhost" or host.endswith(".localhost")


def address_on_network(family: socket.AddressFamily) -> str | None:
    """Return the address of this machine on the network, None when it is on none."""
    try:
        with socket.socket(family, socket.SOCK_DGRAM) as probe:
            probe.connect(FAR_AWAY[family])
            return str(probe.getsockname()[0])
    except OSError:
        return None
