"""The certificate with which this machine serves https: made by the clinic's authority, or the clinic's own."""

import datetime as dt
import ipaddress
import ssl
from collections.abc import Callable
from hashlib import sha256
from pathlib import Path
from typing import Protocol

from cryptography import x509
from cryptography.hazmat.primitives import serialization

from app.clock import utc_now
from app.file_modes import OWNER_FILE
from app.files import write_atomically
from app.host.authority import (
    Identity,
    certified,
    make_intermediate,
    make_leaf,
    make_root,
    read_identity,
    signed_by,
    subjects_of,
)
from app.host.certificate_times import OWN_ENDS_SOON, ROOT_ENDS_SOON, needs_renewal
from app.host.machine import Machine, this_machine
from app.network import CertificateTrust
from app.refusals import Refusal
from app.texts import Text, text_of

KEY = b"-----BEGIN PRIVATE KEY-----"

MADE = Text("host-authority-made")
REPLACED = Text("host-authority-replaced")


class ServerCertificate(Protocol):
    """A certificate in use: new connections get the newest."""

    context: ssl.SSLContext
    trust: CertificateTrust

    def refresh(self) -> list[Text | str]:
        """Renew the certificate or reload it when that is due; return sentences for the operator."""
        ...


class LocalCertificate:
    """A certificate from the clinic's own authority; follows the machine's addresses, and renews itself.

    Raises
    ------
    Refusal
        The authority is damaged or has ended, or the machine's clock is wrong.
    """

    def __init__(
        self,
        folder: Path,
        machine: Callable[[], Machine] = this_machine,
        now: Callable[[], dt.datetime] = utc_now,
    ) -> None:
        self._folder, self._machine, self._now = folder, machine, now
        self.context = _new_context()
        self._words: list[Text | str] = []
        self._root_file = folder / "root.pem"
        if not self._root_file.exists():
            _store(self._root_file, make_root(machine(), now()))
            self._words.append(REPLACED if (folder / "machine.pem").exists() else MADE)
        self._root = self._read_root()
        unusable = self._unusable()
        if unusable:
            raise Refusal(unusable)
        intermediate = self._read("intermediate.pem")
        if intermediate is not None and not signed_by(intermediate.certificate, self._root.certificate):
            self._words = [REPLACED]
        self._leaf = self._follow(machine())
        self.context.load_cert_chain(self._folder / "machine.pem")
        self.trust = self._trust(machine())

    def refresh(self) -> list[Text | str]:
        """Follow the machine's addresses, renew what is due, and return the sentences that hold at present."""
        messages, self._words = self._words, []
        machine = self._machine()
        unusable = self._unusable()
        if unusable:
            return [unusable]
        try:
            leaf = self._follow(machine)
            if leaf.certificate != self._leaf.certificate:
                self.context.load_cert_chain(self._folder / "machine.pem")
                self._leaf = leaf
        except OSError as error:
            end = self._leaf.certificate.not_valid_after_utc
            why = error.strerror or error
            messages.append(Text("host-certificate-not-renewed", why=why, day=end.date()))
        self.trust = self._trust(machine)
        present = [*self.trust.names, *self.trust.addresses]
        outside = [each for each in (*machine.names, *map(str, machine.addresses)) if each not in present]
        if outside:
            messages.append(Text("host-authority-outside", names=", ".join(outside), file=str(self._root_file)))
        end = self._root.certificate.not_valid_after_utc
        if end - self._now() < ROOT_ENDS_SOON:
            messages.append(Text("host-authority-ends-soon", day=end.date(), file=str(self._root_file)))
        return messages

    def _unusable(self) -> Text | None:
        """Return in a sentence why the root is not valid now, None when it is."""
        root, now = self._root.certificate, self._now()
        start, end, today = root.not_valid_before_utc, root.not_valid_after_utc, now.date()
        if now < start:
            return Text("host-authority-early-clock", today=today, day=start.date())
        if now > end:
            return Text("host-authority-ended", file=str(self._root_file), day=end.date(), today=today)
        return None

    def _read_root(self) -> Identity:
        try:
            root = _read(self._root_file)
            root.certificate.extensions.get_extension_for_class(x509.NameConstraints)
        except (ValueError, TypeError, x509.ExtensionNotFound) as error:
            raise Refusal(Text("host-authority-damaged", file=str(self._root_file))) from error
        return root

    def _follow(self, machine: Machine) -> Identity:
        """Return the machine's certificate, a new one if it is due; a file that cannot be read counts as missing."""
        now, root = self._now(), self._root
        above = self._read("intermediate.pem")
        if above is None or not _holds(above, root, now):
            above = make_intermediate(root, now)
            _store(self._folder / "intermediate.pem", above)
        subjects = subjects_of(machine, root.certificate)
        leaf = self._read("machine.pem")
        if leaf is None or not _holds(leaf, above, now) or certified(leaf.certificate) != set(subjects):
            leaf = make_leaf(above, subjects, now)
            _store(self._folder / "machine.pem", leaf, above.certificate_pem)
        return leaf

    def _read(self, name: str) -> Identity | None:
        try:
            return _read(self._folder / name)
        except (FileNotFoundError, ValueError, TypeError):
            return None

    def _trust(self, machine: Machine) -> CertificateTrust:
        root = self._root.certificate.public_bytes(serialization.Encoding.DER)
        return _trust_of(self._leaf.certificate, root, [str(address) for address in machine.addresses])


class OwnCertificate:
    """A certificate from another authority; reloaded when its files change.

    Raises
    ------
    Refusal
        The files cannot be read, do not belong together, or the certificate has ended or not begun.
    """

    def __init__(self, certificate: Path, key: Path, now: Callable[[], dt.datetime] = utc_now) -> None:
        self._files = (certificate, key)
        self._now = now
        self.context = _new_context()
        self._content, self.trust = self._load()

    def refresh(self) -> list[Text | str]:
        """Reload the files if they changed; return a sentence on each problem with them."""
        try:
            if self._contents() != self._content:
                self._content, self.trust = self._load()
            self._check_time(self.trust)
        except Refusal as refusal:
            return [text_of(refusal)]
        if self.trust.end - self._now() < OWN_ENDS_SOON:
            return [Text("host-certificate-ends-soon", file=str(self._files[0]), day=self.trust.end.date())]
        return []

    def _contents(self) -> list[bytes]:
        try:
            return [file.read_bytes() for file in self._files]
        except OSError as error:
            why = error.strerror or error
            raise Refusal(Text("host-certificate-unreadable", file=str(error.filename), why=why)) from error

    def _load(self) -> tuple[list[bytes], CertificateTrust]:
        content = self._contents()
        certificate, key = self._files
        try:
            read = x509.load_pem_x509_certificate(content[0])
            # A context that could not load a certificate keeps half of it, so a new one tries first.
            _new_context().load_cert_chain(certificate, key, password=lambda: b"")
        except (ValueError, OSError) as error:
            raise Refusal(Text("host-certificate-no-pair", certificate=str(certificate), key=str(key))) from error
        trust = _trust_of(read, None, [str(address) for address in this_machine().addresses])
        self._check_time(trust)
        self.context.load_cert_chain(certificate, key)
        return content, trust

    def _check_time(self, trust: CertificateTrust) -> None:
        now, file = self._now(), str(self._files[0])
        today = now.date()
        if now > trust.end:
            raise Refusal(Text("host-certificate-ended", file=file, day=trust.end.date(), today=today))
        if now < trust.start:
            raise Refusal(Text("host-certificate-early-clock", file=file, day=trust.start.date(), today=today))


def _new_context() -> ssl.SSLContext:
    context = ssl.SSLContext(ssl.PROTOCOL_TLS_SERVER)
    context.minimum_version = ssl.TLSVersion.TLSv1_2
    context.set_alpn_protocols(["http/1.1"])
    return context


def _holds(identity: Identity, issuer: Identity, now: dt.datetime) -> bool:
    """Return whether a certificate is of this issuer and need not be renewed."""
    certificate = identity.certificate
    if not signed_by(certificate, issuer.certificate):
        return False
    # One that ends with its issuer cannot be made longer.
    start, end = certificate.not_valid_before_utc, certificate.not_valid_after_utc
    lasts = end >= issuer.certificate.not_valid_after_utc and start <= now <= end
    return lasts or not needs_renewal(certificate, now)


def _read(file: Path) -> Identity:
    certificate, mark, key = file.read_bytes().partition(KEY)
    return read_identity(certificate, mark + key)


def _store(file: Path, identity: Identity, above: bytes = b"") -> None:
    write_atomically(file, identity.certificate_pem + above + identity.key_pem, OWNER_FILE)


def _trust_of(certificate: x509.Certificate, root: bytes | None, order: list[str]) -> CertificateTrust:
    """Return the facts of a certificate; its addresses are put in this order."""
    subjects = certified(certificate)
    addresses = {str(each.value) for each in subjects if isinstance(each, x509.IPAddress)}
    names = sorted(each.value.lower() for each in subjects if isinstance(each, x509.DNSName))
    public_bytes = certificate.public_bytes(serialization.Encoding.DER)
    return CertificateTrust(
        names=tuple(names),
        addresses=tuple([each for each in order if each in addresses] or sorted(addresses, key=_readable)),
        start=certificate.not_valid_before_utc,
        end=certificate.not_valid_after_utc,
        fingerprint=sha256(root or public_bytes).hexdigest(),
        root=root,
    )


def _readable(address: str) -> tuple[int, int]:
    read = ipaddress.ip_address(address)
    return read.version, int(read)
