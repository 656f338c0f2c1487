"""Make the backups of a running clinic, one at a time, each in a process of its own: at night, and when asked for.

The process has the lowest priority (`app/features/backup/backup_process.py`), so that a chair that drives does not
notice.
"""

import asyncio
import logging
from dataclasses import asdict
from datetime import datetime, timedelta
from pathlib import Path
from typing import Any, Final, NamedTuple, cast

from sqlalchemy.orm import Session

from app.child_process import JsonChild
from app.clock import utc_now
from app.features.backup.backup_process import BackupJob, BackupMessage
from app.features.backup.made_backups import add_backup, last_in_folder
from app.features.backup.night_secret import read_secret
from app.features.backup.tables import NightBackupSettings
from app.news import News, Notify
from app.refusals import Conflict, Refusal
from app.settings import Settings
from app.store.access.visible_patients import own_clinic_id
from app.store.database import Database
from app.store.people import the_clinic
from app.texts import Text, from_document, to_document

FIRST_HOUR: Final = 2  # local time of the backup of every night, until the owner chooses another
AGAIN_AFTER: Final = timedelta(hours=1)  # a backup that failed is tried again
LOOK_EVERY: Final = 60.0  # s
ENDED: Final = Text("backups-process-ended")

logger = logging.getLogger("bodydrive")


def backup_settings(db: Session) -> NightBackupSettings:
    """Return the clinic's settings; when nobody has chosen any, those of a new clinic, which are not stored."""
    clinic_id = own_clinic_id(db)
    first = NightBackupSettings(clinic_id=clinic_id, folder=None, hour=FIRST_HOUR, with_keys=False)
    return db.get(NightBackupSettings, clinic_id) or first


def is_due(now: datetime, hour: int, last_good: datetime | None, last_try: datetime | None) -> bool:
    """Return whether there was no good backup since the last time that the clock showed `hour`.

    Of a machine that was off in the night, it is due when the machine is on again. All moments are in the local zone.
    """
    at_hour = now.replace(hour=hour, minute=0, second=0, microsecond=0)
    scheduled = at_hour if at_hour <= now else at_hour - timedelta(days=1)
    if last_good is not None and last_good >= scheduled:
        return False
    return last_try is None or now - last_try >= AGAIN_AFTER


class BackupProgress(NamedTuple):
    """How far the backup under way is."""

    step: str  # store or verify
    done: int  # bytes
    total: int


class NightBackups:
    """Looks every minute whether a backup is due, and makes one when somebody asks."""

    def __init__(self, database: Database, settings: Settings, notify: Notify) -> None:
        self._database = database
        self._settings = settings
        self._notify = notify
        self._watching: asyncio.Task[None] | None = None
        self._making: asyncio.Task[None] | None = None
        self.course: BackupProgress | None = None  # None: no backup is being made

    def start(self) -> None:
        """Begin to look."""
        self._watching = asyncio.create_task(self._watch())

    async def close(self) -> None:
        """Stop looking, and end a backup that is being made; nothing of it is left."""
        tasks = [task for task in (self._watching, self._making) if task is not None]
        for task in tasks:
            task.cancel()
        await asyncio.gather(*tasks, return_exceptions=True)

    async def begin(self, person: str | None) -> None:
        """Begin a backup into the chosen folder; Conflict when there is none, or while another is being made."""
        if self.course is not None:
            raise Conflict(Text("backups-under-way"))
        self.course = BackupProgress("store", 0, 0)
        try:
            job = await asyncio.to_thread(self._job)
        except BaseException:
            self.course = None
            raise
        self._making = asyncio.create_task(self._make(job, person))

    def _job(self) -> BackupJob:
        chosen = self._chosen()
        if chosen is None or chosen.folder is None:
            raise Conflict(Text("backups-no-folder"))
        secret = read_secret(self._settings.backup)
        return {
            "state": str(self._settings.state),
            "target": chosen.folder,
            "with_keys": chosen.with_keys,
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
            self._notify(News(what="backups"))

    async def _answer(self, job: BackupJob) -> BackupMessage:
        """Return the last message of the process that makes the backup."""
        try:
            if not await asyncio.to_thread(Path(job["target"]).is_dir):  # otherwise it would be taken for a file
                return {"refused": to_document(Text("backups-folder-gone", folder=job["target"]))}
            child = await JsonChild.start("app.features.backup.backup_process")
        except OSError:
            return {"refused": to_document(ENDED)}
        try:
            await child.send(job)
            while "step" in (message := cast(BackupMessage, await child.receive())):
                self.course = BackupProgress(message["step"], message["done"], message["total"])
        except OSError:
            logger.exception("The process that makes a backup has ended early")
            return {"refused": to_document(ENDED)}
        else:
            return message
        finally:
            await child.end()

    def _store(self, job: BackupJob, answer: BackupMessage, person: str | None) -> None:
        report = answer.get("made")
        refused = from_document(answer.get("refused", to_document(ENDED)))
        facts: dict[str, Any] = {"name": "", "good": False, "message": refused}
        if report is not None:
            same = {name: report[name] for name in ("name", "files", "encrypted", "with_keys")}
            left_out = report["message"] and from_document(report["message"])
            facts = {**same, "good": True, "message": left_out, "size": report["bytes"], "digest": report["hash"]}
        with self._database.transaction(closing=True) as db:
            add_backup(db, person, place=job["target"], in_folder=True, **facts)

    async def _watch(self) -> None:
        while True:
            try:
                if self.course is None and await asyncio.to_thread(self._is_due):
                    await self.begin(None)
            except Exception:  # keep looking: a disk that is gone may come back
                logger.exception("It could not be seen whether a backup is due")
            await asyncio.sleep(LOOK_EVERY)

    def _chosen(self) -> NightBackupSettings | None:
        with self._database.reading() as db:
            return None if the_clinic(db) is None else backup_settings(db)

    def _is_due(self) -> bool:
        chosen = self._chosen()
        if chosen is None or chosen.folder is None:
            return False
        with self._database.reading() as db:
            good, tried = last_in_folder(db, good=True), last_in_folder(db, good=False)
        local = [None if moment is None else moment.astimezone() for moment in (good, tried)]
        return is_due(utc_now().astimezone(), chosen.hour, *local)
