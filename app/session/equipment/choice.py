"""A choice of people that is stored with the clinic and loaded into the control process."""

import asyncio
from collections.abc import Callable
from pathlib import Path

from app.news import Notify
from app.session.control_link import ControlLink
from app.store.database import Database, Transaction
from app.store.people import the_clinic
from app.store.tables import Clinic
from app.texts import Text


class ClinicChoice:
    """What every such choice needs: the clinic's row, the control link, and a way to tell the pages."""

    def __init__(self, database: Database, control: ControlLink, notify: Notify) -> None:
        self._database = database
        self._control = control
        self._notify = notify

    async def _in_clinic(self, act: Callable[[Transaction, Clinic], None]) -> None:
        """Read or write the clinic's row in a transaction, in a thread; do nothing before the set-up."""

        def _transact() -> None:
            with self._database.transaction() as db:
                clinic = the_clinic(db)
                if clinic is not None:
                    act(db, clinic)

        await asyncio.to_thread(_transact)


def without_folders(sentence: Text | str, *folders: Path) -> Text | str:
    """Return a sentence in which files are named without their folders, as on the pages."""
    if isinstance(sentence, Text):
        names = {
            name: without_folders(value, *folders) if isinstance(value, Text | str) else value
            for name, value in sentence.values.items()
        }
        return Text(sentence.id, **names)
    for folder in folders:
        sentence = sentence.replace(f"{folder}/", "")
    return sentence
