"""The tables of backups: the owner's settings, and the backups that were made."""

from datetime import datetime

from sqlalchemy import ForeignKey, String
from sqlalchemy.orm import Mapped, mapped_column

from app.store.tables import Table, TextColumn
from app.texts import Text


class NightBackupSettings(Table):
    """Where the backups of every night go, when, and what is in them."""

    __tablename__ = "backup_settings"
    clinic_id: Mapped[int] = mapped_column(ForeignKey("clinic.id"), primary_key=True)
    folder: Mapped[str | None]  # None: no backups are made at night
    hour: Mapped[int]  # 0 to 23, local time
    with_keys: Mapped[bool]  # the chairs' and the authority's keys are in them


class MadeBackup(Table):
    """A backup that was made, or that failed."""

    __tablename__ = "made_backup"
    id: Mapped[int] = mapped_column(primary_key=True)
    at: Mapped[datetime] = mapped_column(index=True)
    place: Mapped[str]  # the file, or the folder
    name: Mapped[str] = mapped_column(String(80))  # of the file
    in_folder: Mapped[bool]  # one of a folder, which keeps 7 daily, 4 weekly and 6 monthly ones
    good: Mapped[bool]  # it was read back, and every hash is right
    message: Mapped[Text | str] = mapped_column(TextColumn(400))  # why it is not good, or what was left out
    files: Mapped[int]
    bytes: Mapped[int]
    encrypted: Mapped[bool]
    with_keys: Mapped[bool]
