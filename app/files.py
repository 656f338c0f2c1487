"""Files that are either whole or not there."""

import os
import tempfile
from errno import EEXIST, EISDIR
from pathlib import Path


def write_atomically(path: Path, content: bytes) -> None:
    """Write `content` to `path` so that a reader, or a power cut, meets the old file or the new one, never half of it.

    Missing folders are made; a link is followed.

    Raises
    ------
    OSError
        When the place cannot be written; nothing is left behind then.
    """
    path = path.resolve()
    if path.exists() and not path.is_file():  # what is renamed onto a device or a pipe takes its place
        raise OSError(EISDIR if path.is_dir() else EEXIST, "Is a directory" if path.is_dir() else "Is no ordinary file")
    path.parent.mkdir(parents=True, exist_ok=True)
    descriptor, name = tempfile.mkstemp(dir=path.parent, prefix=f".{path.name}.", suffix=".part")
    part = Path(name)
    try:
        with os.fdopen(descriptor, "wb") as file:
            file.write(content)
            file.flush()
            os.fsync(file.fileno())
        part.chmod(0o666 & ~_file_mode_mask())
        part.replace(path)
    except BaseException:
        part.unlink(missing_ok=True)
        raise
    sync_folder(path.parent)


def _file_mode_mask() -> int:
    """Return the process's umask, which can only be read by setting it."""
    mask = os.umask(0o077)
    os.umask(mask)
    return mask


def sync_folder(folder: Path) -> None:
    """Put the folder's new entry on the disk too."""
    descriptor = os.open(folder, os.O_RDONLY)
    try:
        os.fsync(descriptor)
    finally:
        os.close(descriptor)
