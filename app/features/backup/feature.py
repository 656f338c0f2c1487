"""Backups of the clinic and the archive of an incident: what the feature gives to the rest of the program."""

from typing import TYPE_CHECKING, Final

from app.features.backup.tables import MadeBackup, NightBackupSettings
from app.features.registration import Feature

if TYPE_CHECKING:
    from app.api.parts import Parts
    from app.features.registration import Background
    from app.news import Notify


def night_backups(parts: "Parts", notify: "Notify") -> "Background":
    """Return what makes the backup of every night."""
    from app.features.backup.night_backups import NightBackups
    from app.settings import Settings
    from app.store.database import Database

    return NightBackups(parts[Database], parts[Settings], notify)


FEATURE: Final = Feature(
    tables=(NightBackupSettings, MadeBackup),
    routes=("routes",),
    background=night_backups,
    not_archived={"backup_settings": "settings of this clinic's owner", "made_backup": "backups of this clinic"},
)
