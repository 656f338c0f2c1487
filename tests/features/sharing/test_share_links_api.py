"""A share link: consent, PIN, at most 14 days, revocable, in the log; and nothing of anybody else with its cookie."""

from concurrent.futures import ThreadPoolExecutor
from datetime import datetime, timedelta
from typing import Any

import pytest
from api.fake_clinic import BASE, Clinic
from api.served_routes import requested, table

from app.api.live.live_picture import ClinicLive
from app.api.sign_in.hashing import Hashing
from app.api.sign_in.sign_in_limits import SignInLimits
from app.clock import utc_now
from app.features.sharing.shared_page import WRONG
from app.features.sharing.tables import ShareLink
from app.news import News
from app.store.patients import start_session

SHARED = "/shared"


def made(clinic: Clinic, days: int = 14, session: str = "") -> Any:
    """Make a link to the course of the patient who is here, or to a session."""
    whose = f"/sessions/{session}" if session else f"/patients/{clinic.patient['id']}"
    return clinic.good("POST", f"{whose}/shares", json={"days": days})


def token_of(link: Any) -> str:
    return str(link["url"].partition("#")[2])


def opened(clinic: Clinic, link: Any, pin: str | None = None) -> Any:
    return clinic("POST", "/shared/open", json={"token": token_of(link), "pin": pin or link["pin"]})


def wrong_pin(link: Any) -> str:
    return "000000" if link["pin"] != "000000" else "111111"


def end_patience(clinic: Clinic) -> None:
    """Forget the tries from this address, so that the count of the link itself is what refuses."""
    limits = clinic.parts[SignInLimits]
    limits._codes._times.clear()


def test_without_consent_there_is_no_link_and_withdrawing_it_ends_one(consented: Clinic, trial: int) -> None:
    consent = f"/patients/{consented.patient['id']}/consents/sharing"
    link = made(consented)
    with consented.as_person({}):
        assert opened(consented, link).status_code == 204
        visit = dict(consented.client.cookies)
        assert consented.good("GET", SHARED)["is_course"]
    consented.good("DELETE", consent)
    refused = consented("POST", f"/patients/{consented.patient['id']}/shares", json={"days": 14})
    assert (refused.status_code, "has not consented to sharing" in refused.text) == (409, True)
    with consented.as_person(visit):
        assert consented("GET", SHARED).status_code == 401
        assert opened(consented, link).status_code == 401


def test_a_course_shows_story_and_figures_by_code_and_every_opening_is_logged(consented: Clinic, trial: int) -> None:
    consented.good("POST", f"/trials/{trial}/comments", json={"t": 1.0, "text": "Well turned."})
    link = made(consented)
    assert consented.patient["pseudonym"] not in link["url"]
    assert link["url"].startswith("http://127.0.0.1:8080/share.html#")
    assert link["message"].startswith("Only this machine can open the link")
    assert len(token_of(link)) >= 22
    with consented.as_person({}):
        assert consented("GET", SHARED).status_code == 401
        answer = opened(consented, link)
        assert "HttpOnly" in answer.headers["set-cookie"]
        assert "Path=/api/v1/shared" in answer.headers["set-cookie"]
        found = consented.good("GET", SHARED)
    assert consented.patient["pseudonym"] not in str(found)
    assert found["code"] == consented.patient["code"]
    (task,), trial_view = found["tasks"], consented.good("GET", f"/trials/{trial}")
    plan = consented.good("GET", f"/floorplans/{trial_view['floorplan']}")
    titles = {path["name"]: path["title"] for path in plan["paths"]}
    assert (task["path_name"], task["path_title"]) == (trial_view["path_name"], titles[trial_view["path_name"]])
    kinds = [event["kind"] for event in found["stories"][0]["events"]]
    assert kinds == sorted(kinds, key=lambda kind: kind == "comment")  # in time order: the comment came last
    assert {"begin", "calibration", "map", "trial", "comment"} <= set(kinds)
    whats = [(row.what, row.details.get("share")) for row in consented.log() if row.what.startswith("share")]
    (row,) = link["shares"]
    assert whats == [("share link made", row["id"]), ("share opened", row["id"]), ("share viewed", row["id"])]
    with consented.database.transaction() as db:
        stored = db.get_one(ShareLink, row["id"])
        assert token_of(link) not in (stored.token_hash, stored.pin_hash)
        assert link["pin"] != stored.pin_hash
        assert (stored.openings, stored.wrong_pins) == (1, 0)


def test_an_opening_and_a_wrong_pin_are_told_to_open_pages_with_their_time(
    consented: Clinic, monkeypatch: pytest.MonkeyPatch
) -> None:
    told: list[News] = []
    monkeypatch.setattr(consented.parts[ClinicLive], "notify", told.append)
    news = News(what="shares", patient=consented.patient["id"])
    link = made(consented)
    (row,) = link["shares"]
    assert (row["openings"], row["last_opened"], told) == (0, None, [news])
    before = utc_now()
    with consented.as_person({}):
        assert opened(consented, link, wrong_pin(link)).status_code == 401
        assert told == [news] * 2
        assert opened(consented, link).status_code == 204
    assert told == [news] * 3
    (row,) = consented.good("GET", f"/patients/{consented.patient['id']}/shares")["shares"]
    assert (row["openings"], row["wrong_pins"]) == (1, 1)
    assert before <= datetime.fromisoformat(row["last_opened"]) <= utc_now()
    consented.good("DELETE", f"/shares/{row['id']}")
    assert told == [news] * 4


def test_a_link_that_was_cut_is_refused_as_a_wrong_one(consented: Clinic) -> None:
    link = made(consented)
    cut = {"token": token_of(link)[:9], "pin": link["pin"]}
    with consented.as_person({}):
        assert consented.refused(401, "POST", "/shared/open", json=cut) == str(WRONG)


def test_a_link_to_a_session_shows_this_session_only(consented: Clinic, trial: int) -> None:
    link = made(consented, session=consented.session)
    with consented.database.transaction() as db:
        start_session(db, consented.patient["id"]).ended = None
    with consented.as_person({}):
        assert opened(consented, link).status_code == 204
        found = consented.good("GET", SHARED)
    assert [str(story["session_id"]) for story in found["stories"]] == [consented.session]
    assert not found["is_course"]


def test_five_wrong_pins_end_a_link_also_when_they_come_at_once(
    consented: Clinic, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Each is counted before it is hashed, so that parallel tries do not get more."""
    hashed = []
    hashing = consented.parts[Hashing]
    matches = hashing.matches

    async def counted(stored: str, pin: str) -> bool:
        hashed.append(pin)
        return bool(await matches(stored, pin))

    monkeypatch.setattr(hashing, "matches", counted)
    link = made(consented)
    with consented.as_person({}):
        with ThreadPoolExecutor(8) as pool:
            body = {"token": token_of(link), "pin": wrong_pin(link)}
            tries = pool.map(lambda _: consented("POST", "/shared/open", json=body).status_code, range(8))
            assert set(tries) <= {401, 429, 503}
        end_patience(consented)
        for _ in range(5):
            opened(consented, link, wrong_pin(link))
        end_patience(consented)
        assert opened(consented, link).status_code == 401  # the right one, too late
    assert len(hashed) == 5
    (row,) = consented.good("GET", f"/patients/{consented.patient['id']}/shares")["shares"]
    assert (row["state"], row["wrong_pins"], row["openings"]) == ("dead", 5, 0)


def test_a_revoked_link_and_one_that_is_over_show_nothing_also_in_an_open_browser(consented: Clinic) -> None:
    database = consented.database
    for end in ("revoked", "over"):
        link = made(consented, days=1)
        row = link["shares"][0]["id"]
        with consented.as_person({}):
            assert opened(consented, link).status_code == 204
            visit = dict(consented.client.cookies)
        if end == "revoked":
            consented.good("DELETE", f"/shares/{row}")
            assert consented("DELETE", f"/shares/{row}").status_code == 409
        else:
            with database.transaction() as db:
                db.get_one(ShareLink, row).expires = utc_now() - timedelta(seconds=1)
        with consented.as_person(visit):
            assert consented("GET", SHARED).status_code == 401
            assert opened(consented, link).status_code == 401
        assert consented.good("GET", f"/patients/{consented.patient['id']}/shares")["shares"][0]["state"] == end


def test_a_link_holds_for_fourteen_days_at_most(consented: Clinic) -> None:
    path = f"/patients/{consented.patient['id']}/shares"
    for days in (0, 15, 1.5, "14", True):
        assert consented("POST", path, json={"days": days}).status_code == 422, days


def test_the_cookie_of_a_link_opens_no_other_route(consented: Clinic, trial: int) -> None:
    consented.add_patient("OTHER-7")
    link = made(consented)
    with consented.as_person({}):
        assert opened(consented, link).status_code == 204
        token = consented.client.cookies["bodydrive_share"]
        assert "OTHER-7" not in consented.client.get(f"{BASE}/api/v1/shared").text
    rights = table(consented.client.app)  # type: ignore[arg-type]
    assert len(rights) > 100
    for name, right in rights.items():
        if not right:
            continue
        with consented.as_person({}):
            consented.client.cookies["bodydrive_share"] = token  # for every path, unlike a browser
            consented.client.cookies["bodydrive_sign_in"] = token
            answer = requested(consented, name)
        assert answer.status_code in {401, 404}, name
