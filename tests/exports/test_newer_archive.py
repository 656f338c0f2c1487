"""A newer archive of a patient who came with an earlier one adds what is missing, and doubles nothing."""

from collections.abc import Iterator
from contextlib import closing
from datetime import timedelta
from pathlib import Path
from typing import Any

import pytest
from archive_clinics import bring, empty_clinic, rewrite, state_of
from exported_clinic import MEASURES, RUN, SIMULATED, make_clinic
from recorded_trial import plan_of, record_trial, store_trial
from sqlalchemy import select

from app.clock import utc_now
from app.exports.archive.archive_making import make_archive
from app.recording.reader import read_run
from app.refusals import Conflict
from app.settings import Settings
from app.store.access.person_tables import Person
from app.store.database import Database, Transaction
from app.store.learning_trials import counted_trials
from app.store.log_reading import read_log
from app.store.parameters import current_parameters, save_parameters, save_profile
from app.store.records.imports import origin_of
from app.store.records.session_record import add_note, session_record, sessions_of
from app.store.records.sign_off import sign_off
from app.store.runs import close_run
from app.store.sharing.comments import add_comment, comments_of
from app.store.tables import ParameterSet, PatientSession, Profile, Trial
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
        return make_archive(database, 1, patient, "Ana", settings.runs, package)


@pytest.fixture(scope="module")
def archives(tmp_path_factory: pytest.TempPathFactory) -> Archives:
    return Archives(tmp_path_factory.mktemp("from"))


@pytest.fixture
def here(archives: Archives, tmp_path: Path) -> tuple[Settings, int]:
    """Return a clinic that has imported the first archive, and the patient."""
    settings = empty_clinic(tmp_path / "here")
    return settings, bring(settings, archives.first).patient_id


@pytest.fixture
def reading(here: tuple[Settings, int]) -> Iterator[Transaction]:
    with closing(Database(here[0].database)) as database, database.transaction() as db:
        yield db


def test_new_sessions_sets_and_comments_are_added_and_the_hash_is_that_of_the_newer_archive(
    archives: Archives, here: tuple[Settings, int], tmp_path: Path
) -> None:
    settings, patient = here
    found = bring(settings, archives.second)
    assert found == (patient, "=P-1", False, 1, 1, 1)
    assert read_run(settings.runs / LATER).damage == ""
    with closing(Database(settings.database)) as database, database.transaction() as db:
        newest, first = sessions_of(db, patient)
        assert [origin.archive for one in (first, newest) if (origin := origin_of(db, one.id))] == archives.hashes
        record = session_record(db, newest.id)
        assert (record.notes[0].text, record.sign_off is not None) == ("Went better.", True)
        assert [one.text for one in comments_of(db, patient_id=patient)] == ["It turns late."]
        assert len(list(counted_trials(db, 1, patient, "room", "ahead"))) == 2
        assert current_parameters(db, patient)[0].title == "Later"
        assert read_log(db, 1)[0].details["sessions"] == 1
    assert made(settings, patient, tmp_path / "again.zip") == archives.hashes[1]


def test_nothing_is_doubled_by_the_same_archive_an_older_one_or_one_with_nothing_new(
    archives: Archives, here: tuple[Settings, int], tmp_path: Path
) -> None:
    settings, patient = here
    bring(settings, archives.second)
    before = state_of(settings)
    for package in (archives.second, archives.first):
        assert bring(settings, package) == (patient, "=P-1", False, 0, 0, 0)
        assert state_of(settings) == before

    def other_note(rows: Any) -> None:
        rows["patient"][0]["note"] = "Another note"

    rewrite(archives.second, tmp_path / "other.zip", patient=other_note)  # of another hash
    assert bring(settings, tmp_path / "other.zip") == (patient, "=P-1", False, 0, 0, 0)
    assert made(settings, patient, tmp_path / "again.zip") == archives.hashes[1]


def test_a_session_that_was_held_here_stays_and_numbers_that_are_taken_go_on(
    archives: Archives, here: tuple[Settings, int], tmp_path: Path
) -> None:
    settings, patient = here
    own = add_session(settings, patient, OWN, "Own")
    found = bring(settings, archives.second)
    assert (found.sessions, found.trials) == (1, 1)
    with closing(Database(settings.database)) as database, database.transaction() as db:
        assert [(one.number, origin_of(db, one.id) is None) for one in sessions_of(db, patient)] == [
            (3, False),
            (2, True),
            (1, False),
        ]
        assert db.get_one(PatientSession, own).number == 2
        trials = list(db.scalars(select(Trial).where(Trial.patient_id == patient).order_by(Trial.number)))
        assert [(one.number, one.run_id) for one in trials] == [(1, RUN), (2, OWN), (3, LATER)]
        maps = list(db.scalars(select(Profile).where(Profile.patient_id == patient).order_by(Profile.version)))
        assert [(one.version, one.parent) for one in maps] == [(1, None), (2, 1), (3, 1)]
        sets = select(ParameterSet.title).where(ParameterSet.profile_id == maps[0].id, ParameterSet.current.is_(True))
        assert len(list(db.scalars(sets))) == 1  # the map's own current set stays
    before = state_of(settings)
    assert bring(settings, archives.second).sessions == 0
    assert state_of(settings) == before


def test_an_open_session_of_the_patient_and_a_foreign_recording_refuse_it_and_nothing_changes(
    archives: Archives, here: tuple[Settings, int], tmp_path: Path
) -> None:
    settings, patient = here
    with closing(Database(settings.database)) as database, database.transaction() as db:
        now = utc_now() + timedelta(seconds=1)
        going = PatientSession(clinic_id=1, patient_id=patient, number=2, started=now, accepted=False)
        db.add(going)
    before = state_of(settings)
    with pytest.raises(Conflict, match="=P-1 is open here"):
        bring(settings, archives.second)
    assert state_of(settings) == before

    def of_another(rows: Any) -> None:
        rows["patient"][0] |= {"created": "2020-01-01T00:00:00+00:00", "code": "P-9"}

    rewrite(archives.second, tmp_path / "wrong.zip", patient=of_another)
    with pytest.raises(Conflict, match="their patient is here"):
        bring(settings, tmp_path / "wrong.zip")
    assert state_of(settings) == before


def test_a_wrong_row_of_a_newer_archive_is_one_sentence_and_nothing_changes(
    archives: Archives, here: tuple[Settings, int], tmp_path: Path
) -> None:
    settings, _ = here
    before = state_of(settings)

    def nowhere(rows: Any) -> None:
        rows["trial"][1]["parameters_id"] = 99

    rewrite(archives.second, tmp_path / "wrong.zip", patient=nowhere)
    with pytest.raises(ValueError, match="refers to a row that is not there; nothing was imported"):
        bring(settings, tmp_path / "wrong.zip")
    assert state_of(settings) == before
