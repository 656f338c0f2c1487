"""The machine's names and addresses on the network."""

import ipaddress
import re
import socket
from dataclasses import dataclass

import psutil

Address = ipaddress.IPv4Address | ipaddress.IPv6Address
Network = ipaddress.IPv4Network | ipaddress.IPv6Network

LABEL = r"[a-z0-9]([a-z0-9-]{0,61}[a-z0-9])?"
NAME = re.compile(rf"{LABEL}(\.{LABEL})*")
LONGEST_NAME = 200  # characters of a full name; a DNS name has at most 253


@dataclass(frozen=True, slots=True)
class Machine:
    """What other machines call this one."""

    name: str | None  # None: it has no name that may stand in a certificate
    addresses: tuple[Address, ...]  # the one to show to people first
    networks: tuple[Network, ...]  # to which the addresses belong

    @property
    def names(self) -> tuple[str, ...]:
        """Return the machine's name, NAME.local (multicast DNS) and localhost."""
        if self.name is None or self.name == "localhost":
            return ("localhost",)
        return tuple(dict.fromkeys([self.name, f"{self.name.split('.')[0]}.local", "localhost"]))


def this_machine(only: tuple[Address, ...] = ()) -> Machine:
    """Return the names and addresses of this machine; `only` some addresses when the program listens to no others.

    IPv6 addresses of a single link are left out: a browser cannot open them.
    """
    network_of: dict[Address, Network] = {}
    for interface in psutil.net_if_addrs().values():
        for entry in interface:
            if entry.family not in {socket.AF_INET, socket.AF_INET6}:
                continue
            try:
                interface_address = ipaddress.ip_interface(_with_prefix(entry.address, entry.netmask))
            except ValueError:
                continue
            if not (interface_address.version == 6 and interface_address.ip.is_link_local):
                network_of[interface_address.ip] = interface_address.network
    network_of |= {address: ipaddress.ip_network(address) for address in only if address not in network_of}
    first = _first_address()
    addresses = [each for each in network_of if not only or each in only or each.is_loopback]
    addresses.sort(key=lambda each: (bool(only) and each not in only, each.is_loopback, each != first, each.version))
    return Machine(certifiable(socket.gethostname()), tuple(addresses), tuple(dict.fromkeys(network_of.values())))


def certifiable(name: str) -> str | None:
    """Return a machine's name in lower case, None when it is no name that a certificate can carry."""
    lower = name.lower().rstrip(".")
    is_address = re.fullmatch(r"[0-9.]*", lower) is not None
    return lower if NAME.fullmatch(lower) and len(lower) <= LONGEST_NAME and not is_address else None


def _with_prefix(address: str, netmask: str | None) -> str:
    """Return ADDRESS/BITS; without a mask the network is this single address."""
    parsed = ipaddress.ip_address(address.partition("%")[0])
    bits = parsed.max_prefixlen if netmask is None else int(ipaddress.ip_address(netmask)).bit_count()
    return f"{parsed}/{bits}"


def _first_address() -> Address | None:
    """Return the IPv4 address from which this machine reaches others, None without a route."""
    try:
        with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as probe:
            probe.connect(("192.0.2.1", 9))  # an address for documentation (RFC 5737): nothing is sent
            return ipaddress.ip_address(str(probe.getsockname()[0]))
    except OSError:
        return None
