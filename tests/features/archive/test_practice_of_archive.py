"""Trials that came with an archive were driven in another clinic: they permit no real chair of this one."""

from clinic_rows import rows_in
from exported_clinic import MEASURES, make_clinic
from features.archive.archive_clinics import archive_of, bring

from app.store.learning_trials import counted_trials
from app.store.parameters import as_document, current_parameters
from app.store.practice import PracticeHistory


def current_hash(db, patient):
    return as_document(*current_parameters(db, patient)).hash


def practised(db, patient):
    """Return how many trials with the current set count as practice, and the hash of the newest practised set."""
    history = PracticeHistory()
    last = history.newest(db, patient, "simulated")
    count, _ = history.practice(db, patient, current_hash(db, patient), "simulated")
    return count, None if last is None else last.hash


def test_an_imported_trial_is_no_practice_before_a_real_chair_of_this_clinic(other, tmp_path):
    first = make_clinic(tmp_path / "from")
    archive_of(first, tmp_path / "heron.zip")
    with rows_in(first) as there:
        assert practised(there.db, 1) == (1, current_hash(there.db, 1))
    patient = bring(other, tmp_path / "heron.zip").patient_id
    with rows_in(other) as clinic:
        db = clinic.db
        assert len(list(counted_trials(db, patient, "room", "ahead"))) == 1  # it is kept, and in the curves
        assert practised(db, patient) == (0, None)
        clinic.trial(clinic.session(patient), MEASURES)  # with the current set, in a session of this clinic
        assert practised(db, patient) == (1, current_hash(db, patient))
