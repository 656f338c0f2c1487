"""What a page reads first: one answer in place of three, and the reference, also before anybody has signed in."""

from typing import Any

from app.scoring.measures import TEST_MEASURES, TRIAL_MEASURES


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


def test_each_measure_is_served_as_the_catalogue_has_it_in_its_order(clinic: Any) -> None:
    measures = clinic.good("GET", "/reference")["measures"]
    assert list(measures["trial"]) == list(TRIAL_MEASURES)
    assert list(measures["test"]) == list(TEST_MEASURES)
    area = measures["trial"]["e_diff"]
    assert (area["name"], area["unit"], area["ucum"], area["digits"]) == ("Area off the path", "m²", "m2", 2)
    assert (area["better"], area["needs_goal"], area["of_whole"], area["of"]) == ("low", True, True, None)
    assert measures["leading"][-1] == {"has": [], "names": ["e_diff", "dist", "time"]}
