"""The record of a session: what is written, its history, and that a sign-off locks every row of the session."""

from datetime import date
from itertools import product

import pytest
from api.fake_clinic import Clinic
from clinic_rows import ClinicRows, rows_in
from sqlalchemy import delete, select, update
from sqlalchemy.orm import Session
from store.keeping.filled_clinic import mentions
from stored_interface_test import store_interface_test

from app import __version__
from app.features.records.service import (
    Scale,
    add_note,
    add_scale,
    note_history,
    remove_scale,
    revise_note,
    session_record,
    write_goal,
)
from app.features.records.sign_off import OF_A_SESSION, sign_off, sign_off_history, unlock
from app.features.records.tables import NoteRevision, OutcomeScale, SessionNote, SessionSignOff
from app.features.sharing.tables import ShareLink
from app.refusals import Conflict, NotFound
from app.store.database import Database
from app.store.origins import ImportedSession
from app.store.patients import start_session
from app.store.tables import (
    CalibrationStep,
    Drive,
    InterfaceTest,
    PatientScreen,
    PatientSession,
    Profile,
    Run,
    Table,
    Trial,
)

DAY = date(2026, 3, 1)
NOT_LOCKED = {ImportedSession, PatientScreen, SessionSignOff, ShareLink}
CHANGED: dict[type[Table], tuple[str, object]] = {  # a column of each table, and another value
    PatientSession: ("goal", "other"),
    CalibrationStep: ("words", "other"),
    Run: ("rows", 7),
    Profile: ("version", 7),
    Trial: ("kept", False),
    Drive: ("distance", 7.0),
    InterfaceTest: ("workload", {"effort": 7.0}),
    SessionNote: ("session_id", 7),
    NoteRevision: ("text", "other"),
    OutcomeScale: ("total", 7.0),
}


@pytest.fixture
def session(rows: ClinicRows) -> PatientSession:
    return rows.open_session()


def filled(db: Session, session: PatientSession) -> Trial:
    """Give a session a row in every table of a session, and return its trial."""
    trial = ClinicRows(db).trial(session)
    store_interface_test(db, session.id)
    db.add(CalibrationStep(session_id=session.id, step="rest", status="done", words=""))
    add_note(db, session.id, "Calm.", "Ada")
    add_scale(db, session.id, "SCIM III", 41, DAY)
    db.flush()
    return trial


def test_a_new_session_holds_the_version_and_nothing_else(db: Session, session: PatientSession) -> None:
    record = session_record(db, session.id)
    assert (record.goal, record.notes, record.scales, record.sign_off) == ("", (), (), None)
    assert record.version == __version__


def test_a_revised_note_keeps_its_history(db: Session, session: PatientSession) -> None:
    note = add_note(db, session.id, "Tired.", "Ada")
    assert revise_note(db, session.id, note, "Tired after lunch.", "Ben")
    assert not revise_note(db, session.id, note, "Tired after lunch.", "Ben")
    (found,) = session_record(db, session.id).notes
    assert (found.text, found.person) == ("Tired after lunch.", "Ben")
    assert found.revised is not None
    assert found.revised >= found.written
    history = [(each.text, each.person) for each in note_history(db, note)]
    assert history == [("Tired.", "Ada"), ("Tired after lunch.", "Ben")]


def test_a_note_or_scale_of_another_session_is_not_found(db: Session, session: PatientSession) -> None:
    note, scale = add_note(db, session.id, "Calm.", "Ada"), add_scale(db, session.id, "SCIM III", 41, DAY)
    with pytest.raises(NotFound, match="no note"):
        revise_note(db, session.id + 1, note, "Other.", "Ada")
    with pytest.raises(NotFound, match="no scale"):
        remove_scale(db, session.id + 1, scale)
    assert session_record(db, session.id).scales == (Scale(scale, "SCIM III", 41, DAY),)


def is_refused(db: Session, kind: type[Table], how: str) -> bool:
    """Return whether the first row of a table cannot be changed in this way, because its session is signed off."""
    column, value = CHANGED[kind]
    row = db.scalars(select(kind)).first()
    assert row is not None, kind
    try:
        if how == "change":
            setattr(row, column, value)
        elif how == "delete":
            db.delete(row)
        elif how == "change many":
            db.execute(update(kind).values({column: value}))
        else:
            db.execute(delete(kind))
        db.flush()
    except Conflict as refused:
        return "Session 1 was signed off by Ada" in str(refused)
    return False


def test_no_row_of_a_signed_session_changes_by_any_way(database: Database) -> None:
    with rows_in(database) as rows:
        session = rows.open_session()
        filled(rows.db, session)
        rows.drive(session, "by hand")
        sign_off(rows.db, session, "Ada")
    changed = []
    for kind, how in product(OF_A_SESSION, ("change", "delete", "change many", "delete many")):
        with database.transaction() as db:
            if not is_refused(db, kind, how):
                changed.append((kind, how))
            db.rollback()
    assert changed == []


def test_the_table_of_this_test_names_every_table_of_a_session() -> None:
    of_a_session = {
        mapper.class_
        for mapper in Table.registry.mappers
        if "session_id" in mapper.columns and mapper.class_ not in NOT_LOCKED
    }
    assert {*CHANGED} == {*OF_A_SESSION} == of_a_session | {PatientSession, NoteRevision}


def test_a_sign_off_ends_an_open_session_and_stays_in_the_history(db: Session, session: PatientSession) -> None:
    filled(db, session)
    signed = sign_off(db, session, "Ada")
    assert session.ended is not None
    assert session_record(db, session.id).sign_off == signed
    with pytest.raises(Conflict, match="was signed off by Ada"):
        sign_off(db, session, "Ben")
    unlock(db, session, "Owner", "a wrong scale")
    assert session_record(db, session.id).sign_off is None
    write_goal(db, session.id, "To the kitchen.")
    sign_off(db, session, "Ben")
    history = [(row.person, row.unlocked_by, row.reason) for row in sign_off_history(db, session.id)]
    assert history == [("Ada", "Owner", "a wrong scale"), ("Ben", None, None)]
    assert start_session(db, session.patient_id).id != session.id


@pytest.mark.parametrize("running", ["trial", "drive"])
def test_a_session_in_which_something_is_driven_is_not_signed_off(
    db: Session, session: PatientSession, running: str
) -> None:
    trial = filled(db, session)
    if running == "trial":
        trial.status = "running"
    else:
        ClinicRows(db).drive(session)
    db.flush()
    with pytest.raises(Conflict, match="still being driven"):
        sign_off(db, session, "Ada")
    assert session.ended is None


def test_the_control_quality_of_a_signed_trial_can_still_be_computed(db: Session, session: PatientSession) -> None:
    trial = filled(db, session)
    sign_off(db, session, "Ada")
    trial.quality = {"computed": True}
    db.flush()


def test_a_session_that_is_not_signed_is_free_beside_one_that_is(db: Session, session: PatientSession) -> None:
    filled(db, session)
    sign_off(db, session, "Ada")
    later = start_session(db, session.patient_id)
    write_goal(db, later.id, "To the garden.")
    with pytest.raises(Conflict, match="signed off"):
        write_goal(db, session.id, "To the garden.")
    db.expire(session)


WORD = "Kestrel"
TOTAL = 41.625


def test_no_name_or_total_of_a_scale_and_no_reason_stays_in_the_log(calibrated: Clinic) -> None:
    settings = calibrated.settings
    session, patient = int(calibrated.session), calibrated.patient["id"]
    trial = calibrated.drive_trial()["id"]
    calibrated.good("POST", f"/trials/{trial}/discard", json={"reason": f"{WORD} was tired"})
    scale = {"name": f"{WORD} scale", "total": TOTAL, "day": "2026-01-01"}
    for _ in range(2):
        added = calibrated.good("POST", f"/sessions/{session}/scales", json=scale)["scales"][-1]["id"]
    calibrated.good("DELETE", f"/sessions/{session}/scales/{added}")
    calibrated.good("POST", f"/sessions/{session}/sign-off")
    calibrated.good("POST", f"/sessions/{session}/unlock", json={"reason": f"{WORD}'s wrong scale"})
    calibrated.good("DELETE", f"/patients/{patient}", json={"reason": f"{WORD} moved away"})
    calibrated.good("POST", f"/deleted-patients/{patient}/erasure")
    rows = {row.what: row.details for row in calibrated.log()}
    assert str(TOTAL) not in str(rows)
    assert list(mentions(settings.state, WORD)) == []
    assert rows["scale removed"]["scale"] == rows["scale added"]["scale"] == added
    assert rows["patient deleted"]["reason_given"]
    assert rows["patient erased"]["reason_given"]
    assert calibrated.good("GET", "/log/check")["whole"]
