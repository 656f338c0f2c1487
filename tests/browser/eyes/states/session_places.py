"""The places of a session and its trials: while one is driven, when it is over, in review, and on record."""

from typing import Any

from browser.driving import drive_by_plan
from browser.eyes.eyes_clinic import EyesClinic
from browser.eyes.opening import (
    Open,
    answered,
    at,
    document,
    filled,
    go,
    named,
    opened,
    pauses,
    shows,
    steps,
    tap,
    tapped,
)
from playwright.sync_api import expect

from app.faults import Fault

CHARTS_ARE_DRAWN = 1500  # ms


def trial_runs(page: Any, clinic: EyesClinic) -> None:
    go(page, clinic, "drive")
    # This clinic has no 3D view: a message that says so would lie over the speed.
    page.route("**/api/v1/view/**", lambda route: route.fulfill(json={}))
    drive_by_plan(page)
    tap(page, "Start trial")
    expect(page.get_by_role("button", name="End trial").first).to_be_enabled(timeout=60_000)


def interface_test_runs(page: Any, clinic: EyesClinic) -> None:
    steps(at("interface_test", "Start the test"), shows("text=The first target comes in a moment"))(page, clinic)
    clinic.process.run_t = 3.5
    expect(page.get_by_text("Bring the dot into the target")).to_be_visible()


interface_test_over = steps(
    *(lambda _, clinic: clinic.add_tests(), opened("interface_test")),
    *(shows("text=How demanding was it?"), pauses(CHARTS_ARE_DRAWN)),
)
trial_stopped = steps(trial_runs, lambda _, clinic: clinic.fault(Fault.STOP_TABLET), shows(named("button", "Continue")))


def trial_over(page: Any, clinic: EyesClinic) -> None:
    steps(at(f"drive/over/{clinic.trials[0]}"), shows("main h2"))(page, clinic)


def attention(page: Any, clinic: EyesClinic) -> None:
    go(page, clinic, "attention")
    expect(page.get_by_text("worked out")).to_have_count(0)


def review(where: str) -> Open:
    """Return what opens a page of the review, when its charts are drawn."""

    def open_place(page: Any, clinic: EyesClinic) -> None:
        first, second = clinic.trials
        steps(opened(f"review/1{where.format(first=first, second=second)}"), pauses(CHARTS_ARE_DRAWN))(page, clinic)

    return open_place


def commented(page: Any, clinic: EyesClinic) -> None:
    """Show a trial with comments of two people, one of which is being revised."""
    where = f"/trials/{clinic.trials[0]}/comments"
    if not any(one["is_own"] for one in clinic.good("GET", where)):
        clinic.good("POST", where, {"t": 6.5, "text": "The turn begins late here, as in the last session."})
        made = clinic.good("POST", where, {"t": 12.0, "text": "A pause."})
        comment = next(one["id"] for one in made if one["t"] == 12.0)
        clinic.good("PUT", f"/comments/{comment}", {"text": "A pause of three seconds: was it meant?"})
    clinic.add_comment(14.5, "He was asked to stop, so the stop is not his.")
    steps(
        opened(f"review/1/trial/{clinic.trials[0]}"),
        *(tapped("Revise or withdraw your comment at 6.5 s"), tapped("Comment on this moment")),
        pauses(CHARTS_ARE_DRAWN),
    )(page, clinic)


def written_session(clinic: EyesClinic) -> int:
    """Return the first session of a patient, in which trials were driven and something of everything is written."""
    session = int(clinic.good("GET", "/patients/1/sessions")[-1]["id"])
    where = f"/sessions/{session}"
    if clinic.good("GET", where)["sign_off"]:
        clinic.good("POST", f"{where}/unlock", {"reason": "a look at the page"})
    if not clinic.good("GET", where)["notes"]:
        clinic.good("PUT", f"{where}/goal", {"goal": "To get from my bed to the kitchen table by myself."})
        note = clinic.good("POST", f"{where}/notes", {"text": "Calm."})["notes"][0]["id"]
        clinic.good("PUT", f"{where}/notes/{note}", {"text": "Calm, and tired after the second trial."})
        clinic.good("POST", f"{where}/scales", {"name": "SCIM III", "total": 41.0, "day": "2026-03-01"})
        for consent in ("recording", "sharing"):
            clinic.good("PUT", f"/patients/1/consents/{consent}", {"given": "2026-03-01"})
    return session


def session_record(page: Any, clinic: EyesClinic) -> None:
    steps(opened(f"session/{written_session(clinic)}"), shows(named("button", "Sign off")))(page, clinic)


def signed_session(page: Any, clinic: EyesClinic) -> None:
    session = written_session(clinic)
    clinic.good("POST", f"/sessions/{session}/sign-off")
    steps(opened(f"session/{session}"), tapped("Unlock"), shows("label:has-text('Why it is unlocked')"))(page, clinic)


def without_consents(found: Any) -> Any:
    none: dict[str, Any] = {"given": None, "history": []}
    return {**found, "consents": [{**one, **none} for one in found["consents"]]}


def choose_archive_form(page: Any, _clinic: EyesClinic) -> None:
    page.get_by_label("Form").select_option("archive")
    ready, open_session = page.get_by_text("An owner of the other clinic imports"), page.get_by_text("end it first")
    expect(ready.or_(open_session)).to_be_visible()


def choose_archive(page: Any, _clinic: EyesClinic) -> None:
    file = {"name": "letter.zip", "mimeType": "application/zip", "buffer": b"Dear colleague"}
    page.locator("input[type=file][accept^='.zip']").set_input_files(file)


def slow_import(page: Any, _clinic: EyesClinic) -> None:
    """Let an import go on for ever."""
    course = {"step": "send", "done": 30_000_000, "total": 120_000_000}
    waiting: list[Any] = []
    answers = {"GET": lambda route: route.fulfill(json=course), "POST": waiting.append}
    page.route("**/api/v1/archives", lambda route: answers[route.request.method](route))


def share_link(page: Any, clinic: EyesClinic) -> None:
    """Show a new link beside one that can be opened, and the ones that have ended."""
    session = written_session(clinic)
    revoke_links(clinic)
    clinic.good("POST", f"/sessions/{session}/shares", {"days": 3})
    steps(opened("session/patient/1"), tapped("Make the link"))(page, clinic)
    expect(page.get_by_role("heading", name="shown this once")).to_be_focused()


def shared_records(page: Any, clinic: EyesClinic) -> None:
    """Open a share link, and what the page is for."""
    written_session(clinic)  # with the consent
    revoke_links(clinic)
    made = clinic.good("POST", "/patients/1/shares", {"days": 1})
    address = document(f"share.html#{made['url'].partition('#')[2]}")
    steps(address, filled("PIN of this link", made["pin"]), tapped("Open"))(page, clinic)
    expect(page.get_by_role("heading", name="Records of P-1")).to_be_focused()


def revoke_links(clinic: EyesClinic) -> None:
    """Leave no share link that can be opened."""
    for link in clinic.good("GET", "/patients/1/shares")["shares"]:
        if link["state"] == "open":
            clinic.good("DELETE", f"/shares/{link['id']}")


def compared_sessions(page: Any, clinic: EyesClinic) -> None:
    first, second = [one["id"] for one in clinic.good("GET", "/patients/1/sessions")[::-1][:2]]
    opened(f"session/compare/{first}/{second}")(page, clinic)


SESSION_PLACES: dict[str, Open] = {
    "session": session_record,
    "session, sign off": steps(session_record, tapped("Sign off"), shows(named("button", "Yes, sign off"))),
    "session, signed": signed_session,
    "session, note": steps(session_record, tapped("Revise the note"), shows("label:has-text('Text of the note')")),
    "session patient": opened("session/patient/1"),
    "session, no sharing": steps(
        answered("/patients/1/consents", "session/patient/1", without_consents),
        shows("text=A share link needs the patient's consent"),
    ),
    "session, share link": share_link,
    "session compare": compared_sessions,
    "session story": opened("session/story/1"),
}
ARCHIVE_PLACES: dict[str, Open] = {
    "session, archive": steps(
        lambda _, clinic: written_session(clinic),  # with the consent
        *(opened("session/patient/1"), choose_archive_form),
    ),
    "patients, archive refused": steps(opened("patients"), choose_archive, shows("text=This is no archive")),
    "patients, archive under way": steps(
        *(opened("patients"), slow_import, choose_archive, shows("text=Sending: 30.0 MB of 120.0 MB"))
    ),
}
