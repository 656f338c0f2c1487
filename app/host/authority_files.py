"""The files that a device installs to trust the clinic's root: a profile for iPads, the certificate for others."""

import plistlib
import ssl
import uuid
from hashlib import sha256

from app.texts import Text

IDENTIFIER = "bodydrive.authority"


def apple_profile(root: bytes, machine: Text | str) -> bytes:
    """Return the profile of a root (DER); the same root gives the same UUIDs, so that a second one replaces the first.

    The profile is not signed: no certificate that the device trusts already could sign it. A bare certificate would do,
    but newer versions of Safari save it under a name that the settings do not open.

    Source: Apple, Device Management, CertificateRoot (com.apple.security.root).
    """
    digest = sha256(root).digest()
    identifier = f"{IDENTIFIER}.{digest[:8].hex()}"
    title, explanation = str(Text("host-profile-title", machine=machine)), str(Text("host-profile-explanation"))
    certificate = {
        "PayloadType": "com.apple.security.root",
        "PayloadVersion": 1,
        "PayloadIdentifier": f"{identifier}.root",
        "PayloadUUID": _uuid(digest[:16]),
        "PayloadDisplayName": title,
        "PayloadDescription": explanation,
        "PayloadCertificateFileName": "bodydrive.cer",
        "PayloadContent": root,
    }
    profile = {
        "PayloadType": "Configuration",
        "PayloadVersion": 1,
        "PayloadIdentifier": identifier,
        "PayloadUUID": _uuid(digest[16:]),
        "PayloadDisplayName": title,
        "PayloadDescription": explanation,
        "PayloadOrganization": "bodydrive",
        "PayloadRemovalDisallowed": False,
        "PayloadContent": [certificate],
    }
    return plistlib.dumps(profile)


def root_pem(root: bytes) -> bytes:
    """Return a root (DER) as PEM, which Android, Windows, macOS and Linux read."""
    return ssl.DER_cert_to_PEM_cert(root).encode()


def _uuid(half: bytes) -> str:
    """Return half a SHA-256 as a UUID of version 8, which is for application-specific values (RFC 9562)."""
    marked = bytearray(half)
    marked[6] = marked[6] & 0x0F | 0x80
    marked[8] = marked[8] & 0x3F | 0x80
    return str(uuid.UUID(bytes=bytes(marked))).upper()
