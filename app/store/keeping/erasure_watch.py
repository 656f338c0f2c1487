"""While the program runs, erase what has waited for 30 days: deleted patients and replaced files."""

import asyncio
import logging
from typing import Final

from app.settings import Settings
from app.store.database import Database
from app.store.files.replacements import replaced_files
from app.store.keeping.erasure import erase_due
from app.store.keeping.passed_time import passed_now, store_clocks

ERASE_EVERY: Final = 3600.0  # s

logger = logging.getLogger("bodydrive")


class ErasureWatch:
    """Looks at the clocks at the start and then every hour, and erases what is due."""

    def __init__(self, database: Database, settings: Settings) -> None:
        self._database = database
        self._settings = settings
        self._replaced = replaced_files(settings)
        self._watching: asyncio.Task[None] | None = None

    def start(self) -> None:
        """Begin to look."""
        self._watching = asyncio.create_task(self._watch())

    async def close(self) -> None:
        """Stop looking."""
        if self._watching is not None:
            self._watching.cancel()
            await asyncio.gather(self._watching, return_exceptions=True)

    async def _watch(self) -> None:
        while True:
            try:
                await asyncio.to_thread(self._erase)
            except Exception:  # keep looking: a disk that is gone may come back
                logger.exception("Nobody could be erased who was deleted 30 days ago")
            await asyncio.sleep(ERASE_EVERY)

    def _erase(self) -> None:
        with self._database.transaction(closing=True) as db:
            store_clocks(db)
            passed = passed_now(db)
        self._replaced.purge(passed)
        erase_due(self._database, self._settings)
