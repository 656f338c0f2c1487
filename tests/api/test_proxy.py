"""Behind a proxy: its forwarded headers stand for the browser; anything else is refused in one sentence."""

import shutil
from collections.abc import Iterator
from dataclasses import replace
from ipaddress import ip_network
from pathlib import Path
from typing import Any

import pytest
from api.fake_clinic import Clinic
from api.running_app import running
from hypothesis import given
from hypothesis import strategies as st
from starlette.requests import HTTPConnection
from starlette.websockets import WebSocketDisconnect

from app.api.guard import NOT_OUR_PAGE, NOT_OURS
from app.api.nearby import is_nearby
from app.api.own_address import own_address
from app.api.proxy import INCOMPLETE, NOT_ENCRYPTED, NOT_THE_PROXY, ForwardingError, forwarded
from app.settings import Settings
from app.texts import Text

NAME = "clinic.example.org:8443"
PROXY = ip_network("127.0.0.1")
HEADERS = {"X-Forwarded-For": "10.4.0.17", "X-Forwarded-Proto": "https", "X-Forwarded-Host": NAME}
PAGE = {**HEADERS, "Origin": f"https://{NAME}", "Patient-Session": "none"}
CODE = {"code": "the-code-of-the-link"}


def scope_of(sender: Any, headers: list[tuple[str, str]], kind: str = "http") -> dict[str, Any]:
    encoded = [(name.lower().encode(), value.encode("latin-1")) for name, value in headers]
    return {"type": kind, "scheme": "http", "client": sender, "headers": [(b"host", b"127.0.0.1:8080"), *encoded]}


def without(name: str) -> list[tuple[str, str]]:
    return [(other, value) for other, value in HEADERS.items() if other != name]


@pytest.mark.parametrize("kind", ["http", "websocket"])
@pytest.mark.parametrize("sender", ["127.0.0.1", "::ffff:127.0.0.1"])
def test_client_scheme_and_host_are_those_that_the_proxy_reports(kind: str, sender: str) -> None:
    before = scope_of((sender, 5), list(HEADERS.items()), kind)
    after = forwarded(before, PROXY)
    assert after["client"] == ("10.4.0.17", 0)
    assert after["scheme"] == {"http": "https", "websocket": "wss"}[kind]
    assert (b"host", NAME.encode()) in after["headers"]
    assert before == scope_of((sender, 5), list(HEADERS.items()), kind)


def test_of_several_addresses_the_one_that_the_proxy_added_counts() -> None:
    chain = [("X-Forwarded-For", "6.6.6.6, 7.7.7.7"), *HEADERS.items()]
    assert forwarded(scope_of(("127.0.0.1", 5), chain), PROXY)["client"][0] == "10.4.0.17"
    joined = [*without("X-Forwarded-For"), ("X-Forwarded-For", "6.6.6.6, 10.4.0.18")]
    assert forwarded(scope_of(("127.0.0.1", 5), joined), PROXY)["client"][0] == "10.4.0.18"


@pytest.mark.parametrize(
    ("sender", "headers", "sentence"),
    [
        (("127.0.0.2", 5), list(HEADERS.items()), NOT_THE_PROXY),
        (("127.0.0.2", 5), [], NOT_THE_PROXY),
        (None, list(HEADERS.items()), NOT_THE_PROXY),
        *((("127.0.0.1", 5), without(name), INCOMPLETE) for name in HEADERS),
        *((("127.0.0.1", 5), [*HEADERS.items(), (name, HEADERS[name])], INCOMPLETE) for name in list(HEADERS)[1:]),
        (("127.0.0.1", 5), [*without("X-Forwarded-For"), ("X-Forwarded-For", "unknown")], INCOMPLETE),
        (("127.0.0.1", 5), [*without("X-Forwarded-Proto"), ("X-Forwarded-Proto", "http")], NOT_ENCRYPTED),
    ],
)
def test_anything_else_is_refused_in_a_sentence(sender: tuple[str, int] | None, headers: Any, sentence: Text) -> None:
    with pytest.raises(ForwardingError) as refused:
        forwarded(scope_of(sender, headers), PROXY)
    assert str(refused.value) == str(sentence)


LATIN = st.text(st.characters(max_codepoint=255))


@given(
    st.lists(st.tuples(st.sampled_from(list(HEADERS)), LATIN), max_size=5), st.sampled_from(["127.0.0.1", "1.1.1.1"])
)
def test_no_headers_break_it_and_none_from_elsewhere_are_believed(headers: Any, sender: str) -> None:
    try:
        after = forwarded(scope_of((sender, 5), headers), PROXY)
    except ForwardingError:
        return
    assert (sender, after["scheme"]) == ("127.0.0.1", "https")


@pytest.fixture
def behind(settings: Settings, new_state: Path) -> Iterator[Clinic]:
    shutil.copytree(new_state, settings.state)
    yield from running(replace(settings, proxy=PROXY, public_name=NAME))


PATHS = ("/", "/api/v1/equipment/practice", "/api/v1/patients")


def test_over_https_a_browser_is_told_to_come_by_https_again(behind: Clinic) -> None:
    told = [behind.client.get(path, headers=HEADERS).headers.get("strict-transport-security") for path in PATHS]
    assert told == ["max-age=2592000"] * len(PATHS)


def test_over_http_a_browser_is_told_nothing_of_https(clinic: Clinic) -> None:
    assert not any("strict-transport-security" in clinic.client.get(path).headers for path in PATHS)


def test_a_page_signs_in_by_the_name_of_the_proxy(behind: Clinic) -> None:
    def enter(**changed: str) -> Any:
        return behind.client.post("/api/v1/auth/demo", json=CODE, headers={**PAGE, **changed})

    answer = enter()
    assert (answer.status_code, answer.json()["signed_in"]) == (200, True), answer.text
    assert "; Secure" in answer.headers["set-cookie"]
    assert f"wss://{NAME}" in answer.headers["content-security-policy"]
    # another name that resolves to the proxy (DNS rebinding), and another page
    foreign = enter(**{"X-Forwarded-Host": "evil.example", "Origin": "https://evil.example"})
    assert (foreign.status_code, foreign.json()["detail"]) == (421, str(NOT_OURS))
    other = enter(Origin="http://127.0.0.1:8080")
    assert (other.status_code, other.json()["detail"]) == (403, str(NOT_OUR_PAGE))


def test_wrong_codes_are_counted_by_the_browser_s_address(behind: Clinic) -> None:
    def attempt(address: str) -> int:
        headers = {**PAGE, "X-Forwarded-For": address}
        return int(behind.client.post("/api/v1/auth/demo", json={"code": "wrong"}, headers=headers).status_code)

    assert [attempt("10.4.0.17") for _ in range(11)] == [*[401] * 10, 429]
    assert attempt("10.4.0.18") == 401


def test_no_page_is_served_past_the_proxy_and_the_answer_has_its_headers(behind: Clinic) -> None:
    for path in ("/", "/api/v1/auth/me"):
        answer = behind.client.get(path)
        assert (answer.status_code, answer.json()["detail"]) == (403, str(INCOMPLETE))
        assert answer.headers["x-content-type-options"] == "nosniff"


def test_sockets_open_through_the_proxy_only(behind: Clinic) -> None:
    token = behind.client.post("/api/v1/auth/demo", json=CODE, headers=PAGE).cookies["__Host-bodydrive_sign_in"]
    cookie = {"Cookie": f"__Host-bodydrive_sign_in={token}"}
    url = "ws://127.0.0.1:8080/api/v1/live"
    with behind.client.websocket_connect(url, headers={**PAGE, **cookie}) as socket:
        assert "control" in socket.receive_json()
    for headers in ({"Origin": "http://127.0.0.1:8080"}, {**PAGE, "X-Forwarded-Host": "evil.example"}):
        with pytest.raises(WebSocketDisconnect), behind.client.websocket_connect(url, headers={**headers, **cookie}):
            pass


def test_a_real_chair_is_not_armed_through_a_proxy_and_another_screen_gets_the_proxy_s_address(behind: Clinic) -> None:
    asked = HTTPConnection(forwarded(scope_of(("127.0.0.1", 5), list(HEADERS.items())), PROXY))
    assert not is_nearby(asked)
    assert own_address(behind.settings, asked) == (f"https://{NAME}/", False)


def test_without_a_proxy_in_the_settings_the_headers_change_nothing(clinic: Clinic) -> None:
    answer = clinic("POST", "/auth/demo", json=CODE, headers=HEADERS)
    assert answer.json()["signed_in"]
    assert "Secure" not in answer.headers["set-cookie"]
    assert clinic("GET", "/auth/me", headers={**HEADERS, "Host": "clinic.example.org"}).status_code == 421
