"""Nothing is erased by a clock that is set forward: only days count that the machine has really counted."""

from dataclasses import replace
from datetime import UTC, datetime, timedelta
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st
from store.keeping.filled_clinic import rows_by_table
from store.keeping.test_erasure import CLINIC, filled  # noqa: F401  (a fixture)

from app.refusals import Conflict
from app.store.files.replacements import replaced_files
from app.store.keeping import passed_time
from app.store.keeping.erasure import erase_due
from app.store.keeping.passed_time import DAY, Reading, clock_warning, compare_clocks, passed_now, store_clocks
from app.store.keeping.record_time import set_record_time
from app.store.patients import delete_patient, restore_patient
from app.store.tables import LogEntry

BEGUN = Reading(datetime(2026, 3, 1, 8, tzinfo=UTC), 1000.0, "first")
NOBODY_TOLD = 0.0


def after(reading: Reading, *, wall: float, count: float, boot: str | None = None) -> Reading:
    """Return a later reading: `wall` days later on the wall clock, `count` days later on the monotonic one."""
    later = reading.wall + timedelta(days=wall)
    return Reading(later, reading.count + count * DAY if boot is None else 60.0, boot or reading.boot)


def test_without_a_jump_the_time_is_that_of_the_wall_clock() -> None:
    passed, _ = compare_clocks(None, BEGUN)
    for day in range(40):
        passed, told = compare_clocks(passed, after(BEGUN, wall=day, count=day))
        assert told == NOBODY_TOLD
        assert passed.now == BEGUN.wall + timedelta(days=day)


@pytest.mark.parametrize("boot", [None, "second"])
def test_a_clock_that_is_set_forward_counts_as_a_day_at_most_and_is_told(boot: str | None) -> None:
    first, _ = compare_clocks(None, BEGUN)
    passed, told = compare_clocks(first, after(BEGUN, wall=31, count=0.001, boot=boot))
    assert told > 29 * DAY
    assert passed.now - BEGUN.wall <= timedelta(days=1)


def test_a_machine_that_is_off_each_night_and_weekend_is_not_told_and_waits_little_longer() -> None:
    passed, _ = compare_clocks(None, BEGUN)
    day = 0
    while passed.now < BEGUN.wall + timedelta(days=30):
        day += 1
        if day % 7 < 5:
            for hours in (0.0, 8.0):
                wall = BEGUN.wall + timedelta(days=day, hours=hours)
                passed, told = compare_clocks(passed, Reading(wall, 60.0 + hours * 3600, f"day {day}"))
                assert told == NOBODY_TOLD
    assert day <= 45


steps = st.tuples(
    st.floats(-400, 400),  # days that the wall clock is set to another time
    st.floats(0, 20),  # days that really pass
    st.booleans(),  # whether the machine was off meanwhile
)


@given(st.lists(steps, max_size=30), st.integers(0, 30))
def test_what_is_due_after_30_days_has_waited_as_many_counted_days(
    course: list[tuple[float, float, bool]], when: int
) -> None:
    """Whatever the clock does, from a moment on that is stamped by the wall clock as it was then."""
    passed, _ = compare_clocks(None, BEGUN)
    reading, stamped, counted = BEGUN, None, 0.0
    for number, (set_by, days, off) in enumerate(course):
        if number == when:
            stamped, counted = reading.wall, 0.0
        wall = reading.wall + timedelta(days=set_by + days)
        gone_on = (wall - reading.wall) / timedelta(days=1)
        still_on = replace(reading, wall=wall, count=reading.count + days * DAY)
        reading = Reading(wall, 60.0, f"boot {number}") if off else still_on
        counted += min(max(gone_on, 0.0), 1.0) if off else days
        passed, _ = compare_clocks(passed, reading)
        if stamped is not None and passed.now >= stamped + timedelta(days=30):
            assert counted >= 30 - 1e-6


@pytest.fixture
def clocks(monkeypatch: pytest.MonkeyPatch) -> Any:
    """Return a function that sets what the clocks say."""

    def set_to(reading: Reading) -> None:
        monkeypatch.setattr(passed_time, "_reading", lambda: reading)

    return set_to


@pytest.mark.parametrize("boot", [None, "another"])
def test_a_start_with_a_clock_31_days_ahead_erases_nothing_and_says_so(filled: Any, clocks: Any, boot: Any) -> None:  # noqa: F811
    shelf = replaced_files(filled.settings)
    filled.settings.files.mkdir(exist_ok=True)
    (filled.settings.files / "again.csv").write_bytes(b"t\n0\n")
    shelf.shelve("file", filled.settings.files / "again.csv")
    now = passed_time._reading()
    filled.delete(filled.goes)
    filled.look()
    clocks(after(now, wall=31, count=0.01, boot=boot))
    filled.look()
    erase_due(filled.database, filled.settings)
    with filled.database.transaction() as db:
        shelf.purge(passed_now(db))
        assert "30 days" in str(clock_warning(db)) or "31 days" in str(clock_warning(db))
        jumped = db.query(LogEntry).where(LogEntry.what == "clock jumped").one()
        assert jumped.details["seconds"] > 29 * DAY
        restore_patient(db, filled.goes)
    assert rows_by_table(filled.settings.database, filled.goes)
    assert [file.name for file in shelf.listed() if file.name == "again.csv"] == ["again.csv"]


def test_before_the_first_look_the_log_says_when_the_program_ran(filled: Any, clocks: Any) -> None:  # noqa: F811
    filled.delete(filled.goes)
    clocks(after(passed_time._reading(), wall=31, count=31))
    erase_due(filled.database, filled.settings)
    assert rows_by_table(filled.settings.database, filled.goes)


def test_records_that_must_be_kept_are_not_free_because_the_clock_is_years_ahead(filled: Any, clocks: Any) -> None:  # noqa: F811
    filled.look()
    with filled.database.transaction() as db:
        set_record_time(db, 10)
    clocks(after(passed_time._reading(), wall=4000, count=0, boot="another"))
    with pytest.raises(Conflict, match="must be kept"), filled.database.transaction() as db:
        delete_patient(db, filled.goes, "")


def test_a_clock_that_is_set_back_is_logged(filled: Any, clocks: Any) -> None:  # noqa: F811
    filled.look()
    clocks(after(passed_time._reading(), wall=-2, count=0.01))
    with filled.database.transaction() as db:
        store_clocks(db)
        assert db.query(LogEntry).where(LogEntry.what == "clock jumped").one().details["seconds"] < -DAY
        assert clock_warning(db) is None
