"""The folder of a clinic: locked while one program serves it, and readable by its owner alone."""

import fcntl
from collections.abc import Callable, Iterator
from contextlib import ExitStack, contextmanager
from pathlib import Path
from typing import TYPE_CHECKING

from app.cli.errors import InputError
from app.file_modes import OWNER_FOLDER, keep_new_files_private, restrict
from app.settings import IN_USE, Settings
from app.texts import Text, text_of

if TYPE_CHECKING:
    from app.store.database import Database

ADDRESS_LIMIT = 300  # characters


def keep_private(settings: Settings) -> list[Text]:
    """Let only their owner read what is written from now on, and what is in the clinic's folder already.

    Return a sentence when others can read something still.
    """
    keep_new_files_private()
    readable = restrict(settings.state_paths)
    if not readable:
        return []
    return [Text("cli-others-can-read", count=len(readable), file=str(readable[0]))]


class FolderInUseError(InputError):
    """Another program serves the clinic; `address` is that of its pages, empty when it is not known."""

    def __init__(self, sentence: Text, address: str) -> None:
        super().__init__(sentence)
        self.address = address


@contextmanager
def lock_folder(folder: Path) -> Iterator[Callable[[str], None]]:
    """Lock a clinic's folder, so that no second program serves it.

    Yield a function that writes the address of the pages into the locked file, for commands that are given meanwhile.

    Raises
    ------
    FolderInUseError
        When another program holds the folder.
    InputError
        When the folder cannot be written.
    """
    try:
        folder.mkdir(mode=OWNER_FOLDER, parents=True, exist_ok=True)
        file = (folder / IN_USE).open("a+")
    except OSError as error:
        raise InputError(Text("cli-folder-unwritable", folder=str(folder))) from error
    with file:
        try:
            fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except OSError as error:
            file.seek(0)
            sentence = Text("cli-folder-in-use", folder=str(folder))
            raise FolderInUseError(sentence, file.read(ADDRESS_LIMIT)) from error

        def write_address(address: str) -> None:
            file.truncate(0)
            file.write(address)
            file.flush()

        write_address("")
        yield write_address


@contextmanager
def open_clinic(settings: Settings) -> Iterator[tuple["Database", str]]:
    """Open the database of a clinic that is there, also while another program serves it.

    Yield it with the address of the running program's pages, empty when none runs.
    """
    from app.refusals import Refusal
    from app.store.database import Database
    from app.store.schema import NEWEST, revision_of

    if not settings.database.is_file():
        raise InputError(Text("cli-no-clinic", folder=str(settings.state)))
    keep_new_files_private()
    with ExitStack() as stack:
        address = ""
        try:
            stack.enter_context(lock_folder(settings.state))
        except FolderInUseError as running:
            address = running.address
            if revision_of(settings.database) != NEWEST:
                raise InputError(Text("cli-other-version")) from running
        try:
            database = Database(settings.database)
            stack.callback(database.close)
            yield database, address
        except Refusal as refusal:
            raise InputError(text_of(refusal)) from refusal
