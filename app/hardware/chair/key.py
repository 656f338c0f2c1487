"""The secret key that a chair or a shirt shares with this machine. Standard library only, for small boards."""

import os
import re
import secrets
import stat
from pathlib import Path
from typing import Literal, NamedTuple

SECRET_BYTES = 32
LARGEST_ID = 65_535
_LINE = re.compile(r"(\d{1,5}) ([0-9a-fA-F]{64})")


Problem = Literal["unreadable", "no-text", "not-private", "no-key"]
# For programs without a catalogue, on small boards; the pages have the messages device-key-PROBLEM.
SENTENCES: dict[Problem, str] = {
    "unreadable": "the key file {file} cannot be read ({why}): give the file that pairing made",
    "no-text": "the key file {file} cannot be read (it is no text): give the file that pairing made",
    "not-private": "the key file {file} can be read by others: run `chmod 600 {file}`, or pair anew",
    "no-key": ("the key file {file} holds no key: it must be one line, a number up to 65535, a space, 64 hex digits"),
}


class KeyRefused(Exception):  # noqa: N818
    """Why a key file is refused; its message is one English sentence, which never contains the key.

    Attributes
    ----------
    problem : str
        One of SENTENCES.
    file : str
    why : str
        The system's reason why the file is unreadable.
    """

    def __init__(self, problem: Problem, file: Path, why: str = "") -> None:
        super().__init__(SENTENCES[problem].format(file=file, why=why))
        self.problem, self.file, self.why = problem, str(file), why


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
    except OSError as error:
        raise KeyRefused("unreadable", file, error.strerror or "") from error
    except ValueError as error:
        raise KeyRefused("no-text", file) from error
    if stat.S_IMODE(mode) & (stat.S_IRWXG | stat.S_IRWXO):
        raise KeyRefused("not-private", file)
    match = _LINE.fullmatch(text.strip())
    if match is None or int(match[1]) > LARGEST_ID:
        raise KeyRefused("no-key", file)
    return Key(int(match[1]), bytes.fromhex(match[2]))


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
