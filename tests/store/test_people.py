"""Clinic, people, sign-ins and the log."""

from datetime import timedelta

import pytest
from clinic_rows import ClinicRows
from sqlalchemy import text
from sqlalchemy.exc import IntegrityError
from sqlalchemy.orm import Session

from app.clock import utc_now
from app.refusals import Conflict
from app.store.access.person_tables import SignIn
from app.store.access.sign_ins import sign_in, sign_out, signed_in
from app.store.log import write_log
from app.store.people import count_people, the_clinic


def test_a_sign_in_holds_until_sign_out_and_its_token_is_not_in_the_database(db: Session) -> None:
    assert (the_clinic(db), count_people(db)) == (None, 0)
    person = ClinicRows(db).person()
    token = sign_in(db, person, "password")
    found = signed_in(db, token)
    assert found is not None
    assert found[1].name == "Ada"
    assert token not in str([row.token_hash for row in db.query(SignIn)])
    assert sign_out(db, token) == found[0].id
    assert signed_in(db, token) is None
    assert sign_out(db, token) is None


def test_an_expired_sign_in_and_a_disabled_person_are_out(db: Session) -> None:
    person = ClinicRows(db).person()
    first, second = sign_in(db, person, "password"), sign_in(db, person, "password")
    assert first != second
    session = signed_in(db, first)
    assert session is not None
    session[0].expires = utc_now() - timedelta(seconds=1)
    db.flush()
    assert (signed_in(db, first) is None, signed_in(db, second) is None) == (True, False)
    person.disabled = utc_now()
    db.flush()
    assert signed_in(db, second) is None


def test_one_name_signs_in_one_person(rows: ClinicRows) -> None:
    rows.person("Ada", "owner")
    with pytest.raises(Conflict, match="choose another name"):
        rows.person("Ada", "clinician")


def test_the_log_refuses_editing_and_deleting(db: Session) -> None:
    write_log(db, "Ada", "sign-in")
    for change in ("UPDATE log SET what = 'nothing'", "DELETE FROM log"):
        with pytest.raises(IntegrityError, match="only ever appended"):
            db.execute(text(change))
