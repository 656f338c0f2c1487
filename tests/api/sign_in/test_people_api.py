"""Disabling and enabling people, their rights, the own password: what ends, and when."""

import subprocess
import sys
from contextlib import ExitStack

import pytest
from api.fake_clinic import BASE, Clinic
from api.pairing import closing
from api.people_of_clinic import OWNER, PASSWORD, accepted, invited

from app.api import sockets
from app.store.access.person_tables import KnownBrowser

ORIGIN = {"Origin": BASE}


@pytest.fixture
def ben(owned: Clinic) -> dict[str, str]:
    """Return the cookies of a clinician."""
    return accepted(owned, invited(owned, "Ben", "clinician"))


def id_of(owned: Clinic, name: str) -> int:
    return int(next(person["id"] for person in owned.good("GET", "/people") if person["name"] == name))


def test_disabling_ends_sign_ins_and_sockets_at_once_and_forgets_browsers(
    owned: Clinic, ben: dict[str, str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(sockets, "CHECK_EVERY", 3600.0)  # so that the check of open sockets is not what closes it
    person = id_of(owned, "Ben")
    with ExitStack() as stack:
        with owned.as_person(ben):
            socket = stack.enter_context(owned.socket("/live"))
            socket.receive_json()
        assert owned.good("POST", f"/people/{person}/disable")["state"] == "disabled"
        assert closing(socket) == 4401
    with owned.database.transaction() as db:
        assert db.query(KnownBrowser).filter_by(person_id=person).count() == 0
    with owned.as_person(ben):
        assert owned("GET", "/patients").status_code == 401
        assert owned("POST", "/auth/sign-in", json={"name": "Ben", "password": PASSWORD}).status_code == 401
    assert owned("POST", f"/people/{person}/link").status_code == 409
    assert owned.good("POST", f"/people/{person}/enable")["state"] == "active"
    with owned.as_person(ben):
        assert owned("GET", "/patients").status_code == 401  # the old cookie stays worthless
        assert owned.good("POST", "/auth/sign-in", json={"name": "Ben", "password": PASSWORD})["name"] == "Ben"
    assert [(row.person, row.what) for row in owned.log() if row.details.get("name") == "Ben"][-2:] == [
        ("Ada", "person disabled"),
        ("Ada", "person enabled"),
    ]


def test_somebody_disabled_by_another_program_is_out_within_five_seconds(owned: Clinic, ben: dict[str, str]) -> None:
    """The command line writes to the database only: the check of open sockets (every 2 s) notices it."""
    assert sockets.CHECK_EVERY <= 2.5  # an open socket ends within twice this time
    with owned.as_person(ben), owned.socket("/live") as socket:
        socket.receive_json()
        command = [sys.executable, "-c", "from app.cli.main import main; main()", "people", "disable", "Ben"]
        subprocess.run([*command, "--state", str(owned.settings.state)], check=True, capture_output=True)
        assert owned("GET", "/patients").status_code == 401
        assert closing(socket) == 4401


def test_the_last_owner_who_can_sign_in_stays_one(owned: Clinic) -> None:
    ada = id_of(owned, "Ada")
    invited(owned, "Eve", "owner")  # has no password yet: cannot sign in
    for method, path, body in (
        ("POST", f"/people/{ada}/disable", None),
        ("PUT", f"/people/{ada}", {"role": "clinician"}),
    ):
        assert "No other owner than" in owned.refused(409, method, path, json=body)
    accepted(owned, owned.good("POST", f"/people/{id_of(owned, 'Eve')}/link"))
    assert owned.good("PUT", f"/people/{ada}", json={"role": "clinician"})["role"] == "clinician"


def test_changed_rights_end_the_sign_ins(owned: Clinic, ben: dict[str, str]) -> None:
    person = id_of(owned, "Ben")
    assert owned.good("PUT", f"/people/{person}", json={"role": "clinician"})["role"] == "clinician"
    with owned.as_person(ben):
        assert owned("GET", "/patients").status_code == 200  # nothing has changed
    assert owned.good("PUT", f"/people/{person}", json={"role": "reviewer", "patients": []})["patients"] == []
    with owned.as_person(ben):
        assert owned("GET", "/patients").status_code == 401
    row = owned.log()[-1]
    assert (row.person, row.what) == ("Ada", "rights changed")
    assert row.details["now"] == {"role": "reviewer", "patients": []}


def test_the_own_password_needs_the_old_one_and_ends_the_other_sign_ins(owned: Clinic) -> None:
    here = dict(owned.client.cookies)
    with owned.as_person({}):
        owned.good("POST", "/auth/sign-in", json={"name": "Ada", "password": OWNER["password"]})
        elsewhere = dict(owned.client.cookies)
    wrong = owned.refused(401, "PUT", "/auth/password", json={"old": "nothing like it", "new": PASSWORD})
    assert wrong.startswith("That is not the password of Ada: ")
    owned.refused(422, "PUT", "/auth/password", json={"old": OWNER["password"], "new": "12345678"})
    assert owned("PUT", "/auth/password", json={"old": OWNER["password"], "new": PASSWORD}).status_code == 204
    with owned.as_person(elsewhere):
        assert owned("GET", "/patients").status_code == 401
    with owned.as_person(here):
        assert owned("GET", "/patients").status_code == 200
        owned.good("POST", "/auth/sign-out")
        assert owned("POST", "/auth/sign-in", json={"name": "Ada", "password": OWNER["password"]}).status_code == 401
        assert owned.good("POST", "/auth/sign-in", json={"name": "Ada", "password": PASSWORD})["name"] == "Ada"
