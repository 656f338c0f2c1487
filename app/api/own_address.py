"""The address by which another screen in the building reaches this program."""

import ipaddress
from typing import NamedTuple
from urllib.parse import urlsplit

from starlette.requests import HTTPConnection

from app.api.sign_in.cookies import is_encrypted
from app.network import link
from app.settings import Settings
from app.texts import Text

ONLY_HERE = Text("api-link-only-here")
ONLY_IN_NETWORK = Text("api-link-only-in-network")


class OwnAddress(NamedTuple):
    """The address of the pages, and whether only this machine can open them."""

    base: str  # ends in a slash
    only_here: bool


def own_address(settings: Settings, connection: HTTPConnection) -> OwnAddress:
    """Return the address for another screen.

    Behind a proxy this is the proxy's. Otherwise it is the address of the request itself when it came over https from
    another machine, else the one at which the program serves the network, or, when it serves this machine only, its
    own.
    """
    if settings.public_name:
        return OwnAddress(f"https://{settings.public_name}/", only_here=False)
    requested = urlsplit(f"//{connection.headers.get('host', '')}")
    if is_encrypted(connection) and requested.hostname and not is_loopback(requested.hostname):
        return OwnAddress(f"https://{requested.netloc}/", only_here=False)
    if settings.network is not None:
        return OwnAddress(settings.network.link(), is_loopback(settings.network.best_host))
    return OwnAddress(link("http", settings.host, settings.port), only_here=True)


def link_hint(settings: Settings, address: OwnAddress) -> str:
    """Return where a link to this address does not work, and what a new device needs first; empty: nothing to say."""
    return " ".join(filter(None, (str(ONLY_HERE) if address.only_here else "", setup_hint(settings))))


def setup_hint(settings: Settings) -> str:
    """Return what a device needs before it opens its first link; empty: nothing."""
    return settings.network.certificate_hint if settings.network else ""


def reach_hint(settings: Settings, address: OwnAddress) -> str:
    """Return from where a link for somebody outside does not open; empty: it opens from everywhere, by the proxy."""
    if settings.public_name:
        return ""
    return str(ONLY_HERE if address.only_here else ONLY_IN_NETWORK)


def is_loopback(host: str) -> bool:
    """Return whether a host is a loopback address or name, which means this machine."""
    try:
        return ipaddress.ip_address(host.strip("[]")).is_loopback
    except ValueError:
        return host == "localhost" or host.endswith(".localhost")
