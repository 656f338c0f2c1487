"""The owner's page "Backup" over the API: a real process makes the backup; deleted patients; incidents."""

import json
from datetime import UTC, datetime, timedelta
from pathlib import Path
from typing import Any

import pytest
from api.fake_clinic import Clinic
from features.backup.light_key import WORDS, make_light_keys

from app.clock import utc_now
from app.computing_process import ComputingProcess
from app.features.backup import made_backups
from app.features.backup.age_files import opened_secret
from app.features.backup.backup_file import read_backup, sealed_key_of
from app.features.backup.contents import clinic_mark
from app.features.backup.made_backups import backup_warning
from app.features.backup.night_backups import is_due
from app.settings import Settings
from app.store.keeping.incidents import mark_incident


@pytest.fixture(autouse=True)
def _cheap(monkeypatch: pytest.MonkeyPatch, signed_in: Clinic) -> None:
    """Make keys in this process, which cost little."""
    make_light_keys(monkeypatch)
    monkeypatch.setattr(
        signed_in.parts[ComputingProcess], "ask", lambda function, *given, **named: function(*given, **named)
    )


def chosen(clinic: Clinic, folder: Path | None, **more: Any) -> Any:
    body = {"folder": None if folder is None else str(folder), "hour": 2, "with_keys": False, "encrypted": False}
    return clinic("PUT", "/backups/settings", json={**body, **more})


def whats(clinic: Clinic) -> list[str]:
    return [row.what for row in clinic.log()]


@pytest.mark.parametrize("passphrase", [None, WORDS])
def test_a_folder_is_chosen_and_a_backup_is_made(signed_in: Clinic, stick: Path, passphrase: str | None) -> None:
    before = signed_in.good("GET", "/backups")
    assert (before["folder"], before["last_good"], before["made"]) == (None, None, [])
    assert before["warning"].startswith("There is no good backup yet")
    assert signed_in("POST", "/backups").status_code == 409
    more = {} if passphrase is None else {"passphrase": passphrase, "encrypted": True}
    assert chosen(signed_in, stick, **more).status_code == 200
    assert signed_in("POST", "/backups").status_code == 202
    after = signed_in.until("/backups", lambda view: view["course"] is None)
    (made,) = after["made"]
    assert (made["good"], made["in_folder"], made["with_keys"]) == (True, True, False)
    assert made["encrypted"] is bool(passphrase)
    assert (after["warning"], after["last_good"]) == ("", made["at"])
    sealed = sealed_key_of(stick / made["name"])
    assert (sealed is None) == (passphrase is None)
    secret = None if sealed is None else opened_secret(sealed, str(passphrase))
    assert len(read_backup(stick / made["name"], secret).files) == made["files"]
    logged = [row for row in signed_in.log() if row.what == "backup made"]
    assert [(row.person, row.details["encrypted"]) for row in logged] == [(logged[0].person, bool(passphrase))]
    assert passphrase is None or passphrase not in json.dumps([row.details for row in signed_in.log()])


def test_a_folder_that_is_gone_is_a_warning_and_a_failed_backup(signed_in: Clinic, stick: Path) -> None:
    chosen(signed_in, stick)
    for file in stick.iterdir():
        file.unlink()
    stick.rmdir()
    assert signed_in.good("GET", "/backups")["warning"].startswith("The folder of the backups is not there")
    signed_in("POST", "/backups")
    after = signed_in.until("/backups", lambda view: view["course"] is None)
    assert (after["made"][0]["good"], "is not there" in after["made"][0]["message"]) == (False, True)
    assert whats(signed_in)[-1] == "backup failed"


def test_a_folder_that_another_clinic_took_is_a_failed_backup(signed_in: Clinic, stick: Path) -> None:
    chosen(signed_in, stick)
    (stick / "bodydrive-backups.json").write_text('{"format": 2, "identity": null, "clinic": "another"}')
    assert signed_in("POST", "/backups").status_code == 202
    after = signed_in.until("/backups", lambda view: view["course"] is None)
    assert (after["made"][0]["good"], "of another clinic" in after["made"][0]["message"]) == (False, True)


def test_a_folder_that_cannot_be_used_is_one_sentence(signed_in: Clinic, settings: Settings, tmp_path: Path) -> None:
    foreign, neighbour = tmp_path / "foreign", tmp_path / "neighbour"
    for taken, identity, clinic in ((foreign, "a key", clinic_mark(settings)), (neighbour, None, "another")):
        taken.mkdir()
        mark = {"format": 2, "identity": identity, "clinic": clinic}
        (taken / "bodydrive-backups.json").write_text(json.dumps(mark))
    for folder, words in (
        (tmp_path / "none", "is not there"),
        (Path("relative"), "whole path"),
        (settings.state / "files", "clinic's own folder"),
        (settings.state.parent, "clinic's own folder"),
        (foreign, "another passphrase"),
        (neighbour, "holds the backups of another clinic"),
    ):
        answer = chosen(signed_in, folder)  # its sentence names the folder
        assert (answer.status_code, words in answer.json()["detail"]) == (409, True), answer.json()
    assert chosen(signed_in, None, encrypted=True).status_code == 409
    assert chosen(signed_in, None, passphrase="short", encrypted=True).status_code == 422
    assert signed_in.good("GET", "/backups")["folder"] is None


def test_a_deleted_patient_is_listed_undone_and_erased(signed_in: Clinic) -> None:
    one, other = (signed_in.add_patient(code) for code in ("A", "B"))
    assert signed_in("POST", f"/deleted-patients/{one}/erasure").status_code == 404
    for patient in (one, other):
        signed_in.good("DELETE", f"/patients/{patient}")
    listed = signed_in.good("GET", "/backups")["deleted"]
    assert [(each["code"], each["why_not"]) for each in listed] == [("B", ""), ("A", "")]
    left = datetime.fromisoformat(listed[0]["until"]) - utc_now()
    assert timedelta(days=29.9) < left <= timedelta(days=30)
    signed_in.good("POST", f"/patients/{one}/restore")
    assert signed_in.good("POST", f"/deleted-patients/{other}/erasure")["deleted"] == []
    assert [row["code"] for row in signed_in.good("GET", "/patients")] == ["A"]
    assert signed_in("POST", f"/patients/{other}/restore").status_code == 404
    assert whats(signed_in)[-3:] == ["patient restored", "patient erased", "patients listed"]


def test_records_that_must_be_kept_need_a_reason(signed_in: Clinic) -> None:
    patient = signed_in.add_patient("A")
    assert signed_in.good("PUT", "/record-keeping", json={"years": 10})["years"] == 10
    assert "give a reason" in signed_in.refused(409, "DELETE", f"/patients/{patient}")
    signed_in.good("DELETE", f"/patients/{patient}", json={"reason": "Own wish"})
    assert signed_in.log()[-1].details == {"patient": patient, "reason_given": True}
    for years in (0, 101, 1.5, "ten"):
        assert signed_in("PUT", "/record-keeping", json={"years": years}).status_code == 422


def test_an_owner_lifts_the_mark_of_an_incident_with_a_reason(signed_in: Clinic) -> None:
    patient = signed_in.add_patient("A")
    with signed_in.database.transaction() as db:
        incident = mark_incident(db, utc_now(), "0" * 64, [patient], None).id
    signed_in.good("DELETE", f"/patients/{patient}")
    assert "lifts the mark" in signed_in.refused(409, "POST", f"/deleted-patients/{patient}/erasure")
    assert signed_in("POST", f"/incidents/{incident}/lifting", json={"reason": ""}).status_code == 422
    view = signed_in.good("POST", f"/incidents/{incident}/lifting", json={"reason": "It is closed"})
    assert (view["incidents"][0]["reason"], view["incidents"][0]["patients"]) == ("It is closed", [patient])
    assert signed_in("POST", f"/incidents/{incident}/lifting", json={"reason": "Again"}).status_code == 409
    assert signed_in.good("POST", f"/deleted-patients/{patient}/erasure")["deleted"] == []


def test_an_upload_goes_with_the_patient_who_was_here(signed_in: Clinic, settings: Settings) -> None:
    def upload(name: str) -> None:
        content = b"t,a\n" + b"".join(b"%.2f,1\n" % (i / 100) for i in range(20))
        signed_in.good("POST", "/equipment/files", files={"file": (name, content)}, params={"same_name": "replace"})

    upload("nobodys.csv")
    patient = signed_in.begin_session()["id"]
    upload("theirs.csv")
    upload("given.csv")
    signed_in.good("DELETE", "/session")
    upload("given.csv")  # now it is nobody's, and what it was before lies on the shelf
    signed_in.good("DELETE", f"/patients/{patient}")
    signed_in.good("POST", f"/deleted-patients/{patient}/erasure")
    assert sorted(file.name for file in settings.files.iterdir()) == ["given.csv", "nobodys.csv"]
    assert list(settings.replaced.rglob("*given.csv")) == []


NIGHT = datetime(2026, 1, 10, 2, 30, tzinfo=UTC)


@pytest.mark.parametrize(
    ("now", "good", "tried", "due"),
    [
        (NIGHT, None, None, True),
        (NIGHT, NIGHT - timedelta(minutes=20), NIGHT - timedelta(minutes=20), False),
        (NIGHT, NIGHT - timedelta(hours=2), NIGHT - timedelta(hours=2), True),
        (NIGHT, NIGHT - timedelta(days=2), NIGHT - timedelta(minutes=50), False),  # it failed just now
        (NIGHT, NIGHT - timedelta(days=2), NIGHT - timedelta(minutes=61), True),
        (NIGHT - timedelta(hours=1), NIGHT - timedelta(hours=20), NIGHT - timedelta(hours=20), False),
        (NIGHT + timedelta(hours=8), NIGHT - timedelta(hours=24), NIGHT - timedelta(hours=24), True),  # it was off
    ],
)
def test_a_backup_is_due_once_after_the_hour(now: datetime, good: Any, tried: Any, due: bool) -> None:
    assert is_due(now, 2, good, tried) is due


def test_after_three_days_without_a_good_one_it_warns(monkeypatch: pytest.MonkeyPatch) -> None:
    now = utc_now()
    monkeypatch.setattr(made_backups, "utc_now", lambda: now)
    assert backup_warning(now - timedelta(days=2.9), has_folder=True, folder_is_there=True) is None
    warning = backup_warning(now - timedelta(days=3.1), has_folder=True, folder_is_there=True)
    assert str(warning).startswith("The last good backup is 3 days old")
