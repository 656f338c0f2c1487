"""A newer archive of a patient who is here: refused, or in place of the patient, of whom an archive is kept first."""

from contextlib import closing
from datetime import timedelta
from pathlib import Path
from typing import Any

import pytest
from exported_clinic import MEASURES, RUN, SIMULATED, make_clinic
from features.archive.archive_clinics import bring, empty_clinic, rewrite, state_of
from recorded_trial import plan_of, record_trial, store_trial
from sqlalchemy import select

from app.clock import utc_now
from app.features.archive.archive_file import open_archive
from app.features.archive.service import make_archive
from app.features.comments.service import add_comment, comments_of
from app.features.log.service import read_log
from app.features.records.service import add_note
from app.features.records.sign_off import sign_off
from app.recording.reader import read_run
from app.refusals import Conflict, DiskFull, PatientHere
from app.settings import Settings
from app.store.access.person_tables import Person
from app.store.database import Database
from app.store.files import room_for_files
from app.store.files.disk_watch import DiskRoom
from app.store.files.replacements import replaced_files
from app.store.keeping.erasure import erase_patient
from app.store.keeping.incidents import lift_incident, mark_incident
from app.store.keeping.keeping_tables import PatientFile
from app.store.keeping.record_time import set_record_time
from app.store.origins import origin_of
from app.store.parameters import current_parameters, save_parameters, save_profile
from app.store.patients import delete_patient, sessions_of
from app.store.runs import close_run
from app.store.tables import Patient, PatientSession, Profile, Trial
from building import make_parameters

LATER, OWN = "1" * 32, "2" * 32  # recordings of a later session there, and of one here


def add_session(settings: Settings, patient: int, run: str, title: str) -> int:
    """Add a session with a new map, a set of controls and a trial; return its id."""
    with closing(Database(settings.database)) as database, database.transaction() as db:
        now = utc_now()
        number = 1 + max(one.number for one in sessions_of(db, patient))
        session = PatientSession(clinic_id=1, patient_id=patient, number=number, started=now, ended=now, accepted=True)
        db.add(session)
        db.flush()
        parameters = make_parameters().model_copy(update={"title": title})
        parent = db.scalar(
            select(Profile.version).where(Profile.patient_id == patient).order_by(Profile.version.desc())
        )
        profile = save_profile(db, patient, session.id, parameters.profile, origin="adaptation", parent=parent)
        save_parameters(db, profile, parameters)
        row, _ = current_parameters(db, patient)
        store_trial(db, run, (session, row), plan_of(), SIMULATED, MEASURES)
        close_run(db, run, 100, 0)
        made = session.id
    record_trial(settings.runs / run, parameters, seconds=1.0, plan=plan_of())
    return made


def goes_on(settings: Settings) -> None:
    """Let the patient go on in the first clinic: a comment, another set on the first map, a second session."""
    with closing(Database(settings.database)) as database, database.transaction() as db:
        dora = Person(clinic_id=1, name="Dora", role="reviewer", created=utc_now())
        db.add(dora)
        db.flush()
        add_comment(db, db.get_one(Trial, 1), dora.id, 1.5, "It turns late.")
        _, profile = current_parameters(db, 1)
        save_parameters(db, profile, make_parameters().model_copy(update={"title": "Softer"}))
    session = add_session(settings, 1, LATER, "Later")
    with closing(Database(settings.database)) as database, database.transaction() as db:
        add_note(db, session, "Went better.", "Ana")
        sign_off(db, db.get_one(PatientSession, session), "Ana")


class Archives:
    """The first clinic, its two archives, and their hashes."""

    def __init__(self, folder: Path) -> None:
        self.settings = make_clinic(folder)
        self.first, self.second = folder / "first.zip", folder / "second.zip"
        self.hashes = [made(self.settings, 1, self.first)]
        goes_on(self.settings)
        self.hashes.append(made(self.settings, 1, self.second))


def made(settings: Settings, patient: int, package: Path) -> str:
    with closing(Database(settings.database)) as database:
        return make_archive(database, patient, "Ana", settings.runs, package)


@pytest.fixture(scope="module")
def archives(tmp_path_factory: pytest.TempPathFactory) -> Archives:
    return Archives(tmp_path_factory.mktemp("from"))


@pytest.fixture
def here(archives: Archives, tmp_path: Path) -> tuple[Settings, int]:
    """Return a clinic that has imported the first archive, and the patient."""
    settings = empty_clinic(tmp_path / "here")
    return settings, bring(settings, archives.first).patient_id


def test_a_newer_archive_is_refused_and_replaces_when_a_person_asks_for_that(
    archives: Archives, here: tuple[Settings, int], tmp_path: Path
) -> None:
    settings, _ = here
    before = state_of(settings)
    with pytest.raises(PatientHere, match="=P-1 is in this clinic already, and nothing was imported: replace"):
        bring(settings, archives.second)
    assert state_of(settings) == before
    recording = (settings.runs / RUN / "run.parquet").stat().st_mtime_ns
    found = bring(settings, archives.second, replace=True)
    assert (found.code, found.is_new, found.sessions, found.trials) == ("=P-1", False, 2, 2)
    assert read_run(settings.runs / LATER).damage == ""
    assert (settings.runs / RUN / "run.parquet").stat().st_mtime_ns == recording  # a recording never changes
    with closing(Database(settings.database)) as database, database.transaction() as db:
        assert [one.code for one in db.query(Patient)].count("=P-1") == 1
        newest, first = sessions_of(db, found.patient_id)
        assert {origin_of(db, one.id).archive for one in (first, newest)} == {archives.hashes[1]}  # type: ignore[union-attr]
        assert [one.text for one in comments_of(db, patient_id=found.patient_id)] == ["It turns late."]
        assert current_parameters(db, found.patient_id)[0].title == "Later"
        assert read_log(db, 1)[0].details["replaced"] == found.kept
    assert made(settings, found.patient_id, tmp_path / "again.zip") == archives.hashes[1]
    with open_archive(settings.replaced / found.kept) as kept:
        assert kept.listed.hash == archives.hashes[0]
    assert bring(settings, settings.replaced / found.kept, replace=True).sessions == 1  # as it was before
    assert not (settings.runs / LATER).exists()


def test_the_same_archive_changes_nothing_also_when_it_may_replace(
    archives: Archives, here: tuple[Settings, int]
) -> None:
    settings, patient = here
    before = state_of(settings)
    assert bring(settings, archives.first, replace=True) == (patient, "=P-1", False, 0, 0, "")
    assert state_of(settings) == before


def test_code_pseudonym_and_uploads_of_this_clinic_stay_and_sessions_held_here_are_in_the_kept_archive(
    archives: Archives, here: tuple[Settings, int], tmp_path: Path
) -> None:
    settings, patient = here
    add_session(settings, patient, OWN, "Own")
    with closing(Database(settings.database)) as database, database.transaction() as db:
        db.get_one(Patient, patient).code = "X-9"
        db.add(PatientFile(patient_id=patient, name="own.csv", current=True))
    held = made(settings, patient, tmp_path / "held.zip")
    found = bring(settings, archives.second, replace=True)
    assert (found.code, found.sessions) == ("X-9", 2)
    with closing(Database(settings.database)) as database, database.transaction() as db:
        assert db.get_one(Patient, found.patient_id).code == "X-9"
        assert [(one.patient_id, one.name) for one in db.query(PatientFile)] == [(found.patient_id, "own.csv")]
    assert not (settings.runs / OWN).exists()
    with open_archive(settings.replaced / found.kept) as kept:
        assert kept.listed.hash == held


def test_what_stands_against_a_replacement_is_one_sentence_and_nothing_changes(
    archives: Archives, here: tuple[Settings, int], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    settings, patient = here

    def refused(package: Path, words: str) -> None:
        before = state_of(settings)
        with pytest.raises((Conflict, ValueError, DiskFull), match=words):
            bring(settings, package, replace=True)
        assert state_of(settings) == before

    def nowhere(rows: Any) -> None:
        rows["trial"][1]["parameters_id"] = 99

    rewrite(archives.second, tmp_path / "wrong.zip", patient=nowhere)
    with closing(Database(settings.database)) as database, database.transaction() as db:
        incident = mark_incident(db, utc_now(), "0" * 64, [patient], None).id
    refused(archives.second, "=P-1 is part of the incident of .*an owner lifts the mark")
    with closing(Database(settings.database)) as database, database.transaction() as db:
        lift_incident(db, incident, "It is closed", "Ana")
        set_record_time(db, 10)
    add_session(settings, patient, OWN, "Own")
    refused(archives.second, "Sessions of =P-1 were held in this clinic, and their records must be kept until 20")
    with closing(Database(settings.database)) as database, database.transaction() as db:
        set_record_time(db, None)
        now = utc_now() + timedelta(seconds=1)
        db.add(PatientSession(clinic_id=1, patient_id=patient, number=3, started=now, accepted=False))
    refused(archives.second, "=P-1 is open here")
    with closing(Database(settings.database)) as database, database.transaction() as db:
        db.query(PatientSession).filter_by(ended=None).one().ended = now
    monkeypatch.setattr(room_for_files, "disk_room", lambda _: DiskRoom(1000, ""))
    refused(archives.second, "There is no room for this archive")
    monkeypatch.undo()
    before = state_of(settings)
    with pytest.raises(ValueError, match="refers to a row that is not there; nothing was imported"):
        bring(settings, tmp_path / "wrong.zip", replace=True)
    assert state_of(settings)[0] == before[0]  # the rows; the archive that was kept first may stay
    assert set(before[1]) <= set(state_of(settings)[1])


def test_the_kept_archive_goes_after_30_days_or_with_the_patient(
    archives: Archives, here: tuple[Settings, int]
) -> None:
    settings, _ = here
    found = bring(settings, archives.second, replace=True)
    kept = settings.replaced / found.kept
    replaced_files(settings).purge(utc_now() + timedelta(days=29))
    assert kept.exists()
    replaced_files(settings).purge(utc_now() + timedelta(days=31))
    assert not kept.exists()
    kept.write_bytes(b"as it was")
    with closing(Database(settings.database)) as database:
        with database.transaction() as db:
            delete_patient(db, found.patient_id)
        erase_patient(database, settings, found.patient_id, "Ana")
    assert not kept.exists()
