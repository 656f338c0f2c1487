"""Small parts of a backup: which are kept, which paths are safe, which pages the system may forget."""

import os
from datetime import datetime, timedelta
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from app.features.backup.kept_backups import DAILY, MONTHLY, WEEKLY, kept_backups
from app.features.backup.manifest import is_safe
from app.features.backup.quiet_files import QuietReader
from folders import ROOT

FIRST, LAST = datetime(2020, 1, 1), datetime(2027, 1, 1)  # noqa: DTZ001  (hypothesis takes no other bounds)
LONG_AFTER = LAST + timedelta(days=365)


@given(st.sets(st.datetimes(FIRST, LAST), max_size=60))
def test_what_is_kept_is_bounded_and_holds_the_newest(moments: set[datetime]) -> None:
    kept = kept_backups(moments, LONG_AFTER)
    assert kept <= moments
    assert len(kept) <= 17
    if moments:
        assert max(moments) in kept
    assert kept_backups(kept, LONG_AFTER) == kept
    days = sorted({moment.date() for moment in moments}, reverse=True)[:7]
    assert all(max(moment for moment in moments if moment.date() == day) in kept for day in days)


def test_of_a_year_of_nights_seven_days_four_weeks_and_six_months_are_kept() -> None:
    newest = datetime(2026, 12, 31, 2)  # noqa: DTZ001  (a Thursday)
    kept = kept_backups((newest - timedelta(days=day) for day in range(365)), newest)
    days = {datetime(2026, 12, day, 2) for day in range(25, 32)}  # noqa: DTZ001
    sundays = {datetime(2026, 12, day, 2) for day in (13, 20, 27)}  # noqa: DTZ001  (the fourth week is the present one)
    ends = {datetime(2026, month, day, 2) for month, day in ((7, 31), (8, 31), (9, 30), (10, 31), (11, 30))}  # noqa: DTZ001
    assert kept == days | sundays | ends


def test_the_manual_names_as_many() -> None:
    manual = (ROOT / "docs" / "administrators.md").read_text(encoding="utf-8")
    assert f"{DAILY} daily, {WEEKLY} weekly and {MONTHLY} monthly backups stay" in manual


@given(st.lists(st.datetimes(FIRST, LAST), unique=True, min_size=1, max_size=60), st.datetimes(FIRST, LAST))
def test_the_newest_of_no_day_goes_before_seven_days_have_passed(moments: list[datetime], passed: datetime) -> None:
    newest = {moment.date(): moment for moment in sorted(moments)}
    young = {moment for moment in newest.values() if moment > passed - timedelta(days=7)}
    assert young <= kept_backups(moments, passed)


@pytest.mark.parametrize(
    ("path", "safe"),
    [("runs/a/b", True), ("../a", False), ("/etc/passwd", False), ("a/../../b", False), ("", False), ("a\\b", False)],
)
def test_no_path_leads_out_of_the_folder(path: str, safe: bool) -> None:
    assert is_safe(path) is safe


def test_reading_forgets_its_pages(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    file = tmp_path / "large"
    file.write_bytes(b"x" * 20_000_000)
    advised: list[tuple[int, int]] = []
    monkeypatch.setattr(os, "posix_fadvise", lambda _file, start, size, _how: advised.append((start, size)))
    with QuietReader(file) as opened:
        while opened.read(1 << 20):
            pass
    assert sum(size for _, size in advised) == 20_000_000
    assert len(advised) == 3
