"""A newer archive of a patient who is here: refused, or in place of the patient, of whom an archive is kept first."""

from contextlib import closing
from datetime import timedelta
from pathlib import Path
from typing import Any

import pytest
from clinic_rows import rows_in
from exported_clinic import MEASURES, RUN, make_clinic
from features.archive.archive_clinics import archive_of, bring, empty_clinic, rewrite, state_of
from recorded_trial import record_trial

from app.clock import utc_now
from app.features.archive.archive_file import open_archive
from app.features.comments.service import add_comment, comments_of
from app.features.log.service import read_log
from app.features.records.service import add_note
from app.features.records.sign_off import sign_off
from app.recording.reader import read_run
from app.refusals import Conflict, DiskFull, PatientHere
from app.settings import Settings
from app.store.database import Database
from app.store.files import room_for_files
from app.store.files.disk_watch import DiskRoom
from app.store.files.replacements import replaced_files
from app.store.keeping.erasure import erase_patient
from app.store.keeping.incidents import lift_incident, mark_incident
from app.store.keeping.keeping_tables import PatientFile
from app.store.keeping.record_time import set_record_time
from app.store.origins import origin_of
from app.store.parameters import current_parameters, save_parameters
from app.store.patients import delete_patient, sessions_of
from app.store.tables import Patient, PatientSession, Trial
from building import make_parameters

LATER, OWN = "1" * 32, "2" * 32  # recordings of a later session there, and of one here


def add_session(settings: Settings, patient: int, run: str, title: str) -> int:
    """Add a session with a new map, a set of controls and a trial; return its id."""
    parameters = make_parameters().model_copy(update={"title": title})
    with rows_in(settings) as clinic:
        session = clinic.session(patient)
        clinic.map(session, parameters, origin="adaptation", parent=current_parameters(clinic.db, patient)[1].version)
        clinic.trial(session, MEASURES, run=run, ticks=100, end="by hand")
    record_trial(settings.runs / run, parameters, seconds=1.0)
    return session.id


def goes_on(settings: Settings) -> None:
    """Let the patient go on in the first clinic: a comment, another set on the first map, a second session."""
    with rows_in(settings) as clinic:
        dora = clinic.person("Dora", "reviewer")
        add_comment(clinic.db, clinic.db.get_one(Trial, 1), dora.id, 1.5, "It turns late.")
        _, profile = current_parameters(clinic.db, 1)
        save_parameters(clinic.db, profile, make_parameters().model_copy(update={"title": "Softer"}))
    session = add_session(settings, 1, LATER, "Later")
    with rows_in(settings) as clinic:
        add_note(clinic.db, session, "Went better.", "Ana")
        sign_off(clinic.db, clinic.db.get_one(PatientSession, session), "Ana")


class Archives:
    """The first clinic, its two archives, and their hashes."""

    def __init__(self, folder: Path) -> None:
        self.settings = make_clinic(folder)
        self.first, self.second = folder / "first.zip", folder / "second.zip"
        self.hashes = [archive_of(self.settings, self.first)]
        goes_on(self.settings)
        self.hashes.append(archive_of(self.settings, self.second))


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
    assert read_run(settings.runs / LATER).damage is None
    assert (settings.runs / RUN / "run.parquet").stat().st_mtime_ns == recording  # a recording never changes
    with closing(Database(settings.database)) as database, database.transaction() as db:
        assert [one.code for one in db.query(Patient)].count("=P-1") == 1
        newest, first = sessions_of(db, found.patient_id)
        assert {origin_of(db, one.id).archive for one in (first, newest)} == {archives.hashes[1]}  # type: ignore[union-attr]
        assert [one.text for one in comments_of(db, patient_id=found.patient_id)] == ["It turns late."]
        assert current_parameters(db, found.patient_id)[0].title == "Later"
        assert read_log(db, 1)[0].details["replaced"] == found.kept
    assert archive_of(settings, tmp_path / "again.zip", found.patient_id) == archives.hashes[1]
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
    held = archive_of(settings, tmp_path / "held.zip", patient)
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
    with rows_in(settings) as clinic:
        incident = mark_incident(clinic.db, utc_now(), "0" * 64, [patient], None).id
    refused(archives.second, "=P-1 is part of the incident of .*an owner lifts the mark")
    with rows_in(settings) as clinic:
        lift_incident(clinic.db, incident, "It is closed", "Ana")
        set_record_time(clinic.db, 10)
    add_session(settings, patient, OWN, "Own")
    refused(archives.second, "Sessions of =P-1 were held in this clinic, and their records must be kept until 20")
    later = utc_now() + timedelta(seconds=1)
    with rows_in(settings) as clinic:
        set_record_time(clinic.db, None)
        clinic.session(patient, started=later, ended=None)
    refused(archives.second, "=P-1 is open here")
    with rows_in(settings) as clinic:
        clinic.db.query(PatientSession).filter_by(ended=None).one().ended = later
    monkeypatch.setattr(room_for_files, "disk_room", lambda _: DiskRoom(1000, None))
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
