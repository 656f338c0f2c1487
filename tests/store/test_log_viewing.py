"""Who looks at a patient's records stands in the log once in a quarter of an hour, whatever was looked at before."""

from collections.abc import Callable, Iterator
from datetime import timedelta
from pathlib import Path

import pytest
from sqlalchemy import select

from app.clock import utc_now
from app.store import log
from app.store.database import Database
from app.store.log import SESSION_VIEWED, VIEWED, VIEWED_EVERY, log_session_viewing, log_viewing, write_log
from app.store.log_chain import verify_log
from app.store.tables import LogEntry

START = utc_now()
SECOND = timedelta(seconds=1)
Viewed = Callable[[timedelta, str, int], list[tuple[str | None, int, timedelta]]]


@pytest.fixture
def viewed(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Viewed]:
    """Return what logs a viewing at a time after the start; it returns the persons and patients in the log."""
    file = tmp_path / "clinic.db"
    database = Database(file)

    def at(after: timedelta, person: str, patient: int) -> list[tuple[str | None, int, timedelta]]:
        monkeypatch.setattr(log, "utc_now", lambda: START + after)
        with database.transaction() as db:
            log_viewing(db, person, patient)
            write_log(db, person, "trial viewed", trial=patient)  # another row is no viewing of a patient
            rows = db.scalars(select(LogEntry).where(LogEntry.what == VIEWED).order_by(LogEntry.id))
            return [(row.person, row.details["patient"], row.at - START) for row in rows]

    yield at
    database.close()
    assert verify_log(file).whole


def test_one_row_a_person_a_patient_and_a_quarter_of_an_hour(viewed: Viewed) -> None:
    zero = timedelta(0)
    first = viewed(zero, "Ada", 1)
    assert first == [("Ada", 1, zero)]
    assert viewed(VIEWED_EVERY - SECOND, "Ada", 1) == first
    assert viewed(VIEWED_EVERY - SECOND, "Ada", 2) == [*first, ("Ada", 2, VIEWED_EVERY - SECOND)]
    assert viewed(VIEWED_EVERY - SECOND, "Rhea", 1)[-1] == ("Rhea", 1, VIEWED_EVERY - SECOND)
    # The quarter counts from the row, so somebody who reads for an hour stands there again and again.
    assert viewed(VIEWED_EVERY, "Ada", 1)[-1] == ("Ada", 1, VIEWED_EVERY)
    assert len(viewed(2 * VIEWED_EVERY - SECOND, "Ada", 1)) == 4
    assert viewed(2 * VIEWED_EVERY, "Ada", 1)[-1] == ("Ada", 1, 2 * VIEWED_EVERY)


def test_a_clock_that_is_set_back_hides_no_viewing(viewed: Viewed) -> None:
    viewed(timedelta(0), "Ada", 1)
    assert viewed(-timedelta(hours=1), "Ada", 1)[-1] == ("Ada", 1, -timedelta(hours=1))


def test_the_record_of_each_session_has_its_own_row(tmp_path: Path) -> None:
    database = Database(tmp_path / "clinic.db")
    for session in (1, 1, 2, 1):
        with database.transaction() as db:
            log_session_viewing(db, "Ada", 7, session)
    with database.reading() as db:
        rows = db.scalars(select(LogEntry.details).where(LogEntry.what == SESSION_VIEWED).order_by(LogEntry.id)).all()
    database.close()
    assert rows == [{"patient": 7, "session": 1}, {"patient": 7, "session": 2}]
