"""Who can sign in, and who cannot."""

from typing import Any

import pytest
from api.fake_clinic import BASE, Clinic
from api.people_of_clinic import OWNER, accepted, invited

from app.api.sign_in import set_up
from app.api.sign_in.hashing import Hashing
from app.clock import monotonic
from app.texts import LANGUAGES


def test_the_code_of_the_link_signs_in_as_often_as_it_is_opened(clinic: Any) -> None:
    nobody = {"signed_in": False, "locked": False, "name": None, "role": None, "introduced": False}
    program = {
        "demo": True,
        "needs_setup": False,
        "version": "0.2.0",
        "language": "en",
        "languages": list(LANGUAGES),
    }
    assert clinic.good("GET", "/auth/me") == nobody | program
    assert clinic("POST", "/auth/demo", json={"code": "another"}).status_code == 401
    for _ in range(2):
        me = clinic.good("POST", "/auth/demo", json={"code": "the-code-of-the-link"})
        assert (me["signed_in"], me["role"]) == (True, "owner")
        clinic.client.cookies.clear()


def test_the_cookie_is_not_for_scripts_nor_for_other_sites(clinic: Any) -> None:
    answer = clinic("POST", "/auth/demo", json={"code": "the-code-of-the-link"})
    cookie = answer.headers["set-cookie"]
    assert cookie.startswith("bodydrive_sign_in=")
    assert "HttpOnly" in cookie
    assert "SameSite=lax" in cookie
    assert len(answer.cookies["bodydrive_sign_in"]) >= 32


def test_after_sign_out_the_old_cookie_is_worthless(signed_in: Any) -> None:
    token = signed_in.client.cookies["bodydrive_sign_in"]
    assert signed_in.good("POST", "/auth/sign-out")["signed_in"] is False
    signed_in.client.cookies.clear()
    assert "sign in" in signed_in.refused(401, "GET", "/patients", headers={"Cookie": f"bodydrive_sign_in={token}"})


def test_the_set_up_code_makes_one_owner(real: Any) -> None:
    assert real.good("GET", "/auth/me")["needs_setup"] is True
    assert real("POST", "/auth/demo", json={"code": "x"}).status_code == 404
    assert real("POST", "/auth/setup", json={**OWNER, "code": "wrong"}).status_code == 401
    assert "choose another" in real.refused(422, "POST", "/auth/setup", json={**OWNER, "password": "password"})
    assert "at least 8" in real("POST", "/auth/setup", json={**OWNER, "password": "short"}).json()["detail"]
    assert real.good("POST", "/auth/setup", json=OWNER)["role"] == "owner"
    assert real.good("GET", "/auth/me")["needs_setup"] is False
    assert real("POST", "/auth/setup", json={**OWNER, "name": "Eve"}).status_code == 409


def test_the_set_up_code_lasts_half_an_hour(real: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    later = monotonic() + 1801
    monkeypatch.setattr(set_up, "monotonic", lambda: later)
    assert "restart" in real.refused(401, "POST", "/auth/setup", json=OWNER)


def test_a_wrong_password_and_an_unknown_name_are_told_alike(real: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    real.good("POST", "/auth/setup", json=OWNER)
    real.good("POST", "/auth/sign-out")
    checked: list[bool] = []  # whether there was a hash; each check is the work of one (test_hashing.py)
    matches = Hashing.matches

    async def noted(hashing: Hashing, stored: str | None, password: str) -> bool:
        checked.append(stored is not None)
        return await matches(hashing, stored, password)

    monkeypatch.setattr(Hashing, "matches", noted)
    wrong = real("POST", "/auth/sign-in", json={"name": "Ada", "password": "nothing like it"})
    unknown = real("POST", "/auth/sign-in", json={"name": "Eve", "password": "nothing like it"})
    assert checked == [True, False]
    assert (wrong.status_code, wrong.json()) == (unknown.status_code, unknown.json())
    assert wrong.status_code == 401
    assert real.good("POST", "/auth/sign-in", json={"name": "Ada", "password": OWNER["password"]})["name"] == "Ada"


def test_what_does_not_come_from_our_page_changes_nothing(signed_in: Any) -> None:
    for origin in (None, "http://evil.example", "http://127.0.0.1:9999", "null", "http://[broken"):
        headers = {} if origin is None else {"Origin": origin}
        answer = signed_in.client.post("/api/v1/patients", json={"code": "A", "pseudonym": "B"}, headers=headers)
        assert answer.status_code == 403, origin
    assert signed_in.good("GET", "/patients") == []


def test_a_program_without_an_origin_may_stop_and_a_page_of_another_site_may_not(clinic: Any) -> None:
    asked: list[tuple[dict[str, str], int]] = [
        ({}, 200),
        ({"Sec-Fetch-Site": "none"}, 200),
        ({"Sec-Fetch-Site": "same-origin"}, 200),
        ({"Sec-Fetch-Site": "cross-site"}, 403),
        ({"Sec-Fetch-Site": "same-site"}, 403),
        ({"Origin": "null"}, 403),
        ({"Origin": "https://elsewhere.example"}, 403),
    ]
    for headers, status in asked:
        assert clinic.client.post("/api/v1/control/stop", headers=headers).status_code == status, headers


def test_a_foreign_name_that_points_here_is_not_served(signed_in: Any) -> None:
    headers = {"Host": "evil.example:8080", "Origin": "http://evil.example:8080"}
    assert signed_in.client.get("/api/v1/patients", headers=headers).status_code == 421
    assert signed_in.client.post("/api/v1/control/stop", headers=headers).status_code == 421


def test_our_own_origin_is_the_address_that_was_asked(signed_in: Any) -> None:
    cookie = f"bodydrive_sign_in={signed_in.client.cookies['bodydrive_sign_in']}"
    headers = {"Host": "localhost:8080", "Origin": "http://localhost:8080", "Cookie": cookie}
    answer = signed_in.client.post("/api/v1/patients", json={"code": "A", "pseudonym": "B"}, headers=headers)
    assert answer.status_code == 201
    assert BASE.startswith("http://127")


def test_what_one_person_put_away_stays_away_for_this_person_only(owned: Clinic) -> None:
    ben = accepted(owned, invited(owned, "Ben", "reviewer"))
    assert owned.good("GET", "/start")["me"]["introduced"] is False
    assert owned("POST", "/auth/introduction").status_code == 204
    assert owned.good("GET", "/start")["me"]["introduced"] is True
    with owned.as_person(ben):
        assert owned.good("GET", "/auth/me")["introduced"] is False
    owned("POST", "/auth/sign-out")
    assert owned.good("GET", "/auth/me")["introduced"] is False  # nobody is signed in
