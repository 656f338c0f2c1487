"""The table of the backups that were made."""

from datetime import datetime

from sqlalchemy import String
from sqlalchemy.orm import Mapped, mapped_column

from app.store.tables import Table


class MadeBackup(Table):
    """A backup that was made, or that failed."""

    __tablename__ = "made_backup"
    id: Mapped[int] = mapped_column(primary_key=True)
    at: Mapped[datetime] = mapped_column(index=True)
    place: Mapped[str]  # the file, or the folder
    name: Mapped[str] = mapped_column(String(80))  # of the file
    in_folder: Mapped[bool]  # one of a folder, which keeps 7 daily, 4 weekly and 6 monthly ones
    good: Mapped[bool]  # it was read back, and every hash is right
    words: Mapped[str] = mapped_column(String(400))  # why it is not good, or what was left out
    files: Mapped[int]
    bytes: Mapped[int]
    encrypted: Mapped[bool]
    with_keys: Mapped[bool]
