"""Makes files readable by their owner only: new files, and those of an older installation."""

import os
import stat
from collections.abc import Iterable, Iterator
from pathlib import Path

OWNER_FILE = 0o600
OWNER_FOLDER = 0o700
NOT_OWNER = stat.S_IRWXG | stat.S_IRWXO


def keep_new_files_private() -> None:
    """Set the umask of this process and of those it starts, so that only the owner can read new files and folders."""
    os.umask(NOT_OWNER)


def restrict(paths: Iterable[Path]) -> list[Path]:
    """Remove the rights of group and others from files and from folders with all their content.

    Links among `paths` are followed, links inside a folder are not. A folder that others cannot enter is not searched:
    nobody else reaches its content, and a clinic of some years has 200,000 files in it. A folder is closed after its
    content, so that a search that was interrupted is done again.

    Returns
    -------
    list of Path
        Files and folders that others can still read, because they have another owner or their file system has no modes.
    """
    return sorted({place for path in paths for place in _still_readable(path.resolve())})


def _still_readable(place: Path) -> Iterator[Path]:
    try:
        mode = stat.S_IMODE(place.stat().st_mode)
        if not mode & NOT_OWNER:
            return
        if place.is_dir():
            for inner in place.iterdir():
                if not inner.is_symlink():
                    yield from _still_readable(inner)
        place.chmod(mode & ~NOT_OWNER)
        if place.stat().st_mode & NOT_OWNER:
            yield place
    except FileNotFoundError:
        return  # removed meanwhile
    except OSError:
        yield place
