"""The one answer with which a page starts: the same as the three that it stands for."""

from typing import Any


def parts(clinic: Any) -> dict[str, Any]:
    return {
        "me": clinic.good("GET", "/auth/me"),
        "is_nearby": True,
        "practice": clinic.good("GET", "/equipment/practice")["kind"],
        "session": clinic.good("GET", "/session"),
    }


def test_nobody_is_told_who_is_here(clinic: Any) -> None:
    start = clinic.good("GET", "/start")
    assert (start["me"], start["session"]) == (clinic.good("GET", "/auth/me"), None)


def test_who_is_signed_in_gets_the_open_session(in_session: Any) -> None:
    start = in_session.good("GET", "/start")
    assert start == parts(in_session)
    assert start["me"]["signed_in"]
    assert start["session"]["patient"] is not None


def test_without_a_session_nobody_is_here(signed_in: Any) -> None:
    start = signed_in.good("GET", "/start")
    assert start == parts(signed_in)
    assert start["session"]["patient"] is None


def test_who_comes_through_a_proxy_is_not_nearby(signed_in: Any) -> None:
    assert signed_in.client.get("/api/v1/start", headers={"Via": "1.1 proxy"}).json()["is_nearby"] is False
