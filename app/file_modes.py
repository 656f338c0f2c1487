"""Files that only their owner can read: the mode of new ones, and the modes of those of an older installation."""

import os
import stat
from collections.abc import Iterable, Iterator
from pathlib import Path

OWNER_FILE = 0o600
OWNER_FOLDER = 0o700
OTHERS = stat.S_IRWXG | stat.S_IRWXO


def keep_new_files_private() -> None:
    """Let this process, and those it starts, make files and folders that nobody else can read."""
    os.umask(OTHERS)


def restrict(paths: Iterable[Path]) -> list[Path]:
    """Take the rights of others from files and folders, with all that is in them.

    A given path that is a link is followed; links inside of a folder are not.

    Returns
    -------
    list of Path
        What others can still read: it belongs to somebody else, or its disk keeps no modes.
    """
    readable = []
    for place in {place for path in paths for place in _whole(path.resolve())}:
        try:
            if _mode(place) & OTHERS:
                place.chmod(_mode(place) & ~OTHERS)
            if _mode(place) & OTHERS:
                readable.append(place)
        except FileNotFoundError:
            continue  # removed meanwhile
        except OSError:
            readable.append(place)
    return sorted(readable)


def _mode(place: Path) -> int:
    return stat.S_IMODE(place.stat().st_mode)


def _whole(path: Path) -> Iterator[Path]:
    """Yield a path and, of a folder, everything below it that is no link."""
    if not path.exists():
        return
    yield path
    for folder, folders, files in os.walk(path):
        for name in (*folders, *files):
            place = Path(folder, name)
            if not place.is_symlink():
                yield place
