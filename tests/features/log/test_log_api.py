"""The check of the log for the owner; the message of a full disk for every page."""

import csv
import io
import json
import logging
import sqlite3
from contextlib import closing
from datetime import datetime
from types import SimpleNamespace

import pytest
from api.fake_clinic import Clinic
from api.pairing import code_of

from app.features.log import routes as log_routes
from app.news import News
from app.settings import Settings
from app.store.files.disk_watch import DiskWatch
from app.store.log import write_log
from app.store.log_chain import FIRST, entry_hash


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
    assert f"{rows - 1} of {rows} are left" in check["message"]


def test_a_changed_log_is_said_on_the_console_at_the_start(
    settings: Settings, clinic: Clinic, caplog: pytest.LogCaptureFixture
) -> None:
    from api.running_app import running

    clinic.good("POST", "/auth/demo", json={"code": "the-code-of-the-link"})
    remove_newest(settings)
    with caplog.at_level(logging.WARNING, "bodydrive"):
        again = running(settings)
        next(again)
        with pytest.raises(StopIteration):
            next(again)
    assert "its newest rows were removed" in caplog.text


def test_a_disk_that_fills_is_told_to_open_pages(signed_in: Clinic, monkeypatch: pytest.MonkeyPatch) -> None:
    told: list[News] = []
    monkeypatch.setattr(signed_in.parts[DiskWatch], "_notify", told.append)
    usage = SimpleNamespace(free=10_000_000)
    monkeypatch.setattr("app.store.files.disk_watch.shutil.disk_usage", lambda _folder: usage)
    monkeypatch.setattr("app.store.files.disk_watch.WATCH_EVERY", 0.01)
    signed_in.until("/equipment", lambda _e: told == [News(what="disk")])
    words = signed_in.good("GET", "/equipment")["disk"]["message"]
    assert "disk of the recordings is full" in words
    assert "people can sign out" in words


def test_the_log_is_read_in_pages_and_filtered_by_person_and_patient(
    in_session: Clinic, monkeypatch: pytest.MonkeyPatch
) -> None:
    patient = in_session.good("GET", "/session")["patient"]["id"]
    other = in_session.add_patient("P-2")
    in_session.good("GET", "/trials", params={"patient": other})
    in_session.good("POST", "/patient-screen/pair", json={"code": code_of(in_session)})
    rows = in_session.log()
    everything = in_session.good("GET", "/log")
    assert [entry["id"] for entry in everything["entries"]] == [row.id for row in rows][::-1]
    assert everything["people"] == ["Demo clinician"]
    of_patient = in_session.good("GET", "/log", params={"patient": patient})["entries"]
    whats = ["patient's screen paired", "patient viewed", "session opened", "patient added"]
    assert [entry["what"] for entry in of_patient] == whats
    of_other = in_session.good("GET", "/log", params={"patient": other})["entries"]
    assert [entry["what"] for entry in of_other] == ["patient viewed", "patient added"]
    assert in_session.good("GET", "/log", params={"person": "Nobody"})["entries"] == []
    monkeypatch.setattr(log_routes, "PAGE", 2)
    newest = in_session.good("GET", "/log")
    older = in_session.good("GET", "/log", params={"before": newest["entries"][-1]["id"]})
    assert (newest["has_more"], len(newest["entries"])) == (True, 2)
    assert older["entries"] == everything["entries"][2:4]


def test_the_chain_can_be_computed_from_the_exported_lines(in_session: Clinic, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("app.features.log.service.AT_ONCE", 2)
    answer = in_session("GET", "/log/export?form=jsonl")
    assert answer.headers["content-disposition"].endswith('.jsonl"')
    previous = FIRST
    lines = [json.loads(line) for line in answer.text.splitlines()]
    for line in lines:
        moment = datetime.fromisoformat(line["at"])
        assert line["previous_hash"] == previous
        previous = entry_hash(previous, moment, line["person"], line["what"], line["details"])
        assert line["hash"] == previous
    assert [line["id"] for line in lines] == [row.id for row in in_session.log()]
    assert (lines[-1]["person"], lines[-1]["what"]) == ("Demo clinician", "log exported")


def test_a_cell_that_begins_like_a_formula_is_escaped_in_csv(signed_in: Clinic) -> None:
    names = ("=1+1", "+Ben", "-Ben", "@Ben")
    with signed_in.database.transaction() as db:
        for name in names:
            write_log(db, name, "@what", patient=1)
    answer = signed_in("GET", "/log/export?form=csv")
    rows = [row for row in csv.DictReader(io.StringIO(answer.text)) if row["details"] == '{"patient": 1}']
    assert sorted((row["person"], row["what"]) for row in rows) == sorted((f"'{name}", "'@what") for name in names)
    assert {len(row["hash"]) for row in rows} == {64}
