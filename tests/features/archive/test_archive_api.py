"""The archive of a patient over the API: streamed to whoever may export, imported by an owner, whole or not at all."""

import io
import shutil
import zipfile
from datetime import datetime, timedelta
from pathlib import Path
from typing import Any

import pytest
from api.fake_clinic import sentence_of
from api.people_of_clinic import accepted, invited
from exported_clinic import CODE, RUN
from features.archive.archive_clinics import rewrite

from app.disk_room import ROOM_TO_RECORD
from app.features.archive import routes
from app.features.archive.archive_file import PATIENT, REPORT, open_archive
from app.recording.reader import read_run
from app.store.files import room_for_files
from app.store.files.disk_watch import DiskRoom
from app.store.tables import Patient


def brought(clinic: Any, content: bytes | Path) -> Any:
    sent = content if isinstance(content, bytes) else content.read_bytes()
    return clinic("POST", "/archives", content=sent, headers={"Content-Type": "application/zip"})


def state_of(clinic: Any) -> tuple[list[str], list[str]]:
    """Return the patients, and the files of recordings, also of half imports."""
    settings = clinic.settings
    with clinic.database.transaction() as db:
        codes = [patient.code for patient in db.query(Patient)]
    kept = [*settings.runs.glob("*"), *settings.state.glob(".import-*")]
    return codes, sorted(str(file) for file in kept)


def test_an_archive_goes_to_another_clinic_and_leaves_it_with_the_same_hash(
    signed_in: Any, package: Path, tmp_path: Path
) -> None:
    answer = brought(signed_in, package)
    assert answer.status_code == 200, answer.text
    patient = answer.json()["patient_id"]
    imported = {"patient_id": patient, "code": CODE, "is_new": True, "sessions": 1, "trials": 1, "kept": ""}
    assert answer.json() == imported
    (row,) = [row for row in signed_in.log() if row.what == "archive imported"]
    assert (row.person, row.details["patient"]) == ("Demo clinician", patient)
    runs = signed_in.settings.runs
    assert read_run(runs / RUN).damage is None
    before = state_of(signed_in)
    assert brought(signed_in, package).json() == {**imported, "is_new": False, "sessions": 0, "trials": 0}
    assert state_of(signed_in) == before
    (tmp_path / "again.zip").write_bytes(signed_in("GET", f"/patients/{patient}/archive").content)
    with open_archive(tmp_path / "again.zip") as again, open_archive(package) as first:
        assert again.listed.hash == first.listed.hash


def test_each_answer_on_an_imported_session_or_trial_says_where_it_came_from(signed_in: Any, package: Path) -> None:
    patient = brought(signed_in, package).json()["patient_id"]
    (session,) = signed_in.good("GET", f"/patients/{patient}/sessions")
    (trial,) = signed_in.good("GET", f"/trials?patient={patient}")
    origin = session["origin"]
    assert (origin["clinic"], origin["person"]) == ("Riverside", "Demo clinician")
    (imported,) = [row for row in signed_in.log() if row.what == "archive imported"]
    assert abs(datetime.fromisoformat(origin["at"]) - imported.at) < timedelta(seconds=5)
    assert signed_in.good("GET", f"/sessions/{session['id']}")["origin"] == origin
    assert signed_in.good("GET", f"/sessions/{session['id']}/story")["origin"] == origin
    assert trial["origin"] == origin
    assert signed_in.good("GET", f"/trials/{trial['id']}")["origin"] == origin
    own = signed_in.good("POST", "/patients", json={"code": "P-77", "pseudonym": "Wren", "note": ""})["id"]
    signed_in.open_session(own)
    assert signed_in.good("GET", f"/patients/{own}/sessions")[0]["origin"] is None


def test_an_archive_is_made_with_consent_and_without_an_open_session_only(calibrated: Any) -> None:
    patient = calibrated.patient["id"]
    address = f"/patients/{patient}/archive"
    assert "has not consented" in calibrated.refused(409, "GET", address)
    with calibrated.rows() as rows:
        rows.consent(patient, "sharing")
    assert "end it first" in calibrated.refused(409, "GET", address)
    assert [row for row in calibrated.log() if row.what == "export"] == []
    calibrated.good("DELETE", "/session")
    answer = calibrated("GET", address)
    assert (answer.status_code, answer.headers["content-type"]) == (200, "application/zip")
    assert calibrated.patient["code"] not in answer.headers["content-disposition"]
    with zipfile.ZipFile(io.BytesIO(answer.content)) as opened:
        assert opened.testzip() is None
        assert opened.namelist()[1:3] == [PATIENT, REPORT]
        assert b"Course of 1 session" in opened.read(REPORT)
    (row,) = [row for row in calibrated.log() if row.what == "export"]
    assert (row.details["patient"], row.details["form"]) == (patient, "archive")
    assert list(calibrated.settings.state.glob(".export-*")) == []


def test_an_archive_without_room_on_the_disk_is_refused_before_anything_is_made(
    signed_in: Any, package: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    patient = brought(signed_in, package).json()["patient_id"]
    room = signed_in.good("GET", f"/patients/{patient}/archive/room")
    settings = signed_in.settings
    assert room == {"bytes": sum(file.stat().st_size for file in (settings.runs / RUN).iterdir()), "message": ""}
    needed = room["bytes"] + ROOM_TO_RECORD
    monkeypatch.setattr(room_for_files, "disk_room", lambda _: DiskRoom(needed - 1, None))
    refused = signed_in("GET", f"/patients/{patient}/archive")
    words = refused.json()["detail"]
    assert (refused.status_code, words.startswith("There is no room for this archive: 501 MB must")) == (507, True)
    assert signed_in.good("GET", f"/patients/{patient}/archive/room") == {**room, "message": words}
    assert [row for row in signed_in.log() if row.what == "export"] == []
    assert list(settings.state.glob(".export-*")) == []
    monkeypatch.setattr(room_for_files, "disk_room", lambda _: DiskRoom(needed, None))
    assert signed_in("GET", f"/patients/{patient}/archive").status_code == 200


def test_an_export_without_room_on_the_disk_is_refused_before_anything_is_made(
    signed_in: Any, package: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    patient = brought(signed_in, package).json()["patient_id"]
    monkeypatch.setattr(room_for_files, "disk_room", lambda _: DiskRoom(ROOM_TO_RECORD, None))
    refused = signed_in("GET", f"/patients/{patient}/export?form=csv")
    words = refused.json()["detail"]
    assert (refused.status_code, words.startswith("There is no room for this export: 501 MB must")) == (507, True)
    assert [row for row in signed_in.log() if row.what == "export"] == []
    assert signed_in("GET", f"/patients/{patient}/export?form=fhir").status_code == 200


def twice(tables: Any) -> None:
    tables["session"].append({**tables["session"][0], "id": 2})


def half_a_sign(tables: Any) -> None:
    tables["session"][0]["goal"] = "\ud800"


def test_a_wrong_archive_is_one_sentence_and_changes_nothing(signed_in: Any, package: Path, tmp_path: Path) -> None:
    before = state_of(signed_in)
    no_archive = "This is no archive of bodydrive"
    rewritten: list[tuple[dict[str, Any], str]] = [
        ({"patient": twice}, "row 2 of its table 'session' contradicts another one"),
        ({"patient": half_a_sign}, no_archive),
        *(({"text": ("12.5", number)}, no_archive) for number in ("1e999", "9" * 19, "9" * 5000)),  # a measure
    ]
    wrong = [(package.read_bytes()[:-200], no_archive), (b"", no_archive)]
    for changes, words in rewritten:
        rewrite(package, tmp_path / "wrong.zip", **changes)
        wrong.append(((tmp_path / "wrong.zip").read_bytes(), words))
    for number, (content, words) in enumerate(wrong):
        sentence = sentence_of(brought(signed_in, content), 422, f"case {number}: ")
        assert words in sentence, number
        assert "/" not in sentence, number  # no folder of this machine
        assert state_of(signed_in) == before, number


def test_what_is_in_the_clinic_already_is_refused(signed_in: Any, package: Path) -> None:
    signed_in.good("POST", "/patients", json={"code": "P-1", "pseudonym": "Heron"})
    with signed_in.database.transaction() as db:
        db.query(Patient).one().code = CODE
    before = state_of(signed_in)
    assert "belongs to another patient" in sentence_of(brought(signed_in, package), 409)
    assert state_of(signed_in) == before


def test_a_patient_who_is_here_is_replaced_when_the_person_asks_for_that(
    signed_in: Any, package: Path, tmp_path: Path
) -> None:
    patient = brought(signed_in, package).json()["patient_id"]

    def other_note(tables: Any) -> None:
        tables["patient"][0]["note"] = "Another note"

    rewrite(package, tmp_path / "newer.zip", patient=other_note)
    before = state_of(signed_in)
    refused = brought(signed_in, tmp_path / "newer.zip")
    assert (refused.status_code, refused.json()["choice"]) == (409, {"may_replace_patient": True})
    assert f"{CODE} is in this clinic already" in refused.json()["detail"]
    assert state_of(signed_in) == before
    replaced = signed_in.good("POST", "/archives?replace=true", content=(tmp_path / "newer.zip").read_bytes())
    assert (replaced["code"], replaced["is_new"], replaced["sessions"]) == (CODE, False, 1)
    assert replaced["patient_id"] != patient
    assert [one["note"] for one in signed_in.good("GET", "/patients") if one["code"] == CODE] == ["Another note"]
    settings = signed_in.settings
    with open_archive(settings.replaced / replaced["kept"]) as kept, open_archive(package) as first:
        assert kept.listed.hash == first.listed.hash


def test_a_full_disk_or_a_file_without_end_is_refused(
    signed_in: Any, package: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    before = state_of(signed_in)
    given = {"Content-Type": "application/zip", "Content-Length": "9000000000"}
    assert signed_in("POST", "/archives", content=b"PK", headers=given).status_code == 413
    monkeypatch.setattr(routes, "disk_room", lambda _: DiskRoom(1000, None))
    assert "make room" in sentence_of(brought(signed_in, package), 507)
    assert state_of(signed_in) == before


def test_whoever_imports_can_ask_how_far_it_is(signed_in: Any, package: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    size = package.stat().st_size
    seen: list[Any] = []

    def written(opened: Any, content: bytearray, folder: Path) -> None:
        write(opened, content, folder)
        opened.flush()
        seen.append(signed_in.good("GET", "/archives"))

    def imported(course: Any, who: Any, parts: Any, replace: bool) -> Any:
        seen.append(signed_in.good("GET", "/archives"))
        (course.recordings / "run").mkdir(parents=True)
        (course.recordings / "run" / "part").write_bytes(bytes(10))
        seen.append(signed_in.good("GET", "/archives"))
        shutil.rmtree(course.recordings)  # as at the end, when the recordings are moved to their place
        seen.append(signed_in.good("GET", "/archives"))
        return bring(course, who, parts, replace)

    write, bring = routes._write, routes._import
    monkeypatch.setattr(routes, "_write", written)
    monkeypatch.setattr(routes, "_import", imported)
    assert signed_in.good("GET", "/archives") is None
    assert brought(signed_in, package).status_code == 200
    assert seen == [
        {"step": "send", "done": size, "total": size},
        {"step": "unpack", "done": 0, "total": size},
        {"step": "unpack", "done": 10, "total": size},
        {"step": "unpack", "done": 10, "total": size},
    ]
    assert signed_in.good("GET", "/archives") is None
    clinician = accepted(signed_in, invited(signed_in, "Ben", "clinician"))
    with signed_in.as_person(clinician):
        assert signed_in("GET", "/archives").status_code == 403


def test_only_an_owner_imports(signed_in: Any, package: Path) -> None:
    """A clinician is refused before anything is received."""
    clinician = accepted(signed_in, invited(signed_in, "Ben", "clinician"))
    before = state_of(signed_in)
    with signed_in.as_person(clinician):
        assert brought(signed_in, package).status_code == 403
    assert state_of(signed_in) == before
