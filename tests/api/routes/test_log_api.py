"""The check of the log for the owner; the message of a full disk for every page."""

import logging
import sqlite3
from contextlib import closing
from types import SimpleNamespace

import pytest
from fake_clinic import Clinic

from app.settings import Settings


def remove_newest(settings: Settings) -> None:
    with closing(sqlite3.connect(settings.database)) as connection:
        connection.execute("DROP TRIGGER log_no_delete")
        connection.execute("DELETE FROM log WHERE id = (SELECT MAX(id) FROM log)")
        connection.commit()


def test_the_owner_sees_that_the_log_is_whole_and_that_it_was_changed(signed_in: Clinic, settings: Settings) -> None:
    rows = len(signed_in.log())
    check = signed_in.good("GET", "/log/check")
    assert (check["whole"], check["rows"]) == (True, rows)
    remove_newest(settings)
    check = signed_in.good("GET", "/log/check")
    assert not check["whole"]
    assert f"{rows - 1} of {rows} are left" in check["words"]


def test_a_changed_log_is_said_on_the_console_at_the_start(
    settings: Settings, clinic: Clinic, caplog: pytest.LogCaptureFixture
) -> None:
    from running_app import running

    clinic.good("POST", "/auth/demo", json={"code": "the-code-of-the-link"})
    remove_newest(settings)
    with caplog.at_level(logging.WARNING, "bodydrive"):
        again = running(settings)
        next(again)
        with pytest.raises(StopIteration):
            next(again)
    assert "its newest rows were removed" in caplog.text


def test_a_disk_that_fills_is_told_to_open_pages_within_two_seconds(
    signed_in: Clinic, monkeypatch: pytest.MonkeyPatch
) -> None:
    told: list[str] = []
    web = signed_in.web
    monkeypatch.setattr(web.disk, "_tell", told.append)
    usage = SimpleNamespace(free=10_000_000)
    monkeypatch.setattr("app.store.files.disk_watch.shutil.disk_usage", lambda _folder: usage)
    monkeypatch.setattr("app.store.files.disk_watch.LOOK_EVERY", 0.01)
    signed_in.until("/equipment", lambda _e: told == ["disk"])
    words = signed_in.good("GET", "/equipment")["disk"]["words"]
    assert "disk of the recordings is full" in words
    assert "people can sign out" in words
