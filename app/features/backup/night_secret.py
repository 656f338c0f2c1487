"""The key of the backups of every night: kept on the machine, without the passphrase, and never backed up."""

import json
from pathlib import Path
from typing import Final

from app.features.backup.age_files import Secret, new_secret, opened_secret
from app.features.backup.backup_folder import HEADER, BackupFolder, sealed_key_of_folder
from app.file_modes import OWNER_FILE
from app.files import write_atomically
from app.refusals import Refusal
from app.texts import Text, text_of

FILE: Final = "night-key.json"


def read_secret(folder: Path) -> Secret | None:
    """Return the key that is kept in a folder, None when the backups of every night are not encrypted."""
    try:
        document = json.loads((folder / FILE).read_bytes())
    except FileNotFoundError:
        return None
    return Secret(document["identity"], document["sealed"])


def keep_secret(folder: Path, secret: Secret | None) -> None:
    """Keep the key in a folder, or remove the one that is there."""
    if secret is None:
        (folder / FILE).unlink(missing_ok=True)
    else:
        document = {"identity": secret.identity, "sealed": secret.sealed}
        write_atomically(folder / FILE, json.dumps(document).encode(), OWNER_FILE)


def opened_folder(
    folder: Path, passphrase: str, secret_before: Secret | None, clinic: str
) -> tuple[Secret | None, Text | str | None]:
    """Open a folder for the backups of every night: with a passphrase, or when it is empty with the key that is kept.

    `clinic` is the mark of the clinic. Return the key, and in one sentence why the folder cannot be used, None when it
    can; for the computing process, because making the key takes long.
    """
    try:
        secret = secret_of_folder(folder, passphrase) if passphrase else secret_before
        BackupFolder(folder, secret).open(clinic)
    except Refusal as refusal:
        return None, text_of(refusal)
    except OSError as error:
        return None, Text("backups-folder-not-writable", folder=str(folder), problem=error.strerror or "")
    return secret, None


def secret_of_folder(folder: Path, passphrase: str) -> Secret:
    """Return the key of a folder of backups, a new one when the folder has none; Refusal for a wrong passphrase."""
    sealed = sealed_key_of_folder(folder) if (folder / HEADER).is_file() else None
    return new_secret(passphrase) if sealed is None else opened_secret(sealed, passphrase)
