"""`bodydrive incident`: what the archive holds, how a change is found, and that its patients are kept."""

import io
import json
import tarfile
import tracemalloc
from contextlib import closing
from datetime import timedelta
from hashlib import sha256
from pathlib import Path
from typing import Any

import pytest
from cli.answers import assert_refused, output_of
from sqlalchemy import text
from store.keeping.filled_clinic import two_patients

from app import realtime
from app.cli.clinic_folder import lock_folder
from app.clock import utc_now
from app.features.backup import incident_archive, quiet_files
from app.features.backup.hashed_tar import hashed_tar
from app.refusals import Conflict
from app.settings import Settings
from app.store.database import Database
from app.store.keeping.erasure import erase_patient
from app.store.keeping.incidents import all_incidents
from app.store.log import write_log
from app.store.patients import delete_patient
from app.store.tables import PatientSession, Run, Table

# What people wrote about a patient, and who may look, stays in the clinic, where it is not erased meanwhile.
LEFT_OUT = {
    *("session_note", "outcome_scale", "moment_comment", "session_sign_off", "share_link"),
    *("patient_file", "prior_entry", "incident_patient"),
}


@pytest.fixture
def settings(tmp_path: Path) -> Settings:
    """A clinic where Zebra was here three days ago, and Heron an hour ago, with a recording that is going on."""
    made = Settings(state=tmp_path / "clinic")
    two_patients(made, "Zebra", "Heron")
    with closing(Database(made.database)) as database, database.transaction() as db:
        for number, age in ((1, timedelta(days=3)), (2, timedelta(hours=1))):
            session = db.get_one(PatientSession, number)
            session.started = session.ended = utc_now() - age
        db.execute(text("UPDATE incident SET lifted = made"))
        write_log(db, "Ada", "something happened")
        newest = db.query(Run).where(Run.session_id == 2).one().folder
    (made.runs / newest / "end.json").unlink()
    (made.runs / newest / "segment-0000.arrows").write_bytes(b"rows of now")
    return made


@pytest.fixture(autouse=True)
def lowered(monkeypatch: pytest.MonkeyPatch) -> list[bool]:
    """Return whether the lowest priority was taken, which this process would keep for other tests."""
    taken: list[bool] = []
    monkeypatch.setattr(realtime, "take_lowest_priority", lambda: taken.append(True))
    return taken


def contents(file: Path) -> dict[str, bytes]:
    with tarfile.open(file) as tar:
        return {member.name: tar.extractfile(member).read() for member in tar}  # type: ignore[union-attr]


def test_the_last_24_hours_are_in_it_and_are_kept(bodydrive: Any, settings: Settings, tmp_path: Path) -> None:
    with lock_folder(settings.state):  # while the program runs
        out = output_of(bodydrive("incident", "a.incident", "--state", "clinic", "--json"))
    found = contents(tmp_path / "a.incident")
    recordings = [name for name in found if name.startswith("recordings/")]
    assert [name.rsplit("/")[-1] for name in recordings] == ["run.parquet", "segment-0000.arrows"]
    assert b"Heron" in found[recordings[0]]
    assert not any(b"Zebra" in content for content in found.values())
    parameters = json.loads(found["parameters.json"])
    assert [len(parameters[name]) for name in ("session", "trial", "drive", "profile", "parameters")] == [1] * 5
    log = [json.loads(line) for line in found["log.jsonl"].splitlines()]
    assert log[-1]["what"] == "something happened"
    assert json.loads(found["manifest.json"])["log_hash"] == log[-1]["hash"]
    assert json.loads(found["versions.json"])["packages"]["numpy"]
    assert json.loads(found["machine.json"])["cores"]
    said = json.loads(out)
    assert bodydrive("incident", "a.incident", "--check", "--json")[1] == out
    database = Database(settings.database)
    with database.transaction() as db:
        incident, patients = all_incidents(db)[0]
        assert (incident.hash, patients) == (said["hash"], [2])
        delete_patient(db, 2)
    with pytest.raises(Conflict, match="part of the incident"):
        erase_patient(database, settings, 2, "Ada")
    database.close()


def test_every_table_of_a_session_is_in_it_but_what_people_wrote_and_who_may_look(
    bodydrive: Any, settings: Settings, tmp_path: Path
) -> None:
    assert bodydrive("incident", "a.incident", "--state", "clinic")[0] == 0
    parameters = json.loads(contents(tmp_path / "a.incident")["parameters.json"])
    own = {"patient", "session", "run", "trial", "profile"}
    naming = {
        table.name
        for table in Table.metadata.sorted_tables
        for column in table.columns
        for key in column.foreign_keys
        if key.column.table.name in own
    }
    assert naming - LEFT_OUT <= parameters.keys()
    assert not LEFT_OUT & parameters.keys()
    assert all(len(parameters[name]) == 1 for name in naming - LEFT_OUT)
    assert not any({"goal", "discard_reason"} & row.keys() for rows in parameters.values() for row in rows)
    assert "token_hash" not in parameters["patient_screen"][0]
    assert parameters["patient_screen"][0]["number"] == 1


def test_a_long_recording_is_not_built_in_memory_and_the_priority_is_the_lowest(
    bodydrive: Any, settings: Settings, tmp_path: Path, lowered: list[bool], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(incident_archive, "_versions", dict)  # reading what each package says of itself takes memory
    (segment,) = settings.runs.rglob("segment-0000.arrows")
    peaks = []
    for size in (1 << 20, 24 << 20):
        with segment.open("wb") as file:
            file.truncate(size)
        tracemalloc.start()
        try:
            assert bodydrive("incident", f"{size}.incident", "--state", "clinic")[0] == 0
            peaks.append(tracemalloc.get_traced_memory()[1])
        finally:
            tracemalloc.stop()
        assert (tmp_path / f"{size}.incident").stat().st_size > size
    assert peaks[1] - peaks[0] < 4 << 20, peaks
    assert lowered == [True, True]


def test_a_recording_that_grows_is_taken_as_it_was(settings: Settings, tmp_path: Path) -> None:
    growing = tmp_path / "growing"
    growing.write_bytes(b"first")
    with quiet_files.QuietReader(growing) as reader, hashed_tar(io.BytesIO()) as tar:
        size = reader.size()
        with growing.open("ab") as file:
            file.write(b" second")
        assert tar.add("growing", reader, size) == sha256(b"first").hexdigest()


def test_a_change_of_any_part_is_found(bodydrive: Any, settings: Settings, tmp_path: Path) -> None:
    bodydrive("incident", "a.incident", "--state", "clinic")
    whole = (tmp_path / "a.incident").read_bytes()
    with tarfile.open(tmp_path / "a.incident") as tar:
        places = {member.name: member.offset_data for member in tar}
    for name, sentence in (
        ("log.jsonl", "log.jsonl in this incident file was changed"),
        ("manifest.json", "signature of this incident file is wrong"),
        ("manifest.sig", "signature of this incident file is wrong"),
        ("public-key.pem", "signature of this incident file is wrong"),
    ):
        at = places[name] + 40
        (tmp_path / "b.incident").write_bytes(whole[:at] + bytes([whole[at] ^ 1]) + whole[at + 1 :])
        assert_refused(bodydrive("incident", "b.incident", "--check"), sentence)
    (tmp_path / "b.incident").write_bytes(whole[: len(whole) // 2])
    assert "damaged or was cut off" in bodydrive("incident", "b.incident", "--check")[2]


def test_the_key_of_the_clinic_is_checked_and_another_one_refused(
    bodydrive: Any, settings: Settings, tmp_path: Path
) -> None:
    bodydrive("incident", "a.incident", "--state", "clinic")
    own = settings.signing / "clinic-ed25519-public.pem"
    assert bodydrive("incident", "a.incident", "--check", "--public-key", own)[0] == 0
    assert bodydrive("incident", "b.incident", "--state", "clinic")[0] == 0  # with the same key
    assert bodydrive("incident", "b.incident", "--check", "--public-key", own)[0] == 0
    (tmp_path / "other.pem").write_text("nothing")
    assert "Another key" in bodydrive("incident", "a.incident", "--check", "--public-key", "other.pem")[2]
    assert "already: choose another name" in bodydrive("incident", "a.incident", "--state", "clinic")[2]
    assert {file.stat().st_mode & 0o777 for file in settings.signing.iterdir()} == {0o600}
