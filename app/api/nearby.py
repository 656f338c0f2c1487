"""Check that a request comes from within the building, where a person can see the chair that they set in motion."""

import ipaddress

from fastapi import HTTPException
from starlette.requests import HTTPConnection

from app.texts import Text

# Private, link-local and loopback networks (RFC 1918, 3927, 4193, 4291); other "not global" ones may be elsewhere.
NEAR = [
    ipaddress.ip_network(network)
    for network in (
        "127.0.0.0/8",
        "10.0.0.0/8",
        "172.16.0.0/12",
        "192.168.0.0/16",
        "169.254.0.0/16",
        "::1/128",
        "fc00::/7",
        "fe80::/10",
    )
]
PASSED_ON = ("forwarded", "via", "x-real-ip")  # headers of a request that a proxy forwards

FAR = Text("api-far")


def is_nearby(connection: HTTPConnection) -> bool:
    """Return whether a request comes directly from a machine in the building's own network."""
    names = [name.lower() for name in connection.headers]
    if any(name in PASSED_ON or name.startswith("x-forwarded") for name in names) or connection.client is None:
        return False
    address = parsed_address(connection.client.host)
    return address is not None and any(address in network for network in NEAR)


def parsed_address(text: str) -> ipaddress.IPv4Address | ipaddress.IPv6Address | None:
    """Return an IP address without its zone, as IPv4 where it stands for one; None for any other text."""
    try:
        address = ipaddress.ip_address(text.partition("%")[0])
    except ValueError:
        return None
    mapped = address.ipv4_mapped if isinstance(address, ipaddress.IPv6Address) else None
    return mapped or address


def require_nearby(connection: HTTPConnection) -> None:
    """Raise 403 unless the request comes from within the building."""
    if not is_nearby(connection):
        raise HTTPException(403, FAR)
