"""Restore a backup into an empty place: every file is read back and equal by hash; erased patients stay erased."""

import os
import shutil
from dataclasses import dataclass
from pathlib import Path
from typing import Final

from app.features.backup.age_files import Secret
from app.features.backup.backup_file import read_backup
from app.features.backup.manifest import Manifest, StoredFile
from app.features.backup.quiet_files import QuietReader, QuietWriter, Reader, copy_hashed, hash_of
from app.file_modes import OWNER_FOLDER
from app.refusals import Refusal
from app.settings import IN_USE, Settings
from app.store.database import Database
from app.store.keeping.erasure import erase_again
from app.store.keeping.tombstones import Tombstone, read_tombstones
from app.store.log import write_log
from app.texts import Text

WORK: Final = ".restoring"  # within the state folder, so that everything can be moved and nothing is copied again


@dataclass(frozen=True, slots=True)
class Restored:
    """A restored clinic."""

    manifest: Manifest
    erased_again: int  # patients who were erased after the backup was made


def restore(backup: Path, settings: Settings, secret: Secret | None, more: frozenset[Tombstone]) -> Restored:
    """Restore a backup into the state folder, and erase the patients of all tombstones that are known.

    Tombstones are known from the state folder, from the backup, from the folder that it lies in, and from `more`.

    Raises
    ------
    Refusal
        In one sentence, when the place is not empty or the backup is not right; the place is as it was then.
    """
    require_empty(settings)
    work = Settings(state=settings.state / WORK)
    shutil.rmtree(work.state, ignore_errors=True)
    work.state.mkdir(mode=OWNER_FOLDER, parents=True)
    beside = backup.parent / settings.erased.name
    try:
        tombstones = more | read_tombstones(settings.erased) | read_tombstones(beside)
        manifest = _read_into(work.state, backup, secret)
        _check_written(work.state, manifest)
        again = _opened_once(work, tombstones | read_tombstones(work.erased), manifest)
        for place in sorted(work.state.iterdir(), key=lambda place: place == work.database):  # the database last
            place.rename(settings.state / place.name)
    finally:
        shutil.rmtree(work.state, ignore_errors=True)
    return Restored(manifest, again)


def require_empty(settings: Settings) -> None:
    """Refuse a state folder that holds anything but tombstones."""
    if settings.state.exists():
        foreign = sorted({place.name for place in settings.state.iterdir()} - {WORK, IN_USE, settings.erased.name})
        if foreign:
            folder, kept = str(settings.state), settings.erased.name
            raise Refusal(Text("backups-not-empty", folder=folder, found=foreign[0], kept=kept))


def _read_into(state: Path, backup: Path, secret: Secret | None) -> Manifest:
    def store(file: StoredFile, content: Reader) -> tuple[int, str]:
        with QuietWriter(state / file.path) as out:
            size_and_digest = copy_hashed(content, out)
            out.keep()
        os.utime(state / file.path, ns=(file.changed, file.changed))
        return size_and_digest

    return read_backup(backup, secret, store)


def _check_written(state: Path, manifest: Manifest) -> None:
    for file in manifest.files:
        with QuietReader(state / file.path) as written:
            if hash_of(written) != (file.size, file.sha256):
                raise Refusal(Text("backups-restored-unequal", file=file.path))


def _opened_once(work: Settings, tombstones: frozenset[Tombstone], manifest: Manifest) -> int:
    """Open the restored clinic once: erase again who was erased since, and write into the log that it was restored."""
    database = Database(work.database)
    try:
        with database.transaction(closing=True) as db:
            write_log(db, None, "clinic restored", made=manifest.made, hash=manifest.hash)
        return len(erase_again(database, work, tombstones))
    finally:
        database.close()
