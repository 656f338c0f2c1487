"""Makes the backups of a running clinic, one at a time, each in a process of its own; erases who is due.

The process has the lowest priority (`app/backup/backup_process.py`), so that a chair that drives does not notice.
"""

import asyncio
import logging
from collections.abc import Callable
from dataclasses import asdict
from pathlib import Path
from typing import Any, Final, NamedTuple, cast

from app.api.backup.schedule import is_due
from app.backup.backup_process import BackupJob, BackupMessage
from app.backup.night_secret import read_secret
from app.child_process import JsonChild
from app.clock import utc_now
from app.refusals import Conflict, Refusal
from app.settings import Settings
from app.store.database import Database
from app.store.files.replacements import replaced_files
from app.store.keeping.erasure import erase_due
from app.store.keeping.keeping_tables import RecordKeeping
from app.store.keeping.made_backups import add_backup, last_in_folder
from app.store.keeping.passed_time import look_at_clocks, passed_now
from app.store.keeping.record_time import record_keeping
from app.store.people import the_clinic

LOOK_EVERY: Final = 60.0  # s
ERASE_EVERY: Final = 60  # looks: once in an hour
ENDED: Final = "The process that makes the backup has ended: look at the disks, then try again."
NO_FOLDER: Final = "No folder is chosen: choose one first."
UNDER_WAY: Final = "A backup is being made already: wait until it is done."

logger = logging.getLogger("bodydrive")


class BackupProgress(NamedTuple):
    """How far the backup under way is."""

    step: str  # store or verify
    done: int  # bytes
    total: int


class NightBackups:
    """Looks every minute whether a backup is due, and makes one when somebody asks."""

    def __init__(self, database: Database, settings: Settings, tell: Callable[[str], None]) -> None:
        self._database = database
        self._settings = settings
        self._replaced = replaced_files(settings)
        self._tell = tell
        self._looking: asyncio.Task[None] | None = None
        self._making: asyncio.Task[None] | None = None
        self.course: BackupProgress | None = None  # None: no backup is being made

    def start(self) -> None:
        """Begin to look."""
        self._looking = asyncio.create_task(self._look())

    async def close(self) -> None:
        """Stop looking, and end a backup that is being made; nothing of it is left."""
        tasks = [task for task in (self._looking, self._making) if task is not None]
        for task in tasks:
            task.cancel()
        await asyncio.gather(*tasks, return_exceptions=True)

    async def begin(self, person: str | None) -> None:
        """Begin a backup into the chosen folder; Conflict when there is none, or while another is being made."""
        if self.course is not None:
            raise Conflict(UNDER_WAY)
        self.course = BackupProgress("store", 0, 0)
        try:
            job = await asyncio.to_thread(self._job)
        except BaseException:
            self.course = None
            raise
        self._making = asyncio.create_task(self._make(job, person))

    def _job(self) -> BackupJob:
        kept = self._kept()
        if kept is None or kept.folder is None:
            raise Conflict(NO_FOLDER)
        secret = read_secret(self._settings.backup)
        return {
            "state": str(self._settings.state),
            "target": kept.folder,
            "with_keys": kept.with_keys,
            "secret": None if secret is None else asdict(secret),
        }

    async def _make(self, job: BackupJob, person: str | None) -> None:
        try:
            answer = await self._answer(job)
            await asyncio.to_thread(self._store, job, answer, person)
        except Refusal:
            logger.exception("A backup could not be put into the log")
        finally:
            self.course = None
            self._tell("backups")

    async def _answer(self, job: BackupJob) -> BackupMessage:
        """Return the last message of the process that makes the backup."""
        try:
            if not await asyncio.to_thread(Path(job["target"]).is_dir):  # otherwise it would be taken for a file
                return {"refused": f"The folder {job['target']} is not there: connect the disk it lies on."}
            child = await JsonChild.start("app.backup.backup_process")
        except OSError:
            return {"refused": ENDED}
        try:
            await child.send(job)
            while "step" in (message := cast(BackupMessage, await child.receive())):
                self.course = BackupProgress(message["step"], message["done"], message["total"])
        except OSError:
            logger.exception("The process that makes a backup has ended early")
            return {"refused": ENDED}
        else:
            return message
        finally:
            await child.end()

    def _store(self, job: BackupJob, answer: BackupMessage, person: str | None) -> None:
        made = answer.get("made")
        facts: dict[str, Any] = {"name": "", "good": False, "words": answer.get("refused", ENDED)}
        if made is not None:
            same = {name: made[name] for name in ("name", "words", "files", "encrypted", "with_keys")}
            facts = {**same, "good": True, "size": made["bytes"], "digest": made["hash"]}
        with self._database.transaction(closing=True) as db:
            add_backup(db, person, place=job["target"], in_folder=True, **facts)

    async def _look(self) -> None:
        looks = 0
        while True:
            try:
                if looks % ERASE_EVERY == 0:
                    await asyncio.to_thread(self._erase)
                if self.course is None and await asyncio.to_thread(self._is_due):
                    await self.begin(None)
            except Exception:  # keep looking: a disk that is gone may come back
                logger.exception("Backups and erasures could not be looked at")
            looks += 1
            await asyncio.sleep(LOOK_EVERY)

    def _erase(self) -> None:
        """Erase what has waited for 30 days: deleted patients and replaced files."""
        with self._database.transaction(closing=True) as db:
            look_at_clocks(db)
            passed = passed_now(db)
        self._replaced.purge(passed)
        erase_due(self._database, self._settings)

    def _kept(self) -> RecordKeeping | None:
        with self._database.transaction() as db:
            clinic = the_clinic(db)
            return None if clinic is None else record_keeping(db, clinic.id)

    def _is_due(self) -> bool:
        kept = self._kept()
        if kept is None or kept.folder is None:
            return False
        with self._database.transaction() as db:
            good, tried = last_in_folder(db, good=True), last_in_folder(db, good=False)
        local = [None if moment is None else moment.astimezone() for moment in (good, tried)]
        return is_due(utc_now().astimezone(), kept.hour, *local)
