"""The secret key that a chair or a shirt shares with this machine. Standard library only, for small boards."""

import os
import re
import secrets
import stat
from pathlib import Path
from typing import NamedTuple

SECRET_BYTES = 32
LARGEST_ID = 65_535
_LINE = re.compile(r"(\d{1,5}) ([0-9a-fA-F]{64})")


class KeyRefused(Exception):  # noqa: N818
    """Why a key file is refused, in one sentence that never contains the key."""


class Key(NamedTuple):
    """A key's number and its secret."""

    id: int  # u16
    secret: bytes  # 32 bytes

    @property
    def line(self) -> str:
        """The one line of a key file, which is also the content of the QR code of a pairing."""
        return f"{self.id} {self.secret.hex()}"

    def __repr__(self) -> str:
        """Name the key without its secret, because this text may be logged."""
        return f"Key({self.id}, ...)"


def new_key(key_id: int) -> Key:
    """Return a fresh random key of this number."""
    return Key(key_id, secrets.token_bytes(SECRET_BYTES))


def read_key(file: Path) -> Key:
    """Return the key in `file`; raise KeyRefused when others can read the file or it holds no key."""
    try:
        with open(os.open(file, os.O_RDONLY | os.O_NONBLOCK), encoding="ascii") as opened:  # does not wait for a pipe
            mode = os.fstat(opened.fileno()).st_mode
            text = opened.read(200) if stat.S_ISREG(mode) else ""
    except (OSError, ValueError) as error:
        why = error.strerror if isinstance(error, OSError) else "it is no text"
        raise KeyRefused(f"the key file {file} cannot be read ({why}): give the file that pairing made") from error
    if stat.S_IMODE(mode) & (stat.S_IRWXG | stat.S_IRWXO):
        raise KeyRefused(f"the key file {file} can be read by others: say `chmod 600 {file}`, or pair anew")
    match = _LINE.fullmatch(text.strip())
    if match is None or int(match[1]) > LARGEST_ID:
        raise KeyRefused(
            f"the key file {file} holds no key: it must be one line, a number up to {LARGEST_ID}, a space, "
            f"{2 * SECRET_BYTES} hex digits"
        )
    return Key(int(match[1]), bytes.fromhex(match[2]))


def lost_key(file: Path, key: Key) -> str:
    """Return in words why `key`, which was read from `file` earlier, counts no longer; empty while it does."""
    try:
        return "" if read_key(file) == key else f"the key file {file} holds another key than it did: choose it again"
    except KeyRefused as error:
        return str(error)


def write_key(file: Path, key: Key) -> None:
    """Write a new key file that only its owner can read; raise FileExistsError when there is one."""
    handle = os.open(file, os.O_WRONLY | os.O_CREAT | os.O_EXCL, 0o600)
    try:
        os.fchmod(handle, 0o600)
        with os.fdopen(handle, "w") as opened:
            opened.write(f"{key.line}\n")
            opened.flush()
            os.fsync(opened.fileno())
    except BaseException:
        file.unlink(missing_ok=True)
        raise
