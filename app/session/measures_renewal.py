"""Measures the trials of an older program again, from their recordings, while nothing is recorded."""

import asyncio
import logging
from contextlib import suppress
from typing import Final

from app.computing_process import ComputingProcess
from app.news import News, Notify
from app.refusals import Unavailable
from app.session.recordings import MEASURES_VERSION, measure_again
from app.session.runs import SessionRuns
from app.store.database import Database
from app.store.log import write_log
from app.store.runs import renew_measures, trials_of_older_measures

CHECK_EVERY: Final = 1.0  # s between two checks whether the recording under way has ended

logger = logging.getLogger("bodydrive")


class MeasuresRenewal:
    """Renews the measures of older versions once after the start, one trial after the other, the newest first."""

    def __init__(self, database: Database, runs: SessionRuns, computing: ComputingProcess, notify: Notify) -> None:
        self._database = database
        self._runs = runs
        self._computing = computing
        self._notify = notify
        self._task: asyncio.Task[None] | None = None

    def start(self) -> None:
        """Begin to renew."""
        self._task = asyncio.create_task(self._renew_all())

    async def close(self) -> None:
        """Stop; the next start goes on with the trials that are left."""
        if self._task is not None:
            self._task.cancel()
            await asyncio.gather(self._task, return_exceptions=True)

    async def _renew_all(self) -> None:
        old = await asyncio.to_thread(self._older)
        renewed = 0
        for trial, folder in old.items():
            while self._runs.open is not None:
                await asyncio.sleep(CHECK_EVERY)
            try:
                renewed += await asyncio.to_thread(self._renew, trial, folder)
            except Exception:  # go on with the other trials; this one keeps its measures
                logger.exception("Trial %d could not be measured again", trial)
        if renewed:
            self._notify(News(what="trial"))

    def _older(self) -> dict[int, str]:
        with self._database.reading() as db:
            return trials_of_older_measures(db, MEASURES_VERSION)

    def _renew(self, trial: int, folder: str) -> bool:
        """Measure a trial again, and return whether it was; one without a readable recording keeps its measures."""
        with suppress(ValueError, OSError, Unavailable):
            measures = self._computing.ask(measure_again, self._runs.folder_of(folder))
            with self._database.transaction() as db:
                before = renew_measures(db, trial, measures)
                if before:
                    now = {name: measures.get(name) for name in before}
                    write_log(db, None, "trial measured again", trial=trial, before=before, now=now)
            return True
        return False
