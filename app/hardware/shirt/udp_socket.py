"""The socket of a shirt over the network."""

import errno
import socket
from ipaddress import ip_address
from typing import Final, Literal

from app.hardware.base import HardwareError
from app.texts import Text

KERNEL_BUFFER: Final = 1 << 20  # bytes: one second of frames at 1 kHz, for a hold-up of the loop
CAUSES: Final = {errno.EADDRINUSE: "taken", errno.EACCES: "forbidden", errno.EADDRNOTAVAIL: "elsewhere"}


def bound_socket(host: str, port: int) -> socket.socket:
    """Return a UDP socket that listens on an address of this machine; port 0: any free one.

    Raises
    ------
    HardwareError
        When the address is not of this machine, or its port is in use or reserved.
    """
    try:
        family, kind, _, _, address = socket.getaddrinfo(host, port, type=socket.SOCK_DGRAM)[0]
    except (OSError, UnicodeError) as error:
        raise HardwareError(Text("shirtdev-udp-no-address", host=host)) from error
    listening = socket.socket(family, kind)
    try:
        listening.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, KERNEL_BUFFER)
        listening.bind(address)
    except OSError as error:
        listening.close()
        cause, why = CAUSES.get(error.errno or 0, "other"), error.strerror or ""
        raise HardwareError(Text("shirtdev-udp-failed", place=f"{host}:{port}", why=why, cause=cause)) from error
    return listening


def reach_of(listening: socket.socket) -> Literal["machine", "network"]:
    """Return whether only programs on this machine can send to a socket, or others as well."""
    return "machine" if ip_address(listening.getsockname()[0]).is_loopback else "network"
