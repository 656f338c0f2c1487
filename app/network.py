"""How other machines reach the pages over https: names, addresses and the certificate (ports: app/ports.py)."""

from dataclasses import dataclass
from datetime import datetime

from app.texts import Text


@dataclass(frozen=True, slots=True)
class CertificateTrust:
    """The facts of the machine's certificate, and the root that a tablet installs in order to trust it."""

    names: tuple[str, ...]  # in lower case; *.clinic.example stands for every name of one label more
    addresses: tuple[str, ...]  # the one to show to people first
    start: datetime
    end: datetime
    fingerprint: str  # SHA-256 of the root, or of a clinic's own certificate, in hexadecimal digits
    root: bytes | None  # DER; None: the clinic has a certificate of its own, and its tablets trust it already


@dataclass(slots=True)
class NetworkService:
    """The ports for other machines, and what holds at the moment; `trust` is replaced when addresses change."""

    https_port: int
    page_port: int | None  # of the page that explains, over http; None: there is none
    trust: CertificateTrust

    def covers(self, host: str) -> bool:
        """Return whether the certificate names this host."""
        return host in self.trust.addresses or self.names(host)

    def names(self, host: str) -> bool:
        """Return whether `host` is one of the machine's own names."""
        return host in self.trust.names or f"*.{host.partition('.')[2]}" in self.trust.names

    def link(self, host: str | None = None) -> str:
        """Return the address of the pages over https; without `host` the best one for people."""
        return link("https", host or self.best_host, self.https_port)

    def page_link(self, host: str | None = None) -> str:
        """Return the address to begin with: the page that explains, or the pages when there is nothing to install."""
        if self.page_port is None or self.trust.root is None:
            return self.link(host)
        return link("http", host or self.best_host, self.page_port)

    @property
    def certificate_hint(self) -> str:
        """Return what a device that does not know the clinic's authority needs first; empty when there is none."""
        return "" if self.trust.root is None else str(Text("network-page-first", page=self.page_link()))

    @property
    def best_host(self) -> str:
        """Return the address to show, which needs no name server, unless the certificate has names only."""
        names = [name for name in self.trust.names if not name.startswith("*.")]
        return next(iter([*self.trust.addresses, *names]), "localhost")


def link(scheme: str, host: str, port: int) -> str:
    """Return an address that ends in a slash; the scheme's usual port is left out."""
    bracketed = f"[{host}]" if ":" in host else host
    usual = {"http": 80, "https": 443}[scheme]
    return f"{scheme}://{bracketed}/" if port == usual else f"{scheme}://{bracketed}:{port}/"
