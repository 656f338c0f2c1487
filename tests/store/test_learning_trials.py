"""The trials of a learning curve, and the map that each was driven with."""

from typing import Any

import pytest
from clinic_rows import SIMULATED, WORN, ClinicRows
from sqlalchemy import Connection, event, select

from app.clock import utc_now
from app.source import OWN_GROUPS, UNKNOWN_SOURCE, Source, SourceGroup
from app.store.adaptation_material import material_for
from app.store.learning_trials import (
    compared_trials,
    count_of_everybody,
    counted_trials,
    prior_consents,
    trials_of_everybody,
)
from app.store.parameters import as_document, current_parameters
from app.store.practice import PracticeHistory
from app.store.run_groups import RUN_GROUP
from app.store.runs import keep_trial, trials_of
from app.store.tables import Patient, Run

SOURCES: dict[SourceGroup, Source] = {
    "worn": WORN,
    "simulated": SIMULATED,
    "unknown": UNKNOWN_SOURCE,
    **{group: Source(shirt=kind, body=None, chair="virtual", simulated=False) for kind, group in OWN_GROUPS.items()},
}


@pytest.fixture
def patient(rows: ClinicRows) -> Patient:
    return rows.patient()


def test_each_trial_names_its_session_and_the_version_of_its_map(rows: ClinicRows, patient: Patient) -> None:
    first, second = rows.session(patient), rows.session(patient)
    one = rows.trial(first, {"dist": 12.0, "session": "a measure may not hide what the trial is"})
    rows.map(second, origin="adaptation", parent=1, difference={})
    two = rows.trial(second, {"dist": 11.0})
    rows.map(second, origin="back", parent=2, difference={})
    three = rows.trial(second, {"dist": 10.0})
    found = [trial.row() for trial in counted_trials(rows.db, patient.id, "room", "ahead")]
    assert [(row["id"], row["number"], row["session"], row["profile_version"], row["origin"]) for row in found] == [
        (one.id, 1, 1, 1, "calibration"),
        (two.id, 2, 2, 2, "adaptation"),
        (three.id, 3, 2, 3, "back"),
    ]
    assert [row["dist"] for row in found] == [12.0, 11.0, 10.0]


def test_only_measured_and_kept_trials_of_this_path_count(rows: ClinicRows, patient: Patient) -> None:
    session = rows.session(patient)
    rows.trial(session, None)
    discarded = rows.trial(session, {"dist": 11.0})
    keep_trial(rows.db, discarded.id, "tired")
    kept = rows.trial(session, {"dist": 10.0})
    found = counted_trials(rows.db, patient.id, "room", "ahead")
    assert [one.trial.id for one in found] == [kept.id]
    assert counted_trials(rows.db, patient.id, "room", "other") == []


def test_the_first_three_of_a_task_and_source_are_for_getting_used_to_it(rows: ClinicRows, patient: Patient) -> None:
    """They were the first three of each of two days: sessions of three trials lost six."""
    sessions = [rows.session(patient) for _ in range(2)]
    ids = []
    for place in range(8):
        source = WORN if place == 2 else UNKNOWN_SOURCE
        measures = None if place == 6 else {"dist": 10.0}
        ids.append(rows.trial(sessions[place > 1], measures, source=source).id)
    keep_trial(rows.db, ids[0], "tired")  # it was practice all the same
    found = counted_trials(rows.db, patient.id, "room", "ahead")
    assert [one.trial.id for one in found if one.familiarisation] == [ids[1], ids[2], ids[3]]
    compared = compared_trials(trials_of(rows.db, patient.id))
    assert compared == {one.trial.id for one in found if not one.familiarisation} == {ids[4], ids[5], ids[7]}


def test_everybody_is_every_patient_but_the_deleted_with_numbers_only(rows: ClinicRows, patient: Patient) -> None:
    people = [patient, *(rows.patient(f"P-{i}", "Otter") for i in (2, 3))]
    for place, person in enumerate(people):
        rows.trial(rows.session(person, number=4), {"dist": 10.0 + place}, source=UNKNOWN_SOURCE)
    people[2].deleted = utc_now()
    rows.db.flush()
    assert trials_of_everybody(rows.db, "room", "ahead", "unknown") == {}  # nobody has consented
    assert prior_consents(rows.db, "unknown") == frozenset()
    for person in people:
        rows.consent(person, "clinic_prior")
    assert prior_consents(rows.db, "unknown") == {person.id for person in people}
    found = trials_of_everybody(rows.db, "room", "ahead", "unknown")
    assert found == {
        person.id: [{"id": own, "number": 1, "session": 4, "familiarisation": True, "dist": 9.0 + own}]
        for own, person in enumerate(people[:2], start=1)
    }
    assert trials_of_everybody(rows.db, "room", "ahead", "worn") == {}
    assert count_of_everybody(rows.db, "room", "ahead") == 3


def test_a_patients_trials_in_a_task_are_found_without_reading_everybodys(rows: ClinicRows, patient: Patient) -> None:
    plans: list[str] = []

    def explain(connection: Connection, _cursor: object, statement: str, given: Any, *_: object) -> None:
        steps = connection.connection.cursor().execute(f"EXPLAIN QUERY PLAN {statement}", given).fetchall()
        plans.extend(row[-1] for row in steps if " trial " in row[-1])

    event.listen(rows.db.get_bind(), "before_cursor_execute", explain)
    counted_trials(rows.db, patient.id, "room", "ahead")
    assert len(plans) == 1
    assert "(patient_id=? AND floorplan=? AND path=?" in plans[0]


def test_trials_of_different_sources_are_never_material_together(rows: ClinicRows) -> None:
    """Safety S26: a movement that nobody made does not change the map of a person, nor the other way round."""
    session = rows.open_session()
    for group, source in SOURCES.items():
        rows.trial(session, source=source, run=group)
    for group in SOURCES:
        material = material_for(rows.db, session.patient_id, session.id, group)
        assert (material.run_ids, material.fresh, [past.run_id for past in material.past]) == ([group], 1, [group])


def test_practice_counts_only_with_the_kind_of_shirt_that_is_in_use(rows: ClinicRows) -> None:
    session = rows.open_session()
    for group, source in SOURCES.items():
        rows.trial(session, {"dist": 1.0}, source=source, run=group)
    row, profile = current_parameters(rows.db, session.patient_id)
    digest = as_document(row, profile).hash
    for group in SOURCES:
        assert PracticeHistory().practice(rows.db, session.patient_id, digest, group).trials == 1
        assert PracticeHistory().newest(rows.db, session.patient_id, group) is not None


def test_the_spread_of_everybody_is_of_one_source(rows: ClinicRows, patient: Patient) -> None:
    rows.consent(patient, "clinic_prior")
    session = rows.session(patient)
    for place, source in enumerate(SOURCES.values()):
        rows.trial(session, {"dist": float(place)}, source=source)
    for place, group in enumerate(SOURCES):
        (found,) = trials_of_everybody(rows.db, "room", "ahead", group)[patient.id]
        assert found["dist"] == place


@pytest.mark.parametrize("simulated", [None, True, False])
@pytest.mark.parametrize("shirt", ["udp", "serial", "simulator", "unknown", *OWN_GROUPS])
def test_a_query_finds_the_group_that_a_source_has(rows: ClinicRows, shirt: str, simulated: bool | None) -> None:
    source = Source(shirt=shirt, body=None, chair="virtual", simulated=simulated)
    trial = rows.trial(rows.session(), source=source)
    assert rows.db.scalar(select(RUN_GROUP).where(Run.id == trial.run_id)) == source.group
