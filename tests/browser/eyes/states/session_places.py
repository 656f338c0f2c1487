"""The places of a session and its trials: while one is driven, when it is over, in review, and on record."""

from typing import Any

from browser.driving import drive_by_plan
from browser.eyes.eyes_clinic import EyesClinic
from browser.eyes.opening import Open, answered, go, leave, opened, tap
from playwright.sync_api import expect

from app.faults import Fault


def trial_runs(page: Any, clinic: EyesClinic) -> None:
    go(page, clinic, "drive")
    # This clinic has no 3D view: a message that says so would lie over the speed.
    page.route("**/api/v1/view/**", lambda route: route.fulfill(json={}))
    drive_by_plan(page)
    tap(page, "Start trial")
    expect(page.get_by_role("button", name="End trial").first).to_be_enabled(timeout=60_000)


def interface_test_runs(page: Any, clinic: EyesClinic) -> None:
    go(page, clinic, "interface_test")
    tap(page, "Start the test")
    expect(page.get_by_text("The first target comes in a moment")).to_be_visible()
    clinic.process.run_t = 3.5
    expect(page.get_by_text("Bring the dot into the target")).to_be_visible()


def interface_test_over(page: Any, clinic: EyesClinic) -> None:
    clinic.add_tests()
    opened("interface_test")(page, clinic)
    expect(page.get_by_role("heading", name="How demanding was it?")).to_be_visible()
    page.wait_for_timeout(1500)  # until the chart is drawn


def trial_stopped(page: Any, clinic: EyesClinic) -> None:
    trial_runs(page, clinic)
    clinic.fault(Fault.STOP_TABLET)
    expect(page.get_by_role("button", name="Continue")).to_be_visible()


def trial_over(page: Any, clinic: EyesClinic) -> None:
    go(page, clinic, f"drive/over/{clinic.trials[0]}")
    expect(page.locator("main h2").first).to_be_visible()


def attention(page: Any, clinic: EyesClinic) -> None:
    go(page, clinic, "attention")
    expect(page.get_by_text("worked out")).to_have_count(0)


def review(where: str) -> Open:
    """Return what opens a page of the review, when its charts are drawn."""

    def open_place(page: Any, clinic: EyesClinic) -> None:
        first, second = clinic.trials
        opened(f"review/1{where.format(first=first, second=second)}")(page, clinic)
        page.wait_for_timeout(1500)

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
    opened(f"review/1/trial/{clinic.trials[0]}")(page, clinic)
    tap(page, "Revise or withdraw your comment at 6.5 s")
    tap(page, "Comment on this moment")
    page.wait_for_timeout(1500)


def unread(page: Any, clinic: EyesClinic) -> None:
    clinic.add_comment(3.0, "Well turned.")
    review("")(page, clinic)
    expect(page.get_by_text("unread comment")).to_be_visible()


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
    opened(f"session/{written_session(clinic)}")(page, clinic)
    expect(page.get_by_role("button", name="Sign off")).to_be_visible()


def signed_session(page: Any, clinic: EyesClinic) -> None:
    session = written_session(clinic)
    clinic.good("POST", f"/sessions/{session}/sign-off")
    opened(f"session/{session}")(page, clinic)
    tap(page, "Unlock")
    expect(page.get_by_label("Why it is unlocked")).to_be_visible()


def signing_session(page: Any, clinic: EyesClinic) -> None:
    session_record(page, clinic)
    tap(page, "Sign off")
    expect(page.get_by_role("button", name="Yes, sign off")).to_be_visible()


def revised_note(page: Any, clinic: EyesClinic) -> None:
    session_record(page, clinic)
    tap(page, "Revise the note")
    expect(page.get_by_label("Text of the note")).to_be_visible()


def without_sharing(page: Any, clinic: EyesClinic) -> None:
    def withdrawn(found: Any) -> Any:
        none: dict[str, Any] = {"given": None, "history": []}
        return {**found, "consents": [{**one, **none} for one in found["consents"]]}

    answered("/patients/1/consents", "session/patient/1", withdrawn)(page, clinic)
    expect(page.get_by_text("A share link needs the patient's consent")).to_be_visible()


def archive_to_make(page: Any, clinic: EyesClinic) -> None:
    written_session(clinic)  # with the consent
    opened("session/patient/1")(page, clinic)
    page.get_by_label("Form").select_option("archive")
    expect(
        page.get_by_text("An owner of the other clinic imports").or_(page.get_by_text("end it first"))
    ).to_be_visible()


def choose_archive(page: Any) -> None:
    file = {"name": "letter.zip", "mimeType": "application/zip", "buffer": b"Dear colleague"}
    page.locator("input[type=file][accept^='.zip']").set_input_files(file)


def refused_archive(page: Any, clinic: EyesClinic) -> None:
    opened("patients")(page, clinic)
    choose_archive(page)
    expect(page.get_by_text("This is no archive")).to_be_visible()


def archive_under_way(page: Any, clinic: EyesClinic) -> None:
    course = {"step": "send", "done": 30_000_000, "total": 120_000_000}
    waiting: list[Any] = []  # the import goes on
    answers = {"GET": lambda route: route.fulfill(json=course), "POST": waiting.append}
    opened("patients")(page, clinic)
    page.route("**/api/v1/archives", lambda route: answers[route.request.method](route))
    choose_archive(page)
    expect(page.get_by_text("Sending: 30.0 MB of 120.0 MB")).to_be_visible()


def share_link(page: Any, clinic: EyesClinic) -> None:
    """Show a new link beside one that can be opened, and the ones that have ended."""
    session = written_session(clinic)
    revoke_links(clinic)
    clinic.good("POST", f"/sessions/{session}/shares", {"days": 3})
    opened("session/patient/1")(page, clinic)
    tap(page, "Make the link")
    expect(page.get_by_role("heading", name="shown this once")).to_be_focused()


def shared_records(page: Any, clinic: EyesClinic) -> None:
    """Open a share link, and what the page is for."""
    written_session(clinic)  # with the consent
    revoke_links(clinic)
    made = clinic.good("POST", "/patients/1/shares", {"days": 1})
    leave(page, clinic)
    page.goto(f"{clinic.address}/share.html#{made['url'].partition('#')[2]}")
    page.get_by_label("PIN of this link").fill(made["pin"])
    tap(page, "Open")
    expect(page.get_by_role("heading", name="Records of P-1")).to_be_focused()


def shared_help(page: Any, clinic: EyesClinic) -> None:
    shared_records(page, clinic)
    tap(page, "What is this page for?")
    expect(page.get_by_role("dialog")).to_be_visible()


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
    "session, sign off": signing_session,
    "session, signed": signed_session,
    "session, note": revised_note,
    "session patient": opened("session/patient/1"),
    "session, no sharing": without_sharing,
    "session, share link": share_link,
    "session compare": compared_sessions,
    "session story": opened("session/story/1"),
}
ARCHIVE_PLACES: dict[str, Open] = {
    "session, archive": archive_to_make,
    "patients, archive refused": refused_archive,
    "patients, archive under way": archive_under_way,
}
