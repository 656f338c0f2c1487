"""The folder of a clinic: locked while one program serves it, and readable by its owner alone."""

import fcntl
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from app.cli.errors import InputError
from app.file_modes import OWNER_FOLDER, keep_new_files_private, restrict
from app.settings import IN_USE, Settings


def keep_private(settings: Settings) -> list[str]:
    """Let only their owner read what is written from now on, and what is in the clinic's folder already.

    Return a sentence when others can read something still.
    """
    keep_new_files_private()
    readable = restrict(settings.state_paths)
    if not readable:
        return []
    return [
        f"Other people on this computer can read {len(readable)} files of the clinic, the first is {readable[0]}: "
        f"give them to this account, or move the clinic to a disk that keeps rights."
    ]


@contextmanager
def held(folder: Path) -> Iterator[None]:
    """Lock a clinic's folder, so that no second program writes to its database."""
    try:
        folder.mkdir(mode=OWNER_FOLDER, parents=True, exist_ok=True)
        file = (folder / IN_USE).open("w")
    except OSError as error:
        raise InputError(f"{folder} cannot be written: choose another folder with --state.") from error
    with file:
        try:
            fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except OSError as error:
            raise InputError(
                f"The clinic in {folder} is open already: end the other program, or choose another with --state."
            ) from error
        yield
