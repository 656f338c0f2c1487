"""`bodydrive serve --lan`: the sockets for other machines, their certificate, and what is printed about both."""

import ipaddress
import socket
from contextlib import ExitStack
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

from app.cli.errors import InputError
from app.cli.port import bind_free
from app.cli.qr import terminal_code
from app.network import NetworkService
from app.ports import HTTP_PORT, HTTPS_PORT
from app.refusals import Refusal
from app.texts import Text, text_of

if TYPE_CHECKING:
    from app.host.certificate import ServerCertificate

LOCAL_PORTS = (HTTP_PORT, 0)  # for this machine's own browser, first choice first
PAGE_PORTS = (80, 8081, 0)  # for the page that explains
EVERY_ADDRESS = ("0.0.0.0", "::")  # noqa: S104  (over https, and the page that explains)

SCAN = Text("cli-scan")
MOVED = Text("cli-scan-again")


@dataclass(slots=True)
class OwnFiles:
    """The files of a clinic that has a certificate of its own."""

    certificate: Path
    key: Path


class Lan:
    """What other machines in the network reach: the pages over https, and over http the page that explains."""

    def __init__(self, hosts: list[str], port: int | None, folder: Path, own_files: OwnFiles | None) -> None:
        every = hosts or EVERY_ADDRESS[: 2 if socket.has_dualstack_ipv6() else 1]
        with ExitStack() as stack:
            self.https = [
                stack.enter_context(each) for each in bind_free(every, [HTTPS_PORT if port is None else port])
            ]
            self.page = [stack.enter_context(each) for each in bind_free(every, (0,) if port == 0 else PAGE_PORTS)]
            bound = [ipaddress.ip_address(each.getsockname()[0]) for each in self.https]
            only = () if any(address.is_unspecified for address in bound) else tuple(bound)
            self.certificate = _certificate(only, folder, own_files)
            self._close = stack.pop_all()
        self.service = NetworkService(
            self.https[0].getsockname()[1], self.page[0].getsockname()[1], self.certificate.trust
        )
        self._printed_address = ""
        self._printed: list[Text | str] = []

    def __enter__(self) -> "Lan":
        return self

    def __exit__(self, *_error: object) -> None:
        self._close.close()

    def refresh(self) -> list[Text | str]:
        """Follow the machine's addresses and renew the certificate; return the lines to be printed now."""
        sentences = self.certificate.refresh()
        self.service.trust = self.certificate.trust
        lines = [sentence for sentence in sentences if sentence not in self._printed]
        self._printed = sentences
        address = self.service.page_link()
        if address != self._printed_address:
            lines += [MOVED if self._printed_address else SCAN, terminal_code(address).rstrip("\n"), address]
            self._printed_address = address
        return lines


def bind_local(port: int | None) -> socket.socket:
    """Bind the port for this machine's own browser; any free one when the usual one is busy, or with port 0."""
    return bind_free(["127.0.0.1"], (0,) if port == 0 else LOCAL_PORTS)[0]


def own_files(certificate: Path | None, key: Path | None, *, lan: bool) -> OwnFiles | None:
    """Return the files of an own certificate, None when there is none."""
    if certificate is None and key is None:
        return None
    if not lan:
        raise InputError(Text("cli-certificate-needs-lan"))
    if certificate is None or key is None:
        raise InputError(Text("cli-certificate-needs-key"))
    return OwnFiles(certificate, key)


def _certificate(
    only: tuple[ipaddress.IPv4Address | ipaddress.IPv6Address, ...], folder: Path, own_files: OwnFiles | None
) -> "ServerCertificate":
    from app.host.certificate import LocalCertificate, OwnCertificate
    from app.host.machine import this_machine

    try:
        if own_files is not None:
            return OwnCertificate(own_files.certificate, own_files.key)
        return LocalCertificate(folder, lambda: this_machine(only))
    except Refusal as refusal:
        raise InputError(text_of(refusal)) from refusal
