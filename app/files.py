"""Writes files atomically: after a crash, a file holds either its old content or its new one."""

import os
import tempfile
from errno import EEXIST, EISDIR
from pathlib import Path

Stamp = tuple[int, int, int]


def write_atomically(path: Path, content: bytes, mode: int | None = None) -> None:
    """Write `content` to `path`, so that readers find the old file or the new one, also after a power cut.

    Makes missing folders; follows a link. Without `mode`, the umask decides who can read the file.

    Raises
    ------
    OSError
        When the file cannot be written; no temporary file is left.
    """
    path = path.resolve()
    if path.exists() and not path.is_file():  # renaming onto a device or a pipe would replace it
        raise OSError(EISDIR if path.is_dir() else EEXIST, "Is a directory" if path.is_dir() else "Is no ordinary file")
    path.parent.mkdir(parents=True, exist_ok=True)
    descriptor, name = tempfile.mkstemp(dir=path.parent, prefix=f".{path.name}.", suffix=".part")
    part = Path(name)
    try:
        with os.fdopen(descriptor, "wb") as file:
            file.write(content)
            file.flush()
            os.fsync(file.fileno())
        part.chmod(0o666 & ~_file_mode_mask() if mode is None else mode)
        part.replace(path)
    except BaseException:
        part.unlink(missing_ok=True)
        raise
    sync_folder(path.parent)


def stamp(file: Path) -> Stamp:
    """Return a file's number, its size and the time of its last change (ns): another writing changes one of them."""
    status = file.stat()
    return status.st_ino, status.st_size, status.st_mtime_ns


def _file_mode_mask() -> int:
    """Return the process's umask; the system can only return it while setting another."""
    mask = os.umask(0o077)
    os.umask(mask)
    return mask


def sync_folder(folder: Path) -> None:
    """Write the folder's entries to the disk."""
    descriptor = os.open(folder, os.O_RDONLY)
    try:
        os.fsync(descriptor)
    finally:
        os.close(descriptor)
