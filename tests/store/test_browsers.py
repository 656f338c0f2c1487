"""Browsers in which a person has signed in before."""

from datetime import timedelta

import pytest
from clinic_rows import ClinicRows
from sqlalchemy.orm import Session

from app.clock import utc_now
from app.store import browsers
from app.store.access.person_tables import KnownBrowser, Person
from app.store.browsers import KNOWN_FOR, find_browser, remember_browser


@pytest.fixture
def ada(db: Session) -> Person:
    return ClinicRows(db).person("Ada", "owner", "the hash of a password")


def test_a_browser_is_known_for_its_person_only_and_its_token_is_not_in_the_database(db: Session, ada: Person) -> None:
    eve = ClinicRows(db).person("Eve", "clinician", "another hash")
    token = remember_browser(db, ada, None)
    assert find_browser(db, ada, token) is not None
    for person, shown in ((eve, token), (ada, token[:-1]), (ada, ""), (ada, None), (None, token)):
        assert find_browser(db, person, shown) is None
    assert token not in str([row.token_hash for row in db.query(KnownBrowser)])


def test_another_password_and_being_disabled_make_every_browser_unknown(db: Session, ada: Person) -> None:
    token = remember_browser(db, ada, None)
    ada.disabled = utc_now()
    assert find_browser(db, ada, token) is None
    ada.disabled = None
    ada.password_hash = "the hash of a new password"
    assert find_browser(db, ada, token) is None


def test_a_browser_stays_known_from_its_last_sign_in_on(db: Session, ada: Person) -> None:
    token = remember_browser(db, ada, None)
    row = find_browser(db, ada, token)
    assert row is not None
    row.expires = utc_now() + timedelta(days=1)
    assert remember_browser(db, ada, token) == token
    assert row.expires > utc_now() + KNOWN_FOR - timedelta(hours=1)
    row.expires = utc_now() - timedelta(seconds=1)
    db.flush()
    assert find_browser(db, ada, token) is None
    assert remember_browser(db, ada, token) != token


def test_the_newest_browsers_of_a_person_are_known(db: Session, ada: Person, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(browsers, "MOST", 3)
    tokens = [remember_browser(db, ada, None) for _ in range(5)]
    assert [find_browser(db, ada, token) is not None for token in tokens] == [False, False, True, True, True]
