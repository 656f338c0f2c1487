"""The port that a clinic listens on, the proxy before it, and the address to open in a browser."""

import errno
import ipaddress
import socket
from collections.abc import Sequence
from urllib.parse import urlsplit

from app.cli.errors import InputError
from app.hardware.addresses import checked_host
from app.settings import ProxyNetwork

# A browser that does not answer for so long has gone: a tablet asleep, a cable pulled. Busy browsers need some time;
# the live socket and the 3D view themselves disconnect, within 3 s, a browser that does not read.
PING_LIMIT = 20.0  # s

LARGEST_NETWORK = 65_536  # addresses that may speak for a browser; whole networks of people are no proxies


def bind(host: str, port: int) -> socket.socket:
    """Bind the port before anything else is made; refuse a port in use with a sentence."""
    no_address = f"'{host}' is no address of this machine: leave --host out, or give one of its own."
    try:
        if not host.strip():  # would mean every address of this machine
            raise UnicodeError
        family = socket.AF_INET6 if ":" in host else socket.AF_INET
        listening = socket.create_server((host, port), family=family, backlog=128)
    except OSError as error:
        if error.errno == errno.EADDRINUSE:
            raise InputError(
                f"Port {port} of {host} is busy: end the program that uses it, or choose another port with --port "
                f"(with make: PORT={port + 1 if port < 65_535 else 8080})."
            ) from error
        if error.errno == errno.EACCES:
            raise InputError(f"Port {port} is for the system: choose one above 1023 with --port.") from error
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
        raise InputError(
            f"--behind-proxy '{text}' is no address: write one such as 127.0.0.1, or 10.1.2.0/24."
        ) from error
    if network.num_addresses > LARGEST_NETWORK:
        raise InputError(f"--behind-proxy {text} has too many addresses to be believed: give that of the proxy.")
    return network


def public_name(text: str) -> str:
    """Return the name by which browsers reach the proxy, with its port when it is not that of https."""
    try:
        parts = urlsplit(f"//{text}")
        host, port = checked_host(parts.hostname or ""), parts.port
    except ValueError as error:
        raise InputError(f"--name '{text}' is no name: write one such as clinic.example.org.") from error
    bracketed = f"[{host}]" if ":" in host else host
    name = bracketed if port is None else f"{bracketed}:{port}"
    if name != text.lower():  # a path, a person, or a scheme
        raise InputError(f"--name '{text}' is no name: write one such as clinic.example.org.")
    return name


def bind_here(host: str, port: int) -> socket.socket:
    """Bind an address that only this machine reaches; refuse others, because nothing is encrypted there."""
    listening = bind(host, port)
    if ipaddress.ip_address(listening.getsockname()[0]).is_loopback:
        return listening
    listening.close()
    raise InputError(
        f"Other machines reach {host}, and without https everybody on the way could read and change what they send: "
        f"use 'bodydrive serve --lan', or leave --host out."
    )


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
