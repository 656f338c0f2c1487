"""Phones as sensors: paired by a code, one socket for each, and only samples of bounded number and size pass."""

import time
from typing import Any

import pytest
from api.fake_clinic import Clinic
from starlette.websockets import WebSocketDisconnect

from app.api.live import page_samples, phone_socket
from app.messages import LONGEST_SAMPLE

SAMPLE = bytes(range(32))
COOKIE = "bodydrive_phone"
NOT_A_SAMPLE, TOO_MANY, ELSEWHERE, SIGNED_OUT = 1003, 1008, 4409, 4401
MOST = 6


def pair(clinic: Clinic) -> int:
    """Pair the browser of the clinic as a phone, and return its number."""
    code = clinic.good("POST", "/phones/pairing")["code"]
    number: int = clinic.good("POST", "/phones/pair", json={"code": code})["number"]
    return number


@pytest.fixture
def phone(signed_in: Clinic) -> Clinic:
    """A browser that is signed in, and phone 1 on the trunk as well."""
    assert pair(signed_in) == 1
    signed_in.good("PUT", "/equipment/shirt", json={"kind": "phones", "trunk": "1"})
    return signed_in


def passed_on(clinic: Clinic) -> list[dict[str, Any]]:
    return [fields for do, fields in list(clinic.process.told) if do == "sample"]


def until_passed_on(clinic: Clinic, count: int) -> list[dict[str, Any]]:
    while len(passed_on(clinic)) < count:
        time.sleep(0.001)
    return passed_on(clinic)


def closing(socket: Any) -> int:
    """Return the code with which a socket is closed."""
    while True:
        try:
            socket.receive_json()
        except WebSocketDisconnect as closed:
            return closed.code


def test_the_samples_of_a_phone_reach_the_control_process_under_its_number(phone: Clinic) -> None:
    with phone.socket("/phone") as socket:
        for i in range(3):
            socket.send_bytes(SAMPLE[i:])
        samples = until_passed_on(phone, 3)
    assert [bytes.fromhex(sample["message"]) for sample in samples] == [SAMPLE, SAMPLE[1:], SAMPLE[2:]]
    assert {sample["page"] for sample in samples} == {1}
    times = [sample["received"] for sample in samples]
    assert times == sorted(times)


def test_a_phone_is_told_its_number_and_where_it_is_in_its_own_language(phone: Clinic) -> None:
    with phone.socket("/phone?language=de") as socket:
        assert socket.receive_json() == {"number": 1, "wanted": True, "part": "Rumpf"}
        assert socket.receive_json()["number"] == 1  # again and again, so that the page knows that it is heard
    phone.good("PUT", "/equipment/shirt", json={"kind": "phones", "trunk": "2"})
    with phone.socket("/phone") as socket:
        assert socket.receive_json() == {"number": 1, "wanted": True, "part": None}


def test_another_shirt_wants_no_samples_and_the_phone_is_told(phone: Clinic) -> None:
    phone.good("PUT", "/equipment/shirt", json={"kind": "simulator"})
    with phone.socket("/phone") as socket:
        socket.send_bytes(SAMPLE)
        assert socket.receive_json() == {"number": 1, "wanted": False, "part": None}
    assert passed_on(phone) == []


@pytest.mark.parametrize("origin", [None, "http://evil.example"])
def test_another_origin_opens_no_socket(phone: Clinic, origin: str | None) -> None:
    with pytest.raises(WebSocketDisconnect), phone.socket("/phone", origin):
        pass


def test_a_browser_that_is_not_paired_opens_no_socket(phone: Clinic) -> None:
    phone.client.cookies.delete(COOKIE)
    with pytest.raises(WebSocketDisconnect), phone.socket("/phone"):
        pass


def test_a_phone_opens_nothing_else(phone: Clinic) -> None:
    phone.client.cookies.delete("bodydrive_sign_in")
    for path in ("/live", "/screen", "/patient/live", "/camera"):
        with pytest.raises(WebSocketDisconnect), phone.socket(path):
            pass
    for path in ("/equipment", "/session", "/phones"):
        assert phone("GET", path).status_code == 401
    assert phone.good("GET", "/phones/me") == {"number": 1}


@pytest.mark.parametrize("sample", [b"", bytes(LONGEST_SAMPLE + 1)], ids=len)
def test_what_is_too_short_or_too_long_closes_the_socket(phone: Clinic, sample: bytes) -> None:
    with phone.socket("/phone") as socket:
        socket.send_bytes(sample)
        assert closing(socket) == NOT_A_SAMPLE
    assert passed_on(phone) == []


def test_text_is_no_sample(phone: Clinic) -> None:
    with phone.socket("/phone") as socket:
        socket.send_text('{"stop": true}')
        assert closing(socket) == NOT_A_SAMPLE


def test_a_flood_closes_the_socket(phone: Clinic, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(phone_socket, "FLOOD", 20)
    monkeypatch.setattr(page_samples, "monotonic", lambda: 100.0)
    with phone.socket("/phone") as socket:
        for _ in range(21):
            socket.send_bytes(SAMPLE)
        assert closing(socket) == TOO_MANY
    assert len(until_passed_on(phone, 20)) == 20


def test_a_page_that_is_opened_once_more_takes_over(phone: Clinic) -> None:
    with phone.socket("/phone") as first, phone.socket("/phone") as second:
        assert closing(first) == ELSEWHERE
        second.send_bytes(SAMPLE)
        until_passed_on(phone, 1)


def test_the_clinician_sees_the_phones_and_unpairs_one(phone: Clinic) -> None:
    with phone.socket("/phone") as socket:
        socket.receive_json()
        (shown,) = phone.good("GET", "/phones")["phones"]
        assert (shown["number"], shown["connected"], shown["part"]) == (1, True, "Trunk")
        assert phone.good("DELETE", "/phones/1") == {"phones": []}
        assert closing(socket) == SIGNED_OUT
    assert phone.good("GET", "/phones/me") == {"number": None}
    assert phone("DELETE", "/phones/1").status_code == 404
    assert phone("DELETE", "/phones/9").status_code == 422
    rows = [(row.person, row.what, row.details) for row in phone.log() if row.what.startswith("phone")]
    assert rows == [
        ("Demo clinician", "phone paired", {"phone": 1}),
        ("Demo clinician", "phone unpaired", {"phone": 1}),
    ]


def test_a_code_pairs_one_phone_and_a_browser_keeps_its_number(signed_in: Clinic) -> None:
    code = signed_in.good("POST", "/phones/pairing")["code"]
    assert signed_in.good("POST", "/phones/pair", json={"code": code})["number"] == 1
    assert signed_in("POST", "/phones/pair", json={"code": code}).status_code == 409
    assert pair(signed_in) == 1
    for number in range(2, MOST + 1):
        signed_in.client.cookies.delete(COOKIE)
        assert pair(signed_in) == number
    signed_in.client.cookies.delete(COOKIE)
    offer = signed_in.good("POST", "/phones/pairing")
    assert "unpair one first" in signed_in.refused(409, "POST", "/phones/pair", json={"code": offer["code"]})
    signed_in.good("DELETE", "/phones/3")
    assert pair(signed_in) == 3


def test_the_link_opens_the_page_of_phones(signed_in: Clinic) -> None:
    offer = signed_in.good("POST", "/phones/pairing")
    assert offer["url"].endswith(f"phone.html#pair={offer['code']}")
    assert offer["qr"].startswith("<svg")


def test_a_wrong_code_pairs_nothing(clinic: Clinic) -> None:
    assert clinic("POST", "/phones/pair", json={"code": "WRONG123"}).status_code == 409
    assert clinic.good("GET", "/phones/me") == {"number": None}
    assert clinic("GET", "/phones").status_code == 401
