"""Questions, refusals and news: what a page shows after something was asked, went wrong, or takes its time."""

from typing import Any

from browser.eyes.eyes_clinic import EyesClinic
from browser.eyes.opening import Open, answered, at, go, leave, opened, start_with, tap
from browser.eyes.states.session_places import session_record, trial_over, written_session
from playwright.sync_api import expect


def somebody_else_at_the_lock(page: Any, clinic: EyesClinic) -> None:
    start_with(locked=True)(page, clinic)
    words = "That is not the password of Ada."
    page.route("**/auth/unlock", lambda route: route.fulfill(status=401, json={"detail": words}))
    page.get_by_label("Password of Ada").fill("not this one")
    tap(page, "Unlock")
    expect(page.get_by_text(words)).to_be_visible()
    tap(page, "I am somebody else")


def refused_set_up(page: Any, clinic: EyesClinic) -> None:
    start_with(signed_in=False, needs_setup=True)(page, clinic)
    for name, words in {"Set-up code": "wrong", "Name": "Ada", "Password": "correct horse"}.items():
        page.get_by_label(name).first.fill(words)
    tap(page, "Set up and sign in")
    expect(page.locator(".problem")).not_to_be_empty()


def old_invitation(page: Any, clinic: EyesClinic) -> None:
    leave(page, clinic)
    page.goto(f"{clinic.address}/#invite=not-this-one")
    expect(page.get_by_role("heading", name="This invitation does not work")).to_be_visible()


def rights(page: Any, clinic: EyesClinic) -> None:
    at("people", "Change rights of Ben")(page, clinic)


def invited_reviewer(page: Any, clinic: EyesClinic) -> None:
    at("people", "Invite somebody")(page, clinic)
    page.get_by_text("Reviewer", exact=True).click()
    page.get_by_text("Chosen patients", exact=True).first.click()


def disabled_person(page: Any, clinic: EyesClinic) -> None:
    def one_of_each(people: Any) -> Any:
        states = ("disabled", "invited")
        others = [{**people[-1], "id": 90 + i, "name": f"Person {i}", "state": state} for i, state in enumerate(states)]
        shown = [{**people[-1], "id": 95, "name": "Rita", "role": "reviewer", "state": "active", "patients": [1]}]
        return [*people, *others, *shown]

    answered("/people", "people", one_of_each)(page, clinic)


def unpairing(page: Any, clinic: EyesClinic) -> None:
    clinic.good("POST", "/chairs", {"name": "Ward 3", "host": "127.0.0.1", "port": 5354, "speeds": {}})
    at("settings", "Unpair Ward 3")(page, clinic)
    expect(page.get_by_role("group", name="Unpair Ward 3")).to_be_visible()


def refused_password(page: Any, clinic: EyesClinic) -> None:
    go(page, clinic, "settings")
    page.get_by_label("Your password until now").fill("wrong")
    page.get_by_label("Your new password").fill("correct horse battery staple")
    page.keyboard.press("Enter")
    expect(page.locator("form .problem").last).not_to_be_empty()


def discarding(page: Any, clinic: EyesClinic) -> None:
    trial_over(page, clinic)
    tap(page, "Discard…")
    page.get_by_text("Another reason").first.click()


def erasing_with_a_reason(page: Any, clinic: EyesClinic) -> None:
    go(page, clinic, "patients")
    words = "An incident names P-2: say why it is deleted all the same."
    page.route("**/api/v1/patients/2", lambda route: route.fulfill(status=409, json={"detail": words}))
    tap(page, "Delete P-2")
    expect(page.get_by_text(words)).to_be_visible()


def refused_goal(page: Any, clinic: EyesClinic) -> None:
    session_record(page, clinic)
    page.route("**/goal", lambda route: route.fulfill(status=503, json={"detail": "The disk is full."}))
    page.locator("textarea").first.fill("To get to the garden.")
    page.locator("textarea").first.press("Tab")
    page.keyboard.press("Enter")
    expect(page.locator(".toast")).to_be_visible()


def withdrawn_consent(page: Any, clinic: EyesClinic) -> None:
    written_session(clinic)
    clinic.good("DELETE", "/patients/1/consents/clinic_prior")
    clinic.good("PUT", "/patients/1/consents/clinic_prior", {"given": "2026-03-01"})
    clinic.good("DELETE", "/patients/1/consents/clinic_prior")
    opened("session/patient/1")(page, clinic)


def log_that_was_changed(page: Any, clinic: EyesClinic) -> None:
    finding = {"whole": False, "message": "Row 12 was changed: its hash does not fit."}
    answered("/log/check", "log", lambda _: finding)(page, clinic)
    page.get_by_label("Patient").select_option("P-2")
    expect(page.get_by_text("Row 12 was changed")).to_be_visible()


def backups_made(page: Any, clinic: EyesClinic) -> None:
    def row(number: int, good: bool, words: str) -> Any:
        facts = {"files": 120, "bytes": 48_000_000, "encrypted": good, "with_keys": False, "in_folder": True}
        name = f"bodydrive-{number}.zip"
        return {
            "at": f"2026-03-0{number}T02:00:00+00:00",
            "place": "daily",
            "name": name,
            "good": good,
            "message": words,
            **facts,
        }

    incident = {
        "id": 1, "made": "2026-03-02T10:00:00+00:00", "since": "2026-03-01T10:00:00+00:00", "hash": "ab12" * 16,
        "lifted": None, "reason": None, "patients": [1, 2],
    }  # fmt: skip
    changes = {
        "folder": "/mnt/stick",
        "warning": "The last two nights made no good backup: is the stick there?",
        "last_good": "2026-03-01T02:00:00+00:00",
        "made": [row(3, False, "The folder is not there."), row(2, True, "")],
        "course": {"step": "store", "done": 20_000_000, "total": 48_000_000},
        "incidents": [incident, {**incident, "id": 2, "lifted": incident["made"], "reason": "It was a drill."}],
        "fingerprint": "12:34:56:78",
    }
    answered("/backups", "backup", lambda view: {**view, **changes})(page, clinic)
    tap(page, "Lift the mark")


def measuring(page: Any, clinic: EyesClinic) -> None:
    go(page, clinic, "computer")
    waiting: list[Any] = []

    def wait(route: Any) -> None:
        waiting.append(route)

    page.route("**/computer/measurement", wait)
    tap(page, "Measure for")
    expect(page.locator("progress")).to_be_visible()


def unsaved_plan(page: Any, clinic: EyesClinic) -> None:
    """Change a plan, and go away from it without saving."""
    go(page, clinic, "plans")
    clinic.when_left.append(lambda: page.evaluate("() => localStorage.clear()"))
    tap(page, "New plan")
    expect(page.locator(".sheet")).to_be_visible()
    title = page.get_by_label("Title", exact=True).first
    title.fill("The corridor of ward 3")
    title.press("Tab")
    page.get_by_role("link", name="All plans").click()
    expect(page.get_by_role("alertdialog")).to_be_visible()


def unsaved_plan_of_the_list(page: Any, clinic: EyesClinic) -> None:
    unsaved_plan(page, clinic)
    page.get_by_role("alertdialog").get_by_role("button").nth(1).click()
    expect(page.locator("main h1")).to_have_text("Floor plans")
    tap(page, "New plan")
    expect(page.get_by_role("alertdialog")).to_be_visible()


def wrong_pin(page: Any, clinic: EyesClinic) -> None:
    leave(page, clinic)
    page.goto(f"{clinic.address}/share.html#{'a' * 32}")
    page.get_by_label("PIN of this link").fill("0000")
    tap(page, "Open")
    expect(page.locator(".problem")).not_to_be_empty()


def another_session(page: Any, clinic: EyesClinic) -> None:
    go(page, clinic, "patients")
    page.locator(".person").filter(has_text="P-2").get_by_role("button", name="Start session").click()
    expect(page.get_by_role("button", name="End it and start P-2")).to_be_visible()


def suggesting(page: Any, clinic: EyesClinic) -> None:
    at("controls", "Suggest for me")(page, clinic)
    expect(page.get_by_role("button", name="Replace them")).to_be_visible()


def clock_set_forward(page: Any, clinic: EyesClinic) -> None:
    words = (
        "The clock of this machine went on by 31 days for which it did not run: it was set forward, or the machine was "
        "off. Nothing is erased because of that: deleted patients, replaced files and old backups stay that much "
        "longer. Check date and time."
    )
    answered("/backups", "backup", lambda view: {**view, "clock": words})(page, clinic)
    expect(page.get_by_text(words)).to_be_visible()


ASKED_PLACES: dict[str, Open] = {
    "lock, somebody else": somebody_else_at_the_lock,
    "set_up, refused": refused_set_up,
    "invitation, old": old_invitation,
    "people, rights": rights,
    "people, invite a reviewer": invited_reviewer,
    "people, of every kind": disabled_person,
    "settings, unpair": unpairing,
    "settings, wrong password": refused_password,
    "drive, discard": discarding,
    "patients, reason": erasing_with_a_reason,
    "patients, open": opened("patients"),
    "patients, another session": another_session,
    "controls, suggesting": suggesting,
    "session, refused": refused_goal,
    "session patient, withdrawn": withdrawn_consent,
    "log, changed": log_that_was_changed,
    "backup, made": backups_made,
    "backup, clock": clock_set_forward,
    "computer, measuring": measuring,
    "plans, unsaved": unsaved_plan,
    "plans, unsaved before": unsaved_plan_of_the_list,
    "share link, wrong PIN": wrong_pin,
}
