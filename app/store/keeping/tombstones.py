"""Tombstones: which patients were erased, in a file outside the database, so that no backup brings them back.

A tombstone holds the patient's id and the moment when the patient was added, and no word about the person. The file
lies in the state folder, in the folder of the backups, and in each backup.
"""

import json
from collections.abc import Iterable
from dataclasses import dataclass
from datetime import UTC, datetime
from pathlib import Path

from app.file_modes import OWNER_FILE
from app.files import write_atomically
from app.refusals import Unavailable
from app.texts import Text


@dataclass(frozen=True, slots=True, order=True)
class Tombstone:
    """One erased patient."""

    patient: int  # the id
    created: str  # when the patient was added, ISO 8601 in UTC
    erased: str  # when


def tombstone(patient: int, created: datetime, erased: datetime) -> Tombstone:
    """Return the tombstone of a patient."""
    return Tombstone(patient, *(moment.astimezone(UTC).isoformat(" ", "microseconds") for moment in (created, erased)))


def read_tombstones(file: Path) -> frozenset[Tombstone]:
    """Return the tombstones in a file, none when there is no file; Unavailable when it cannot be read."""
    try:
        entries = json.loads(file.read_bytes())["erased"]
        return frozenset(
            Tombstone(int(entry["patient"]), str(entry["created"]), str(entry["erased"])) for entry in entries
        )
    except FileNotFoundError:
        return frozenset()
    except (ValueError, KeyError, TypeError, OSError) as error:
        raise Unavailable(Text("store-erased-list-unreadable", file=str(file))) from error


def add_tombstones(file: Path, new: Iterable[Tombstone]) -> frozenset[Tombstone]:
    """Add tombstones to a file, and return all of them; none is ever removed."""
    before = read_tombstones(file)
    union = before | frozenset(new)
    if union != before:
        entries = [
            {"patient": stone.patient, "created": stone.created, "erased": stone.erased} for stone in sorted(union)
        ]
        write_atomically(file, json.dumps({"erased": entries}, indent=1).encode() + b"\n", OWNER_FILE)
    return union
