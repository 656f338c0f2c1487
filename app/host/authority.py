"""The clinic's own certificate authority: what it makes (how long it holds: certificate_times.py).

A root, which people install on their tablets, signs an intermediate, and this signs the machine's certificate. The
root carries name constraints (RFC 5280, 4.2.1.10): with its key, certificates can be made for this machine and for
addresses of private networks, and for no site of the internet.
"""

import datetime as dt
import ipaddress
from dataclasses import dataclass

from cryptography import x509
from cryptography.exceptions import InvalidSignature
from cryptography.hazmat.primitives import hashes, serialization
from cryptography.hazmat.primitives.asymmetric import ec
from cryptography.x509.oid import ExtendedKeyUsageOID, NameOID

from app.host.certificate_times import BACKDATED, INTERMEDIATE_LIFE, LEAF_LIFE, ROOT_LIFE
from app.host.machine import Machine, Network
from app.texts import Text

LONGEST_TITLE = 64  # bytes of a common name (RFC 5280, appendix A)

# Private, link-local and loopback networks, and the names that no public name server answers (RFC 6762, 6761).
PRIVATE_NETWORKS = tuple(
    ipaddress.ip_network(network)
    for network in (
        *("10.0.0.0/8", "172.16.0.0/12", "192.168.0.0/16", "169.254.0.0/16", "127.0.0.0/8"),
        *("fc00::/7", "::1/128"),
    )
)
PRIVATE_NAMES = ("local", "localhost")


@dataclass(frozen=True, slots=True)
class Identity:
    """A certificate and its private key."""

    certificate: x509.Certificate
    key: ec.EllipticCurvePrivateKey

    @property
    def certificate_pem(self) -> bytes:
        """Return the certificate as text."""
        return self.certificate.public_bytes(serialization.Encoding.PEM)

    @property
    def key_pem(self) -> bytes:
        """Return the key as text, not encrypted: the program reads it without a person."""
        return self.key.private_bytes(
            serialization.Encoding.PEM, serialization.PrivateFormat.PKCS8, serialization.NoEncryption()
        )


def read_identity(certificate: bytes, key: bytes) -> Identity:
    """Return the identity of two PEM texts; ValueError when they are damaged or do not belong together."""
    read = x509.load_pem_x509_certificate(certificate)
    private = serialization.load_pem_private_key(key, password=None)
    if not isinstance(private, ec.EllipticCurvePrivateKey) or private.public_key() != read.public_key():
        raise ValueError("the key is of another certificate")
    return Identity(read, private)


def make_root(machine: Machine, now: dt.datetime) -> Identity:
    """Return a new root for this machine's names and networks."""
    key = ec.generate_private_key(ec.SECP256R1())
    title = str(Text("host-authority-title", machine=machine.name or Text("host-nameless-machine"), day=now.date()))
    common = title if len(title.encode()) <= LONGEST_TITLE else f"bodydrive, {now:%Y-%m-%d}"
    name = x509.Name(
        [
            x509.NameAttribute(NameOID.ORGANIZATION_NAME, "bodydrive"),
            x509.NameAttribute(NameOID.COMMON_NAME, common),
        ]
    )
    # A network that a private one contains, such as 192.168.1.0/24, needs no entry of its own.
    foreign = [net for net in machine.networks if not any(_contains(private, net) for private in PRIVATE_NETWORKS)]
    names = [name for name in machine.names if not name.endswith(".local")]
    permitted: list[x509.GeneralName] = [x509.DNSName(each) for each in dict.fromkeys([*PRIVATE_NAMES, *names])]
    permitted += [x509.IPAddress(network) for network in (*PRIVATE_NETWORKS, *foreign)]
    constraints = x509.NameConstraints(permitted_subtrees=permitted, excluded_subtrees=None)
    builder = _builder(name, name, key, now, ROOT_LIFE).add_extension(constraints, critical=True)
    return Identity(_authority(builder, key, path_length=1), key)


def make_intermediate(root: Identity, now: dt.datetime) -> Identity:
    """Return a new intermediate, which signs the certificates of the machine."""
    key = ec.generate_private_key(ec.SECP256R1())
    name = x509.Name(
        [
            x509.NameAttribute(NameOID.ORGANIZATION_NAME, "bodydrive"),
            x509.NameAttribute(NameOID.COMMON_NAME, f"bodydrive intermediate {now:%Y-%m-%d}"),
        ]
    )
    builder = _builder(name, root.certificate.subject, key, now, INTERMEDIATE_LIFE, root.certificate)
    usage = x509.ExtendedKeyUsage([ExtendedKeyUsageOID.SERVER_AUTH])
    certificate = _authority(builder.add_extension(usage, critical=False), root.key, path_length=0)
    return Identity(certificate, key)


def make_leaf(
    intermediate: Identity, subjects: list[x509.GeneralName], now: dt.datetime, life: dt.timedelta = LEAF_LIFE
) -> Identity:
    """Return a new certificate of the machine."""
    key = ec.generate_private_key(ec.SECP256R1())
    name = x509.Name([x509.NameAttribute(NameOID.COMMON_NAME, "bodydrive")])
    builder = _builder(name, intermediate.certificate.subject, key, now, life, intermediate.certificate)
    builder = (
        builder.add_extension(x509.SubjectAlternativeName(subjects), critical=False)
        .add_extension(x509.BasicConstraints(ca=False, path_length=None), critical=True)
        .add_extension(_key_usage(signs_certificates=False), critical=True)
        .add_extension(x509.ExtendedKeyUsage([ExtendedKeyUsageOID.SERVER_AUTH]), critical=False)
    )
    return Identity(builder.sign(intermediate.key, hashes.SHA256()), key)


def subjects_of(machine: Machine, root: x509.Certificate) -> list[x509.GeneralName]:
    """Return the machine's names and addresses for which the root may vouch, in a fixed order."""
    permitted = root.extensions.get_extension_for_class(x509.NameConstraints).value.permitted_subtrees or []
    names = [each.value for each in permitted if isinstance(each, x509.DNSName)]
    networks = [ipaddress.ip_network(str(each.value)) for each in permitted if isinstance(each, x509.IPAddress)]
    return [
        *(x509.DNSName(name) for name in machine.names if any(f".{name}".endswith(f".{each}") for each in names)),
        *(
            x509.IPAddress(address)
            for address in sorted(machine.addresses, key=lambda each: (each.version, int(each)))
            if any(address.version == network.version and address in network for network in networks)
        ),
    ]


def certified(certificate: x509.Certificate) -> set[x509.GeneralName]:
    """Return the names and addresses of a certificate."""
    try:
        return set(certificate.extensions.get_extension_for_class(x509.SubjectAlternativeName).value)
    except x509.ExtensionNotFound:
        return set()


def signed_by(certificate: x509.Certificate, issuer: x509.Certificate) -> bool:
    """Return whether a certificate was signed by this issuer."""
    try:
        certificate.verify_directly_issued_by(issuer)
    except (ValueError, TypeError, InvalidSignature):
        return False
    return True


def _builder(
    subject: x509.Name,
    issuer: x509.Name,
    key: ec.EllipticCurvePrivateKey,
    now: dt.datetime,
    life: dt.timedelta,
    above: x509.Certificate | None = None,
) -> x509.CertificateBuilder:
    """Return the common part of the three certificates: names, serial number, validity, and key identifiers."""
    start = now - BACKDATED
    end = start + life
    if above is not None:  # a chain ends when its first certificate does
        start, end = max(start, above.not_valid_before_utc), min(end, above.not_valid_after_utc)
    issuing = key.public_key() if above is None else above.public_key()
    assert isinstance(issuing, ec.EllipticCurvePublicKey)
    return (
        x509.CertificateBuilder()
        .subject_name(subject)
        .issuer_name(issuer)
        .public_key(key.public_key())
        .serial_number(x509.random_serial_number())
        .not_valid_before(start)
        .not_valid_after(end)
        .add_extension(x509.SubjectKeyIdentifier.from_public_key(key.public_key()), critical=False)
        .add_extension(x509.AuthorityKeyIdentifier.from_issuer_public_key(issuing), critical=False)
    )


def _authority(
    builder: x509.CertificateBuilder, signing: ec.EllipticCurvePrivateKey, path_length: int
) -> x509.Certificate:
    """Return the certificate of an authority that may sign `path_length` further authorities below it."""
    builder = builder.add_extension(x509.BasicConstraints(ca=True, path_length=path_length), critical=True)
    return builder.add_extension(_key_usage(signs_certificates=True), critical=True).sign(signing, hashes.SHA256())


def _key_usage(*, signs_certificates: bool) -> x509.KeyUsage:
    return x509.KeyUsage(
        digital_signature=not signs_certificates,
        key_cert_sign=signs_certificates,
        crl_sign=signs_certificates,
        content_commitment=False,
        key_encipherment=False,
        data_encipherment=False,
        key_agreement=False,
        encipher_only=False,
        decipher_only=False,
    )


def _contains(outer: Network, inner: Network) -> bool:
    return outer.version == inner.version and inner.network_address in outer and inner.broadcast_address in outer
