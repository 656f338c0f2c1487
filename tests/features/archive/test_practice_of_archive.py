"""Trials that came with an archive were driven in another clinic: they permit no real chair of this one."""

from contextlib import closing

from exported_clinic import MEASURES, SIMULATED, make_clinic
from features.archive.archive_clinics import bring, empty_clinic
from recorded_trial import plan_of, store_trial

from app.clock import utc_now
from app.features.archive.service import make_archive
from app.store.database import Database
from app.store.learning_trials import counted_trials
from app.store.parameters import as_document, current_parameters
from app.store.practice import PracticeHistory
from app.store.tables import PatientSession


def current_hash(db, patient):
    return as_document(*current_parameters(db, patient)).hash


def practised(db, patient):
    """Return how many trials with the current set count as practice, and the hash of the newest practised set."""
    history = PracticeHistory()
    last = history.newest(db, patient, simulated=True)
    count, _ = history.practice(db, patient, current_hash(db, patient), simulated=True)
    return count, None if last is None else last.hash


def drive_here(db, patient):
    """Store a kept trial with the current set, in a session of this clinic."""
    row, _ = current_parameters(db, patient)
    now = utc_now()
    session = PatientSession(clinic_id=1, patient_id=patient, number=2, started=now, ended=now, accepted=True)
    db.add(session)
    db.flush()
    store_trial(db, "f" * 32, (session, row), plan_of(), SIMULATED, MEASURES)


def test_an_imported_trial_is_no_practice_before_a_real_chair_of_this_clinic(tmp_path):
    first, other = make_clinic(tmp_path / "from"), empty_clinic(tmp_path / "other")
    package = first.state / "heron.zip"
    with closing(Database(first.database)) as database:
        make_archive(database, 1, "Ana", first.runs, package)
        with database.transaction() as db:
            assert practised(db, 1) == (1, current_hash(db, 1))
    patient = bring(other, package).patient_id
    with closing(Database(other.database)) as database, database.transaction() as db:
        assert len(list(counted_trials(db, patient, "room", "ahead"))) == 1  # it is kept, and in the curves
        assert practised(db, patient) == (0, None)
        drive_here(db, patient)
        assert practised(db, patient) == (1, current_hash(db, patient))
