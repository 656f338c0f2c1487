"""The backups that were made, when the last good one was, and the warning when it is too long ago."""

from datetime import datetime, timedelta
from typing import Final

from sqlalchemy import select
from sqlalchemy.orm import Session

from app.clock import utc_now
from app.features.backup.tables import MadeBackup
from app.store.log import write_log
from app.texts import Text

WARN_AFTER: Final = timedelta(days=3)
SHOWN: Final = 20


def add_backup(
    db: Session,
    person: str | None,
    *,
    place: str,
    name: str,
    in_folder: bool,
    good: bool,
    message: Text | str | None,
    files: int = 0,
    size: int = 0,
    digest: str = "",
    encrypted: bool = False,
    with_keys: bool = False,
) -> None:
    """Store and log that a backup was made, or that it failed."""
    db.add(
        MadeBackup(
            at=utc_now(),
            place=place,
            name=name[:80],
            in_folder=in_folder,
            good=good,
            message=message or "",
            files=files,
            bytes=size,
            encrypted=encrypted,
            with_keys=with_keys,
        )
    )
    details = {"files": files, "bytes": size, "hash": digest, "encrypted": encrypted, "with_keys": with_keys}
    if good:
        write_log(db, person, "backup made", in_folder=in_folder, **details)
    else:
        write_log(db, person, "backup failed", in_folder=in_folder)


def newest_backups(db: Session) -> list[MadeBackup]:
    """Return the newest backups, the latest first."""
    return list(db.scalars(select(MadeBackup).order_by(MadeBackup.id.desc()).limit(SHOWN)))


def last_in_folder(db: Session, *, good: bool) -> datetime | None:
    """Return when the last backup of the folder was made, or only tried; None when there was none."""
    query = select(MadeBackup.at).where(MadeBackup.in_folder).order_by(MadeBackup.id.desc()).limit(1)
    return db.scalar(query.where(MadeBackup.good) if good else query)


def last_good_backup(db: Session) -> MadeBackup | None:
    """Return the last good backup, None when there was none."""
    return db.scalar(select(MadeBackup).where(MadeBackup.good).order_by(MadeBackup.id.desc()).limit(1))


def backup_warning(last_good: datetime | None, *, has_folder: bool, folder_is_there: bool) -> Text | None:
    """Return in one sentence what is wrong with the backups, None when nothing is."""
    if has_folder and not folder_is_there:
        return Text("backups-warning-folder-gone")
    if last_good is None:
        return Text("backups-warning-none")
    if utc_now() - last_good > WARN_AFTER:
        return Text("backups-warning-old", days=(utc_now() - last_good).days)
    return None
