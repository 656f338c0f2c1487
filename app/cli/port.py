"""The port that a clinic listens on, the proxy before it, and the address to open in a browser."""

import errno
import ipaddress
import socket
from collections.abc import Sequence
from urllib.parse import urlsplit

from app.cli.errors import InputError
from app.hardware.addresses import checked_host
from app.ports import HTTP_PORT
from app.settings import ProxyNetwork
from app.texts import Text

# A browser that does not answer for so long has gone: a tablet asleep, a cable pulled. Busy browsers need some time;
# the live socket and the 3D view themselves disconnect, within 3 s, a browser that does not read.
PING_LIMIT = 20.0  # s

LARGEST_NETWORK = 65_536  # addresses that may speak for a browser; whole networks of people are no proxies


def bind(host: str, port: int) -> socket.socket:
    """Bind the port before anything else is made; refuse a port in use with a sentence."""
    no_address = Text("cli-no-address", host=host)
    try:
        if not host.strip():  # would mean every address of this machine
            raise UnicodeError
        family = socket.AF_INET6 if ":" in host else socket.AF_INET
        listening = socket.create_server((host, port), family=family, backlog=128)
    except OSError as error:
        if error.errno == errno.EADDRINUSE:
            next_port = port + 1 if port < 65_535 else HTTP_PORT
            raise InputError(Text("cli-port-busy", port=port, host=host, next=next_port)) from error
        if error.errno == errno.EACCES:
            raise InputError(Text("cli-port-of-system", port=port)) from error
        raise InputError(no_address) from error
    except UnicodeError as error:
        raise InputError(no_address) from error
    # Otherwise the end of an answer waits up to 40 ms for the browser to confirm its beginning.
    listening.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
    # Without this, the connection of a machine that has vanished stays open for a quarter of an hour.
    if hasattr(socket, "TCP_USER_TIMEOUT"):
        listening.setsockopt(socket.IPPROTO_TCP, socket.TCP_USER_TIMEOUT, int(1000 * PING_LIMIT))
    return listening


def proxy_network(text: str) -> ProxyNetwork:
    """Return the address or network of the proxy."""
    try:
        network = ipaddress.ip_network(text, strict=False)
    except ValueError as error:
        raise InputError(Text("cli-proxy-no-address", text=text)) from error
    if network.num_addresses > LARGEST_NETWORK:
        raise InputError(Text("cli-proxy-too-large", text=text))
    return network


def public_name(text: str) -> str:
    """Return the name by which browsers reach the proxy, with its port when it is not that of https."""
    try:
        parts = urlsplit(f"//{text}")
        host, port = checked_host(parts.hostname or ""), parts.port
    except ValueError as error:
        raise InputError(Text("cli-no-public-name", text=text)) from error
    bracketed = f"[{host}]" if ":" in host else host
    name = bracketed if port is None else f"{bracketed}:{port}"
    if name != text.lower():  # a path, a person, or a scheme
        raise InputError(Text("cli-no-public-name", text=text))
    return name


def bind_here(host: str, port: int) -> socket.socket:
    """Bind an address that only this machine reaches; refuse others, because nothing is encrypted there."""
    listening = bind(host, port)
    if ipaddress.ip_address(listening.getsockname()[0]).is_loopback:
        return listening
    listening.close()
    raise InputError(Text("cli-not-encrypted", host=host))


def bind_free(hosts: Sequence[str], ports: Sequence[int]) -> list[socket.socket]:
    """Bind all addresses to the first of these ports that is free on all of them; 0 is any free port."""
    for port in ports:
        bound: list[socket.socket] = []
        try:
            for host in hosts:
                bound.append(bind(host, bound[0].getsockname()[1] if bound else port))
        except InputError:
            for listening in bound:
                listening.close()
            if port == ports[-1]:
                raise
        else:
            return bound
    return []
