"""No mix-up of patients: a change must name the session that its page shows, and it must be the open one."""

from typing import Any

import pytest
from api.fake_clinic import BASE, Clinic
from api.served_routes import CHANGING, contexts, filled, routes_of
from fastapi.routing import APIRoute

from app.api.live.live_picture import ClinicLive
from app.api.who_asks import READS
from app.refusals import Conflict
from app.session.open_session import SessionFlow
from app.session.page_session import PAGE_SESSION, PageSession

OTHER = "can no longer be sent"
UNNAMED = "does not name the session"


def without_session(clinic: Clinic) -> dict[str, str]:
    """Return the routes that are marked to be the same for every session, each with its reason."""
    return {
        f"{method} {context.path.removeprefix('/api/v1')}": context.endpoint.any_session
        for context in contexts(clinic.client.app, APIRoute)  # type: ignore[arg-type]
        for method in context.methods - READS
        if hasattr(context.endpoint, "any_session")
    }


def second_patient(clinic: Any) -> Any:
    """Open another patient's session on another screen; return the session that the first page still shows."""
    before = clinic.session
    clinic.begin_session("B-12")
    return before


def asked(clinic: Any, route: str, session: str | None) -> Any:
    method, path = route.split()
    headers = {"Origin": BASE} | ({} if session is None else {"Patient-Session": session})
    return clinic.client.request(method, f"/api/v1{filled(path, role='clinician')}", headers=headers)


def refusal(clinic: Any, name: str, route: str, session: str | None) -> str:
    """Return the words that refuse the session of a page; empty when the answer has neither of them."""
    answer = asked(clinic, route, session)
    if answer.status_code == 401:  # some routes end the sign-in
        clinic.client.cookies.update(clinic.cookies_of(name))
        answer = asked(clinic, route, session)
    words = {409: OTHER, 422: UNNAMED}.get(answer.status_code, "")
    return words if words in answer.text else ""


def test_every_changing_route_refuses_another_session_and_none_or_is_marked_with_its_reason(in_session: Any) -> None:
    name = in_session.good("GET", "/auth/me")["name"]
    before = second_patient(in_session)
    routes = routes_of(in_session, CHANGING)
    assert len(routes) >= 50
    reasons = without_session(in_session)
    assert all(reasons.values())
    refused = {route: [refusal(in_session, name, route, page) for page in (before, None)] for route in routes}
    assert {
        route: words
        for route, words in refused.items()
        if words != (["", ""] if route in reasons else [OTHER, UNNAMED])
    } == {}
    assert in_session.good("GET", "/session")["patient"]["code"] == "B-12"


def test_what_is_no_session_is_no_name_of_one_and_no_session_is_another_one(in_session: Any) -> None:
    name, before = in_session.good("GET", "/auth/me")["name"], second_patient(in_session)
    for words, pages in ((OTHER, (before, "none", "999999")), (UNNAMED, (None, "B-12", "0", "-1"))):
        refused = {page: refusal(in_session, name, "PUT /adaptation", page) for page in pages}
        assert refused == dict.fromkeys(pages, words)


def test_the_refusal_says_who_is_open_who_opened_it_when_and_whose_page_this_is(in_session: Any) -> None:
    before = second_patient(in_session)
    session = in_session.good("GET", "/session")["session"]
    stale = {"headers": {"Patient-Session": before}}
    sentence = in_session.refused(409, "PUT", "/adaptation", json={"mode": "suggest"}, **stale)
    assert sentence.startswith(f"B-12 was opened on another screen by {session['opened_by']} at ")
    assert "What this page shows belongs to P-1 and can no longer be sent" in sentence
    assert in_session.good("GET", "/adaptation")["mode"] == "off"
    in_session.good("DELETE", "/session")
    ended = in_session("POST", "/adaptation/propose", **stale).json()["detail"]
    assert "was ended on another screen, and no session is open now" in ended


def test_a_change_that_waited_while_the_session_changed_does_nothing(in_session: Any) -> None:
    """The check is repeated when the change is made: the request may have waited while session B was opened."""
    before = int(second_patient(in_session))

    async def late(what: str) -> None:
        PAGE_SESSION.set(PageSession(before))
        if what == "undisturbed":
            async with in_session.parts[SessionFlow].undisturbed():
                raise AssertionError("it was done")
        await in_session.parts[SessionFlow].needed_session()

    for what in ("undisturbed", "needed"):
        with pytest.raises(Conflict, match="B-12 was opened"):
            in_session.client.portal.call(late, what)


def test_the_dial_goes_down_from_any_page_and_up_from_the_right_one_only(in_session: Any) -> None:
    before = second_patient(in_session)
    stale = {"headers": {"Patient-Session": before}}
    assert in_session("POST", "/control/dial", json={"share": 0.5}, **stale).json() == {"share": 0.5}
    assert OTHER in in_session.refused(409, "POST", "/control/dial", json={"share": 0.9}, **stale)
    assert in_session("POST", "/control/dial", json={"share": 0.9}, headers={"Patient-Session": ""}).status_code == 422
    assert in_session.good("POST", "/control/dial", json={"share": 0.9}) == {"share": 0.9}
    assert in_session("POST", "/control/stop", **stale).status_code == 200


def test_the_live_picture_names_the_open_session(in_session: Any) -> None:
    picture = in_session.parts[ClinicLive]._picture
    assert picture().session == in_session.good("GET", "/session")["session"]["id"]
    before = second_patient(in_session)
    assert picture().session == in_session.good("GET", "/session")["session"]["id"] != int(before)
    in_session.good("DELETE", "/session")
    assert picture().session is None
