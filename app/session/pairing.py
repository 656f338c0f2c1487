"""A key that a chair and this machine share: made, kept in a file of its own, taken away."""

from pathlib import Path

from sqlalchemy.orm import Session

from app.hardware.chair.key import Key, new_key, write_key
from app.session.store_chairs import add_chair, free_key_ids, remove_chair
from app.session.tables import Chair, Clinic
from app.speeds import Speeds


def key_file(keys: Path, key_id: int) -> Path:
    """Return where the key of this number lies in the folder of all keys."""
    return keys / f"{key_id}.key"


def pair_chair(
    db: Session, clinic: Clinic, keys: Path, name: str, host: str, port: int, speeds: Speeds
) -> tuple[Chair, Key]:
    """Note a new chair and write its key into `keys`; the secret goes nowhere else than into what is returned.

    Raises
    ------
    Conflict
        When there is a chair of this name.
    OSError
        When the key cannot be written; then nothing must be kept in `db` either.
    """
    # A key file without a chair is what an interrupted pairing left: its number is not used again.
    key = new_key(next(key_id for key_id in free_key_ids(db, clinic) if not key_file(keys, key_id).exists()))
    chair = add_chair(db, clinic, name, host, port, key.id, speeds)
    keys.mkdir(mode=0o700, parents=True, exist_ok=True)
    write_key(key_file(keys, key.id), key)
    return chair, key


def unpair_chair(db: Session, clinic: Clinic, keys: Path, chair_id: int) -> Chair:
    """Take a chair out of use and its key from the disk."""
    chair = remove_chair(db, clinic, chair_id)
    key_file(keys, chair.key_id).unlink(missing_ok=True)
    return chair
