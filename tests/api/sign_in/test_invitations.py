"""Invitations: a link is valid once and for 24 hours, and only its hash is stored; a new password ends sign-ins."""

import hashlib
from dataclasses import replace
from datetime import timedelta
from typing import Any

import pytest
from api.fake_clinic import Clinic
from api.people_of_clinic import PASSWORD, accepted, code_of, invited

from app.clock import utc_now
from app.network import CertificateTrust, NetworkService
from app.settings import Settings
from app.store.access import invitations
from app.store.access.person_tables import Invitation


def test_whoever_opens_the_link_chooses_the_password_and_is_signed_in(owned: Clinic) -> None:
    link = invited(owned, "Ben", "clinician")
    assert link["qr"].startswith("<svg")
    assert (link["person"]["state"], link["person"]["role"]) == ("invited", "clinician")
    code = code_of(link)
    with owned.database.transaction() as db:
        (stored,) = db.query(Invitation).all()
        assert stored.code_hash == hashlib.sha256(code.encode()).hexdigest()
        assert stored.expires - stored.created == timedelta(hours=24)
    with owned.as_person({}):
        sign_in = {"name": "Ben", "password": PASSWORD}
        assert owned("POST", "/auth/sign-in", json=sign_in).status_code == 401  # there is no password yet
        about = owned.good("POST", "/auth/invitation", json={"code": code})
        assert about == {"name": "Ben", "role": "clinician", "is_new": True}
        refused = owned.refused(422, "POST", "/auth/invitation/accept", json={"code": code, "password": "password"})
        assert "choose another" in refused
        me = owned.good("POST", "/auth/invitation/accept", json={"code": code, "password": PASSWORD})
        assert (me["signed_in"], me["name"], me["role"]) == (True, "Ben", "clinician")
        again = {"code": code, "password": "another long one"}
        assert "was used" in owned.refused(401, "POST", "/auth/invitation/accept", json=again)
        owned.good("POST", "/auth/sign-out")
        assert owned.good("POST", "/auth/sign-in", json=sign_in)["name"] == "Ben"
    rows = [(row.person, row.what) for row in owned.log()]
    assert [what for who, what in rows if who == "Ada"][-2:] == ["person added", "invitation made"]
    assert ("Ben", "invitation accepted") in rows
    assert code not in str([row.details for row in owned.log()])


def test_a_link_holds_for_24_hours_and_the_newer_one_only(owned: Clinic, monkeypatch: pytest.MonkeyPatch) -> None:
    first = invited(owned, "Ben", "clinician")
    second = owned.good("POST", f"/people/{first['person']['id']}/link")
    assert owned("POST", "/auth/invitation", json={"code": code_of(first)}).status_code == 401
    assert owned("POST", "/auth/invitation", json={"code": code_of(second)}).status_code == 200
    later = utc_now() + timedelta(hours=24, seconds=1)
    monkeypatch.setattr(invitations, "utc_now", lambda: later)
    assert owned("POST", "/auth/invitation", json={"code": code_of(second)}).status_code == 401
    assert owned.good("GET", "/people")[1]["link_until"] is None


def test_wrong_codes_are_counted_by_address_before_they_are_looked_up(owned: Clinic) -> None:
    link = invited(owned, "Ben", "clinician")
    tried = [owned("POST", "/auth/invitation", json={"code": f"wrong-{n}"}).status_code for n in range(11)]
    assert tried == [401] * 10 + [429]
    answer = owned("POST", "/auth/invitation/accept", json={"code": code_of(link), "password": PASSWORD})
    assert answer.status_code == 429
    assert int(answer.headers["Retry-After"]) > 0


def test_a_new_password_by_a_link_ends_the_old_sign_ins(owned: Clinic) -> None:
    cookies = accepted(owned, invited(owned, "Ben", "clinician"))
    ben = owned.good("GET", "/people")[1]
    link = owned.good("POST", f"/people/{ben['id']}/link")
    with owned.as_person(cookies):
        assert owned.good("GET", "/auth/me")["name"] == "Ben"  # until the link is used
    accepted(owned, link, "another long password")
    with owned.as_person(cookies):
        assert owned.good("GET", "/auth/me")["signed_in"] is False
        assert owned("POST", "/auth/sign-in", json={"name": "Ben", "password": PASSWORD}).status_code == 401


def test_an_invitation_that_cannot_be_made_adds_nobody(owned: Clinic) -> None:
    bodies: list[tuple[dict[str, Any], int, str]] = [
        ({"name": "Ada", "role": "clinician"}, 409, "already somebody called"),
        ({"name": "Ben", "role": "clinician", "patients": [1]}, 409, "for reviewers only"),
        ({"name": "Ben", "role": "reviewer", "patients": [999]}, 404, "no patient 999"),
        ({"name": "Ben", "role": "king"}, 422, ""),
        ({"name": " ", "role": "owner"}, 422, ""),
    ]
    for body, status, words in bodies:
        assert words in owned.refused(status, "POST", "/people", json=body), body
    assert [person["name"] for person in owned.good("GET", "/people")] == ["Ada"]


def test_an_invitation_names_the_page_that_a_new_device_opens_first(owned: Clinic) -> None:
    now = utc_now()
    network = NetworkService(8443, 8081, CertificateTrust((), ("10.1.2.3",), now, now, "00", b"root"))
    owned.parts._by_class[Settings] = replace(owned.settings, network=network)
    link = invited(owned, "Ben", "clinician")
    assert link["url"].startswith("https://10.1.2.3:8443/#invite=")
    assert "http://10.1.2.3:8081/ first" in link["message"]
    network.trust = CertificateTrust((), ("10.1.2.3",), now, now, "00", None)  # a certificate of the clinic's own
    assert owned.good("POST", f"/people/{link['person']['id']}/link")["message"] == ""
