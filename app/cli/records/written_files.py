"""What commands on records share: the patient of a code, files written completely or not at all, moments of UTC."""

from collections.abc import Iterator
from contextlib import contextmanager
from datetime import UTC, datetime
from pathlib import Path
from typing import TYPE_CHECKING

from app.cli.errors import InputError
from app.cli.output import check_new_folder, unwritable
from app.texts import Text

if TYPE_CHECKING:
    from app.store.database import Database


@contextmanager
def written_whole(out: Path) -> Iterator[Path]:
    """Yield a file beside `out` that replaces it at the end, or is removed when an error is raised."""
    check_new_folder(out.parent)
    if out.exists() and not out.is_file():
        raise InputError(Text("cli-out-no-file", file=str(out)))
    part = out.with_name(f".{out.name}.part")
    try:
        out.parent.mkdir(parents=True, exist_ok=True)
        yield part
        part.replace(out)
    except OSError as error:
        raise unwritable(out, error) from error
    finally:
        part.unlink(missing_ok=True)


def patient_named(database: "Database", code: str) -> int:
    """Return the id of the patient with this code."""
    from app.store.patients import all_patients

    with database.reading() as db:
        matching = [row for row in all_patients(db) if row.code == code]
        if not matching:
            raise InputError(Text("cli-no-such-patient", code=code))
        return matching[0].id


def utc_time(stored: str) -> datetime | str:
    """Return a moment in ISO 8601 as texts show it in front of "UTC"; what is none, as it is."""
    try:
        moment = datetime.fromisoformat(stored)
        return moment.astimezone(UTC).replace(tzinfo=None) if moment.tzinfo else moment
    except (ValueError, OverflowError):
        return stored
