"""Makes files readable by their owner only: new files, and those of an older installation."""

import os
import stat
from collections.abc import Iterable, Iterator
from pathlib import Path

OWNER_FILE = 0o600
OWNER_FOLDER = 0o700
OTHERS = stat.S_IRWXG | stat.S_IRWXO


def keep_new_files_private() -> None:
    """Set the umask of this process and of those it starts, so that only the owner can read new files and folders."""
    os.umask(OTHERS)


def restrict(paths: Iterable[Path]) -> list[Path]:
    """Remove the rights of group and others from files and from folders with all their content.

    Links among `paths` are followed, links inside a folder are not.

    Returns
    -------
    list of Path
        Files and folders that others can still read, because they have another owner or their file system has no modes.
    """
    readable = []
    for place in {place for path in paths for place in _with_content(path.resolve())}:
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


def _with_content(path: Path) -> Iterator[Path]:
    """Yield a path and, if it is a folder, everything below it except links."""
    if not path.exists():
        return
    yield path
    for folder, folders, files in os.walk(path):
        for name in (*folders, *files):
            place = Path(folder, name)
            if not place.is_symlink():
                yield place
