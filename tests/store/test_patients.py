"""Patients, sessions, controls and trials: stored, and undone."""

import pytest
from clinic_rows import ClinicRows
from sqlalchemy.orm import Session

from app.calibration.profile import CalibrationProfile
from app.calibration.vocabulary import standard_parameters
from app.refusals import Conflict, NotFound
from app.store.calibrations import begin_calibration, calibration_steps, fail_interrupted_steps, recordings_of, set_step
from app.store.parameters import (
    as_document,
    current_parameters,
    load_titled,
    save_parameters,
    save_profile,
    saved_titles,
    step_parameters,
    undo_and_redo,
)
from app.store.patients import (
    add_patient,
    all_patients,
    delete_patient,
    end_session,
    find_patient,
    open_session,
    patient_figures,
    restore_patient,
    session_progress,
    start_session,
)
from app.store.runs import add_run, close_interrupted_trials, finish_trial, keep_trial
from app.store.tables import Patient
from app.texts import Text
from building import plan_of


@pytest.fixture
def patient(rows: ClinicRows) -> Patient:
    return rows.patient()


def test_a_deleted_patient_comes_back_whole(db: Session, patient: Patient) -> None:
    delete_patient(db, patient.id)
    assert all_patients(db) == []
    with pytest.raises(NotFound):
        find_patient(db, patient.id)
    with pytest.raises(Conflict, match="deleted patient"):
        add_patient(db, "P-1", "Other", "")
    assert restore_patient(db, patient.id).pseudonym == "Heron"
    assert all_patients(db) == [patient]


def test_one_session_at_a_time_counted_per_patient(db: Session, patient: Patient) -> None:
    first = start_session(db, patient.id)
    assert start_session(db, patient.id) is first
    with pytest.raises(Conflict, match="end it first"):
        delete_patient(db, patient.id)
    other = add_patient(db, "P-2", "Otter", "")
    with pytest.raises(Conflict, match=r"^A session of P-1 is open: begun at \d\d:\d\d, 0 trials\. End it first"):
        start_session(db, other.id)
    assert first.ended is None
    assert start_session(db, other.id, ends=first.id).number == 1
    assert first.ended is not None
    end_session(db)
    assert open_session(db) is None
    second = start_session(db, patient.id)
    assert second.number == 2
    figures = patient_figures(db, [patient, other, never := add_patient(db, "P-3", "Wren", "")])
    assert figures[patient.id] == (2, 0, second.started)
    assert figures[other.id][:2] == (1, 0)
    assert figures[never.id] == (0, 0, None)
    never.deleted = never.created
    assert [p.code for p in all_patients(db)] == ["P-1", "P-2"]


def test_controls_undo_redo_and_names(db: Session, patient: Patient, profile: CalibrationProfile) -> None:
    session = start_session(db, patient.id)
    with pytest.raises(Conflict, match="Nothing is calibrated"):
        current_parameters(db, patient.id)
    row = save_profile(db, patient.id, session.id, profile)
    first, _ = current_parameters(db, patient.id)
    brisk = standard_parameters(profile).model_copy(update={"title": "Brisk", "cutoff": 5.0})
    save_parameters(db, row, brisk)
    assert step_parameters(db, patient.id, back=True).id == first.id
    with pytest.raises(Conflict, match="nothing to undo"):
        step_parameters(db, patient.id, back=True)
    assert step_parameters(db, patient.id, back=False).title == "Brisk"
    step_parameters(db, patient.id, back=True)
    save_parameters(db, row, brisk.model_copy(update={"title": "Calm"}))
    assert undo_and_redo(db, patient.id)[1] is None
    with pytest.raises(Conflict, match="nothing to redo"):
        step_parameters(db, patient.id, back=False)
    assert saved_titles(db, patient.id) == ["Standard", "Brisk", "Calm"]

    newer = save_profile(db, patient.id, session.id, profile.model_copy(update={"software": "1"}))
    assert newer.version == 2
    assert current_parameters(db, patient.id)[0].title == "Standard"
    loaded = load_titled(db, patient.id, "Brisk")
    assert as_document(loaded, newer).cutoff == 5.0
    assert loaded.hash == as_document(loaded, newer).hash
    with pytest.raises(NotFound):
        load_titled(db, patient.id, "Nowhere")


def test_calibration_steps_survive_and_interrupted_ones_say_so(db: Session, patient: Patient) -> None:
    session = start_session(db, patient.id)
    begin_calibration(db, session, {"steps": []}, ["rest", "free"])
    add_run(db, "r1", session.id, "rest", "r1")
    set_step(db, session.id, "rest", "done", "", "r1")
    add_run(db, "r2", session.id, "free", "r2")
    set_step(db, session.id, "free", "running", "", "r2")
    fail_interrupted_steps(db)
    steps = calibration_steps(db, session.id)
    assert (steps["rest"].status, steps["free"].status) == ("done", "failed")
    db.expire_all()
    assert (steps["rest"].words, steps["free"].words) == ("", Text("store-step-interrupted"))
    assert recordings_of(db, session.id) == {"rest": "r1"}
    assert session_progress(db, session) == (False, ["rest"])
    begin_calibration(db, session, {"steps": []}, ["rest", "free"])
    assert recordings_of(db, session.id) == {}


def test_trials_are_numbered_per_path_and_can_be_discarded(db: Session, rows: ClinicRows, patient: Patient) -> None:
    session = rows.open_session(patient)
    first = rows.trial(session, end=None)
    with pytest.raises(Conflict, match="end it first"):
        keep_trial(db, first.id, "tired")
    finish_trial(db, first.id, "goal", {"dist": 10.0, "sparc": float("nan")})
    assert first.measures == {"dist": 10.0, "sparc": None}
    assert rows.trial(session, end=None).number == 2
    assert rows.trial(session, plan=plan_of(name="hall"), end=None).number == 1
    assert [trial.end for trial in close_interrupted_trials(db)] == ["fault", "fault"]
    assert patient_figures(db, [patient])[patient.id].trials == 3
    keep_trial(db, first.id, "tired")
    assert patient_figures(db, [patient])[patient.id].trials == 2
    assert keep_trial(db, first.id, None).discard_reason is None
