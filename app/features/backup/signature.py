"""The key with which the clinic signs its archives (Ed25519): made on first use, the public half shown to the owner."""

from hashlib import sha256
from pathlib import Path
from typing import Final

from app.file_modes import OWNER_FILE, OWNER_FOLDER
from app.files import write_atomically

KEY: Final = "clinic-ed25519.pem"
PUBLIC: Final = "clinic-ed25519-public.pem"


def sign(folder: Path, content: bytes) -> tuple[bytes, bytes]:
    """Sign with the clinic's key, which is made when there is none; return the signature and the public key (PEM)."""
    from cryptography.hazmat.primitives import serialization
    from cryptography.hazmat.primitives.asymmetric.ed25519 import Ed25519PrivateKey

    file = folder / KEY
    if not file.exists():
        folder.mkdir(mode=OWNER_FOLDER, parents=True, exist_ok=True)
        private_key = Ed25519PrivateKey.generate().private_bytes(
            serialization.Encoding.PEM, serialization.PrivateFormat.PKCS8, serialization.NoEncryption()
        )
        write_atomically(file, private_key, OWNER_FILE)
    key = serialization.load_pem_private_key(file.read_bytes(), password=None)
    assert isinstance(key, Ed25519PrivateKey)
    public = key.public_key().public_bytes(serialization.Encoding.PEM, serialization.PublicFormat.SubjectPublicKeyInfo)
    if not (folder / PUBLIC).exists():
        write_atomically(folder / PUBLIC, public, OWNER_FILE)
    return key.sign(content), public


def is_signed(content: bytes, signature: bytes, public: bytes) -> bool:
    """Return whether a signature of `content` was made with the private half of a public key (PEM)."""
    from cryptography.exceptions import InvalidSignature
    from cryptography.hazmat.primitives.asymmetric.ed25519 import Ed25519PublicKey
    from cryptography.hazmat.primitives.serialization import load_pem_public_key

    try:
        key = load_pem_public_key(public)
        if not isinstance(key, Ed25519PublicKey):
            return False
        key.verify(signature, content)
    except (InvalidSignature, ValueError):
        return False
    return True


def fingerprint(public: bytes) -> str:
    """Return what people compare of a public key (PEM): the SHA-256 of its text, in groups of four digits."""
    digits = sha256(public.strip().replace(b"\r\n", b"\n")).hexdigest()
    return " ".join(digits[at : at + 4] for at in range(0, 64, 4))


def clinic_fingerprint(folder: Path) -> str:
    """Return the fingerprint of the clinic's public key, empty before the first use."""
    file = folder / PUBLIC
    return fingerprint(file.read_bytes()) if file.exists() else ""
