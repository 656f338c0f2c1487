"""Encrypt a stream for a key pair of age, and decrypt it; the private key is encrypted with the passphrase.

The format is that of age (age-encryption.org/v1), so that the command `age` opens what was written here: X25519 for the
key of each stream, ChaCha20-Poly1305 for its chunks, and scrypt for the passphrase. No chunk can be changed, moved or
cut off unnoticed.

pyrage reads and writes files by itself; a thread and a pipe connect it to who writes or reads one part after the other.
"""

import os
import threading
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field
from typing import BinaryIO, Final, TypeVar

from app.features.backup.manifest import DAMAGED
from app.features.backup.quiet_files import PART, Reader, Writer
from app.refusals import Refusal
from app.texts import Text

SHORTEST_PASSPHRASE: Final = 8  # characters, of a new one
TOO_MUCH_WORK: Final = "Excessive work"  # pyrage measures this computer's speed at each call
ATTEMPTS: Final = 5  # of a computer that is busy for a moment
WRONG: Final = Text("backups-wrong-passphrase")

Result = TypeVar("Result")


@dataclass(frozen=True, slots=True)
class Secret:
    """A private key of age, and this key encrypted with the passphrase, which lies in each backup."""

    identity: str = field(repr=False)  # AGE-SECRET-KEY-...
    sealed: str  # an age file in ASCII armour, as `age --identity` takes it


def new_secret(passphrase: str) -> Secret:
    """Return a new key, encrypted with a passphrase; takes about a second."""
    from pyrage import passphrase as by_passphrase
    from pyrage import x25519

    identity = str(x25519.Identity.generate())
    return Secret(identity, by_passphrase.encrypt(f"{identity}\n".encode(), passphrase, armored=True).decode())


def opened_secret(sealed: str, passphrase: str) -> Secret:
    """Return the key that was encrypted with a passphrase, in about a second.

    Raises
    ------
    Refusal
        When the passphrase is wrong, or this computer would need much longer for it than the one that made the backup.
    """
    from pyrage import DecryptError, x25519
    from pyrage import passphrase as by_passphrase

    for _ in range(ATTEMPTS):
        try:
            identity = by_passphrase.decrypt(sealed.encode(), passphrase).decode().strip()
            return Secret(str(x25519.Identity.from_str(identity)), sealed)
        except (DecryptError, ValueError) as error:
            if TOO_MUCH_WORK not in str(error):
                raise Refusal(WRONG) from error
    raise Refusal(Text("backups-passphrase-slow"))


@contextmanager
def encrypted(out: Writer, secret: Secret) -> Iterator[Writer]:
    """Yield a writer that encrypts; all of it is written to `out` when the block has ended."""
    from pyrage import encrypt_io, x25519

    public = x25519.Identity.from_str(secret.identity).to_public()
    source, sink = _pipe()
    stream = _Stream(out)

    def encrypt() -> None:
        with source:
            encrypt_io(source, stream, [public])

    thread = _Thread(encrypt)
    try:
        with sink:
            yield sink
    except BrokenPipeError:
        pass  # encrypting failed, for the reason that follows
    finally:
        error = thread.end()
    if stream.error is not None:  # pyrage says nothing when the last bytes cannot be written
        raise stream.error
    if error is not None:
        raise error


@contextmanager
def decrypted(sealed: Reader, secret: Secret) -> Iterator[Reader]:
    """Yield a reader of what was encrypted for the key; read to the end, it proves that nothing was cut off.

    Raises
    ------
    Refusal
        In one sentence, while it is read: when it is for another key, or was changed or cut off.
    """
    from pyrage import decrypt_io, x25519

    identity = x25519.Identity.from_str(secret.identity)
    source, sink = _pipe()
    stream = _Stream(sealed)

    def decrypt() -> None:
        with sink:
            decrypt_io(stream, sink, [identity])

    thread = _Thread(decrypt)
    try:
        with source:
            yield _Decrypted(source, stream, thread)
    finally:
        thread.end()


class _Decrypted:
    """What the thread decrypts; at its end, the thread's error is raised."""

    def __init__(self, source: BinaryIO, stream: "_Stream", thread: "_Thread") -> None:
        self._source, self._stream, self._thread = source, stream, thread

    def read(self, size: int, /) -> bytes:
        """Return the next bytes."""
        part = self._source.read(size)
        if not part and (error := self._thread.end()) is not None:
            if self._stream.error is not None:
                raise self._stream.error
            raise Refusal(WRONG if "No matching keys" in str(error) else DAMAGED) from error
        return part


class _Stream:
    """A reader or writer for pyrage, which turns every exception into its own: the first one stays here."""

    def __init__(self, stream: Reader | Writer) -> None:
        self._stream = stream
        self.error: Exception | None = None

    def read(self, size: int, /) -> bytes:
        return self._kept(lambda: self._stream.read(size))  # type: ignore[union-attr]

    def write(self, part: bytes, /) -> int:
        return self._kept(lambda: self._stream.write(part))  # type: ignore[union-attr]

    def flush(self) -> None:
        """Do nothing: what is written is not held back."""

    def _kept(self, do: Callable[[], Result]) -> Result:
        try:
            return do()
        except Exception as error:
            self.error = error
            raise


class _Thread:
    """A function that runs beside this thread, and the exception that ended it."""

    def __init__(self, run: Callable[[], None]) -> None:
        self._run = run
        self._error: Exception | None = None
        self._thread = threading.Thread(target=self._work, daemon=True)
        self._thread.start()

    def end(self) -> Exception | None:
        """Wait for the end."""
        self._thread.join()
        return self._error

    def _work(self) -> None:
        try:
            self._run()
        except Exception as error:
            self._error = error


def _pipe() -> tuple[BinaryIO, BinaryIO]:
    source, sink = os.pipe()
    return os.fdopen(source, "rb"), os.fdopen(sink, "wb", buffering=PART)
