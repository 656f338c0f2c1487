"""Limits of tries at passwords and codes; known browsers are not locked out by tries from elsewhere."""

import asyncio
from collections import Counter
from concurrent.futures import ThreadPoolExecutor
from typing import Any

import pytest
from api.fake_clinic import BASE, Clinic
from api.people_of_clinic import OWNER

from app.api.sign_in.hashing import MOST_AT_ONCE, Hashing
from app.api.sign_in.set_up import SetUp

RIGHT = OWNER["password"]
SIGN_IN = "/auth/sign-in"


@pytest.fixture
def signed_out(owned: Clinic) -> Clinic:
    """A clinic with an owner, and a browser without cookies."""
    owned.client.cookies.clear()
    return owned


def attempt(signed_out: Clinic, name: str, password: str) -> Any:
    """Try a password in an unknown browser."""
    body = {"name": name, "password": password}
    return signed_out.client.post(f"/api/v1{SIGN_IN}", json=body, headers={"Origin": BASE, "Cookie": ""})


def side_by_side(signed_out: Clinic, names: list[str]) -> Counter[int]:
    with ThreadPoolExecutor(len(names)) as browsers:
        answers = list(browsers.map(lambda name: attempt(signed_out, name, "wrong password"), names))
    return Counter(answer.status_code for answer in answers)


def test_of_sixty_wrong_passwords_side_by_side_five_are_looked_at(signed_out: Clinic) -> None:
    found = side_by_side(signed_out, ["Ada"] * 60)
    assert found[401] == 5
    assert found[401] + found[429] + found[503] == 60
    assert [row.what for row in signed_out.log()].count("sign-in refused") == 5


def test_of_sixty_names_from_one_address_ten_are_looked_at(signed_out: Clinic) -> None:
    found = side_by_side(signed_out, [f"name {i}" for i in range(60)])
    assert found[401] <= 10
    for i in range(20):  # those that found everybody busy did not count
        found += side_by_side(signed_out, [f"later name {i}"])
    assert found[401] == 10


def test_a_locked_name_is_told_how_long_to_wait_and_signs_in_where_it_did_before(signed_out: Clinic) -> None:
    signed_out.good("POST", SIGN_IN, json={"name": "Ada", "password": RIGHT})  # in this browser
    signed_out.client.cookies.delete("bodydrive_sign_in")
    for _ in range(5):
        assert attempt(signed_out, "Ada", "wrong password").status_code == 401
    locked = attempt(signed_out, "Ada", RIGHT)
    assert locked.status_code == 429
    seconds = locked.headers["retry-after"]
    assert 1 <= int(seconds) <= 60
    assert f"wait {seconds} seconds, or sign in where you have signed in before." in locked.json()["detail"]
    assert signed_out.good("POST", SIGN_IN, json={"name": "Ada", "password": RIGHT})["signed_in"]


def test_a_known_browser_has_five_tries_of_its_own(signed_out: Clinic) -> None:
    signed_out.good("POST", SIGN_IN, json={"name": "Ada", "password": RIGHT})
    for _ in range(5):
        attempt(signed_out, "Ada", "wrong password")
    statuses = [signed_out("POST", SIGN_IN, json={"name": "Ada", "password": "wrong"}).status_code for _ in range(6)]
    assert statuses == [401] * 5 + [429]
    assert signed_out("POST", SIGN_IN, json={"name": "Ada", "password": RIGHT}).status_code == 429


def test_somebody_elses_browser_and_an_invented_one_are_not_known(signed_out: Clinic) -> None:
    signed_out.good("POST", SIGN_IN, json={"name": "Ada", "password": RIGHT})
    (cookie,) = [cookie for cookie in signed_out.client.cookies.jar if cookie.name.startswith("bodydrive_browser_")]
    assert cookie.path == "/api/v1/auth"  # also for unlocking and for the own password
    assert cookie.has_nonstandard_attr("HttpOnly")
    for _ in range(5):
        attempt(signed_out, "Eve", "wrong password")
        attempt(signed_out, "Ada", "wrong password")
    for name, number, token in (("Eve", 2, cookie.value), ("Eve", 1, cookie.value), ("Ada", 1, "x" * 43)):
        headers = {"Origin": BASE, "Cookie": f"bodydrive_browser_{number}={token}"}
        body = {"name": name, "password": RIGHT}
        assert signed_out.client.post(f"/api/v1{SIGN_IN}", json=body, headers=headers).status_code == 429


def test_of_many_at_once_nobody_waits_and_no_try_is_lost(signed_out: Clinic, monkeypatch: pytest.MonkeyPatch) -> None:
    go_on = asyncio.Event()

    async def slowly(*_given: Any) -> bool:
        await go_on.wait()
        return False

    monkeypatch.setattr(Hashing, "matches", slowly)
    with ThreadPoolExecutor(MOST_AT_ONCE) as browsers:
        under_way = [browsers.submit(attempt, signed_out, f"name {i}", "wrong password") for i in range(MOST_AT_ONCE)]
        while signed_out.parts[Hashing]._free_slots:
            pass
        refused = [attempt(signed_out, "Ada", RIGHT) for _ in range(6)]
        assert {answer.status_code for answer in refused} == {503}
        assert refused[0].headers["retry-after"] == "2"
        assert "wait a few seconds" in refused[0].json()["detail"]
        signed_out.process.loop.call_soon_threadsafe(go_on.set)
        assert {answer.result().status_code for answer in under_way} == {401}
    monkeypatch.undo()
    assert attempt(signed_out, "Ada", RIGHT).status_code == 200


@pytest.mark.parametrize("path", ["/auth/setup", "/patient-screen/pair"])
def test_wrong_codes_are_counted_and_make_no_code_worthless(real: Clinic, path: str) -> None:
    body = {"code": "wrong"} | ({"name": "Ada", "password": RIGHT} if path == "/auth/setup" else {})
    statuses = [real("POST", path, json=body).status_code for _ in range(11)]
    assert statuses[:10] == [401 if path == "/auth/setup" else 409] * 10
    late = real("POST", path, json=body)
    assert late.status_code == 429
    assert f"wait {late.headers['retry-after']} seconds" in late.json()["detail"]
    assert real.parts[SetUp].opens(OWNER["code"])


def test_wrong_codes_of_a_demonstration_are_counted(clinic: Clinic) -> None:
    statuses = [clinic("POST", "/auth/demo", json={"code": "wrong"}).status_code for _ in range(11)]
    assert statuses == [401] * 10 + [429]
