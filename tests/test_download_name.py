"""The name of a file for a browser says what it is and when it was made."""

from datetime import UTC, datetime

from app.download_name import download_name


def test_a_name_says_what_and_when() -> None:
    made = datetime(2026, 3, 1, 8, 5, 9, tzinfo=UTC)
    assert download_name("log", made, "csv") == "bodydrive-log-20260301T080509Z.csv"
