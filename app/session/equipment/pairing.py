"""Pairing of chairs and shirts: make the key that they share with this machine, store it in a file, delete it."""

from pathlib import Path

from app.hardware.chair.key import Key, new_key, write_key
from app.hardware.shirt.newest_frame import newest_file, write_newest
from app.refusals import Conflict
from app.speed_limits import Speeds
from app.store.chairs import LARGEST_KEY_ID, add_chair, free_key_ids, remove_chair
from app.store.database import Transaction
from app.store.tables import Clinic, PairedChair
from app.texts import Text


def key_file(keys: Path, key_id: int) -> Path:
    """Return the file of the key of this number in the folder of all keys."""
    return keys / f"{key_id}.key"


def pair_chair(
    db: Transaction, clinic: Clinic, keys: Path, name: str, host: str, port: int, speeds: Speeds
) -> tuple[PairedChair, Key]:
    """Add a chair and write its key into `keys`; the secret is in that file and in the returned key only.

    Raises
    ------
    Conflict
        When there is a chair of this name.
    OSError
        When the key cannot be written; then the caller must roll `db` back.
    """
    # An interrupted pairing leaves a key file without a chair: its number is not used again.
    key = new_key(next(key_id for key_id in free_key_ids(db, clinic) if not key_file(keys, key_id).exists()))
    chair = add_chair(db, clinic, name, host, port, key.id, speeds)
    keys.mkdir(mode=0o700, parents=True, exist_ok=True)
    write_key(key_file(keys, key.id), key)
    return chair, key


def unpair_chair(db: Transaction, keys: Path, chair_id: int) -> PairedChair:
    """Remove a chair and delete its key file."""
    chair = remove_chair(db, chair_id)
    key_file(keys, chair.key_id).unlink(missing_ok=True)
    return chair


def shirt_key_file(keys: Path, key_id: int) -> Path:
    """Return the file of the shirt's key of this number in the folder of all keys."""
    return keys / f"shirt-{key_id}.key"


def shirt_key_files(keys: Path) -> list[Path]:
    """Return the keys of all shirts that are paired, by name."""
    return sorted(file for file in keys.glob("shirt-*.key") if file.is_file())


def pair_shirt(keys: Path) -> Key:
    """Write a new shirt's key into `keys`, with a record that no frame has come yet; return the key.

    Raises
    ------
    Conflict
        When every number of a key was used.
    OSError
        When the key cannot be written; then no file is left.
    """
    keys.mkdir(mode=0o700, parents=True, exist_ok=True)
    # Deleting its key takes a shirt out of use; the record of its newest frame stays, so the number is not used again.
    for key_id in range(1, LARGEST_KEY_ID + 1):
        file = shirt_key_file(keys, key_id)
        if not file.exists() and not newest_file(file).exists():
            break
    else:
        raise Conflict(Text("visit-keys-used-up"))
    key = new_key(key_id)
    write_key(file, key)
    try:
        write_newest(newest_file(file), (0, 0))
    except BaseException:
        unpair_shirt(keys, key.id)
        raise
    return key


def unpair_shirt(keys: Path, key_id: int) -> None:
    """Delete the files of a pairing that could not be completed."""
    file = shirt_key_file(keys, key_id)
    file.unlink(missing_ok=True)
    newest_file(file).unlink(missing_ok=True)
