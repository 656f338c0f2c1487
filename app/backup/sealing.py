"""Encrypt a stream with a passphrase: scrypt makes the key, AES-256-GCM seals chunks of 1 MiB.

A sealed stream is `BDSEAL01`, the salt of the passphrase (16 bytes), the salt of this stream (32 bytes), and chunks.
Each stream has a key of its own (HKDF-SHA256 of the passphrase's key and the stream's salt). The nonce of a chunk holds
its number and whether it is the last one, so that chunks can be neither exchanged nor cut off unnoticed (the STREAM
construction: Hoang, Reyhanitabar, Rogaway, Vizar 2015).
"""

import os
from dataclasses import dataclass, field
from typing import Final

from app.backup.quiet_files import Reader, Writer
from app.refusals import Refusal

MAGIC: Final = b"BDSEAL01"
SALT, STREAM_SALT, TAG = 16, 32, 16  # bytes
CHUNK: Final = 1 << 20  # bytes
COST: Final = {"n": 1 << 17, "r": 8, "p": 1}  # scrypt: 128 MB of memory, about half a second
WRONG: Final = "The passphrase is wrong, or the file was changed: give the passphrase with which it was made."


class WrongPassphrase(Refusal):
    """What was sealed cannot be opened with this key."""


@dataclass(frozen=True, slots=True)
class Secret:
    """The key that a passphrase makes with a salt."""

    salt: bytes
    key: bytes = field(repr=False)


def secret_of(passphrase: str, salt: bytes | None = None) -> Secret:
    """Return the secret of a passphrase; with a new salt when none is given."""
    from cryptography.hazmat.primitives.kdf.scrypt import Scrypt

    chosen = os.urandom(SALT) if salt is None else salt
    return Secret(chosen, Scrypt(salt=chosen, length=32, **COST).derive(passphrase.encode()))


def salt_of(head: bytes) -> bytes | None:
    """Return the passphrase's salt of a sealed stream that begins with `head`, None when it is not sealed."""
    return head[len(MAGIC) : len(MAGIC) + SALT] if head.startswith(MAGIC) else None


class SealingWriter:
    """Seals what is written to it, and writes it on; `end` writes the last chunk."""

    def __init__(self, out: Writer, secret: Secret) -> None:
        salt = os.urandom(STREAM_SALT)
        self._out, self._chunks, self._waiting = out, _Chunks(secret, salt), bytearray()
        out.write(MAGIC + secret.salt + salt)

    def write(self, part: bytes, /) -> int:
        """Seal bytes."""
        self._waiting += part
        while len(self._waiting) > CHUNK:  # the last chunk may be a full one
            self._out.write(self._chunks.seal(bytes(self._waiting[:CHUNK]), is_last=False))
            del self._waiting[:CHUNK]
        return len(part)

    def end(self) -> None:
        """Write the last chunk."""
        self._out.write(self._chunks.seal(bytes(self._waiting), is_last=True))


class OpeningReader:
    """Reads what a SealingWriter has sealed; raises WrongPassphrase at the first byte that is not right."""

    def __init__(self, sealed: Reader, secret: Secret) -> None:
        head = _exactly(sealed, len(MAGIC) + SALT + STREAM_SALT)
        if salt_of(head) is None or len(head) < len(MAGIC) + SALT + STREAM_SALT:
            raise WrongPassphrase(WRONG)
        self._sealed, self._chunks = sealed, _Chunks(secret, head[len(MAGIC) + SALT :])
        self._ahead = _exactly(sealed, CHUNK + TAG)
        self._ready = bytearray()
        self._is_over = False

    def read(self, size: int, /) -> bytes:
        """Return the next bytes."""
        while len(self._ready) < size and not self._is_over:
            chunk, self._ahead = self._ahead, _exactly(self._sealed, CHUNK + TAG)
            self._is_over = not self._ahead
            self._ready += self._chunks.open(chunk, is_last=self._is_over)
        part = bytes(self._ready[:size])
        del self._ready[:size]
        return part


class _Chunks:
    """The key of one stream, and the number of its next chunk."""

    def __init__(self, secret: Secret, salt: bytes) -> None:
        from cryptography.hazmat.primitives.ciphers.aead import AESGCM
        from cryptography.hazmat.primitives.hashes import SHA256
        from cryptography.hazmat.primitives.kdf.hkdf import HKDF

        self._cipher = AESGCM(HKDF(SHA256(), length=32, salt=salt, info=MAGIC).derive(secret.key))
        self._number = 0

    def seal(self, chunk: bytes, *, is_last: bool) -> bytes:
        return self._cipher.encrypt(self._nonce(is_last), chunk, None)

    def open(self, sealed: bytes, *, is_last: bool) -> bytes:
        from cryptography.exceptions import InvalidTag

        try:
            return self._cipher.decrypt(self._nonce(is_last), sealed, None)
        except (InvalidTag, ValueError) as error:
            raise WrongPassphrase(WRONG) from error

    def _nonce(self, is_last: bool) -> bytes:
        number, self._number = self._number, self._number + 1
        return number.to_bytes(11, "big") + bytes([is_last])


def _exactly(reader: Reader, size: int) -> bytes:
    """Return `size` bytes, fewer only at the end."""
    found = bytearray()
    while len(found) < size and (part := reader.read(size - len(found))):
        found += part
    return bytes(found)
