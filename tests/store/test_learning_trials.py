"""The trials of a learning curve, and the map that each was driven with."""

from typing import Any

import pytest
from sqlalchemy import Connection, event
from sqlalchemy.orm import Session

from app.calibration.profile import CalibrationProfile
from app.clock import utc_now
from app.features.consents.service import give_consent
from app.source import UNKNOWN_SOURCE, Source
from app.store.learning_trials import (
    compared_trials,
    count_of_everybody,
    counted_trials,
    prior_consents,
    trials_of_everybody,
)
from app.store.parameters import current_parameters, save_profile
from app.store.patients import add_patient
from app.store.runs import add_run, add_trial, finish_trial, keep_trial, trials_of
from app.store.tables import Clinic, Patient, PatientSession


@pytest.fixture
def patient(db: Session) -> Patient:
    clinic = Clinic(name="Clinic", created=utc_now(), unused=[])
    db.add(clinic)
    db.flush()
    return add_patient(db, "P-1", "Heron", "")


def add_session(db: Session, patient: Patient, number: int) -> PatientSession:
    row = PatientSession(
        clinic_id=patient.clinic_id,
        patient_id=patient.id,
        number=number,
        started=utc_now(),
        ended=utc_now(),
        accepted=False,
    )
    db.add(row)
    db.flush()
    return row


def drive(
    db: Session,
    patient: Patient,
    session: PatientSession,
    run: str,
    measures: dict[str, Any] | None,
    source: Source = UNKNOWN_SOURCE,
) -> int:
    """Make a trial with the newest map."""
    trial = add_trial(
        db,
        run=add_run(db, run, session.id, "drive", run, source),
        patient_id=patient.id,
        parameters_id=current_parameters(db, patient.id)[0].id,
        floorplan="clinic",
        floorplan_title="Clinic",
        path="corridor",
        path_points=[[0.0, 0.0], [1.0, 0.0]],
    )
    finish_trial(db, trial.id, "goal", measures)
    return trial.id


def test_each_trial_names_its_session_and_the_version_of_its_map(
    db: Session, patient: Patient, profile: CalibrationProfile
) -> None:
    first, second = add_session(db, patient, 1), add_session(db, patient, 2)
    save_profile(db, patient.id, first.id, profile)
    one = drive(db, patient, first, "a", {"dist": 12.0, "session": "a measure may not hide what the trial is"})
    save_profile(db, patient.id, second.id, profile, origin="adaptation", parent=1, difference={})
    two = drive(db, patient, second, "b", {"dist": 11.0})
    save_profile(db, patient.id, second.id, profile, origin="back", parent=2, difference={})
    three = drive(db, patient, second, "c", {"dist": 10.0})
    rows = [trial.row() for trial in counted_trials(db, patient.id, "clinic", "corridor")]
    assert [(row["id"], row["number"], row["session"], row["profile_version"], row["origin"]) for row in rows] == [
        (one, 1, 1, 1, "calibration"),
        (two, 2, 2, 2, "adaptation"),
        (three, 3, 2, 3, "back"),
    ]
    assert [row["dist"] for row in rows] == [12.0, 11.0, 10.0]


def test_only_measured_and_kept_trials_of_this_path_count(
    db: Session, patient: Patient, profile: CalibrationProfile
) -> None:
    session = add_session(db, patient, 1)
    save_profile(db, patient.id, session.id, profile)
    drive(db, patient, session, "a", None)
    discarded = drive(db, patient, session, "b", {"dist": 11.0})
    keep_trial(db, discarded, "tired")
    kept = drive(db, patient, session, "c", {"dist": 10.0})
    found = counted_trials(db, patient.id, "clinic", "corridor")
    assert [one.trial.id for one in found] == [kept]
    assert counted_trials(db, patient.id, "clinic", "other") == []


def test_the_first_three_of_a_task_and_source_are_for_getting_used_to_it(
    db: Session, patient: Patient, profile: CalibrationProfile
) -> None:
    """They were the first three of each of two days: sessions of three trials lost six."""
    sessions = [add_session(db, patient, number) for number in (1, 2)]
    save_profile(db, patient.id, sessions[0].id, profile)
    worn = Source(shirt="udp", body=None, chair="virtual", simulated=False)
    ids = []
    for place in range(8):
        source = worn if place == 2 else UNKNOWN_SOURCE
        measures = None if place == 6 else {"dist": 10.0}
        ids.append(drive(db, patient, sessions[place > 1], f"run{place}", measures, source))
    keep_trial(db, ids[0], "tired")  # it was practice all the same
    found = counted_trials(db, patient.id, "clinic", "corridor")
    assert [one.trial.id for one in found if one.familiarisation] == [ids[1], ids[2], ids[3]]
    compared = compared_trials(trials_of(db, patient.id))
    assert compared == {one.trial.id for one in found if not one.familiarisation} == {ids[4], ids[5], ids[7]}


def test_everybody_is_every_patient_but_the_deleted_with_numbers_only(
    db: Session, patient: Patient, profile: CalibrationProfile
) -> None:
    people = [patient, *(add_patient(db, f"P-{i}", "Otter", "") for i in (2, 3))]
    for place, person in enumerate(people):
        session = add_session(db, person, 4)
        save_profile(db, person.id, session.id, profile)
        drive(db, person, session, f"run{place}", {"dist": 10.0 + place})
    people[2].deleted = utc_now()
    db.flush()
    assert trials_of_everybody(db, "clinic", "corridor", "unknown") == {}  # nobody has consented
    assert prior_consents(db, "unknown") == frozenset()
    for person in people:
        give_consent(db, person.id, "clinic_prior", utc_now().date(), "Ada")
    assert prior_consents(db, "unknown") == {person.id for person in people}
    found = trials_of_everybody(db, "clinic", "corridor", "unknown")
    assert found == {
        person.id: [{"id": own, "number": 1, "session": 4, "familiarisation": True, "dist": 9.0 + own}]
        for own, person in enumerate(people[:2], start=1)
    }
    assert trials_of_everybody(db, "clinic", "corridor", "worn") == {}
    assert count_of_everybody(db, "clinic", "corridor") == 3


def test_a_patients_trials_in_a_task_are_found_without_reading_everybodys(db: Session, patient: Patient) -> None:
    plans: list[str] = []

    def explain(connection: Connection, _cursor: object, statement: str, given: Any, *_: object) -> None:
        rows = connection.connection.cursor().execute(f"EXPLAIN QUERY PLAN {statement}", given).fetchall()
        plans.extend(row[-1] for row in rows if " trial " in row[-1])

    event.listen(db.get_bind(), "before_cursor_execute", explain)
    counted_trials(db, patient.id, "clinic", "corridor")
    assert len(plans) == 1
    assert "(patient_id=? AND floorplan=? AND path=?" in plans[0]
