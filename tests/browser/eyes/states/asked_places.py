"""Questions, refusals and news: what a page shows after something was asked, went wrong, or takes its time."""

from typing import Any

from browser.eyes.eyes_clinic import EyesClinic
from browser.eyes.opening import (
    Open,
    answered,
    at,
    chosen,
    document,
    filled,
    named,
    opened,
    pressed,
    refusing,
    shows,
    start_with,
    steps,
    tapped,
)
from browser.eyes.states.chair_places import one_chair
from browser.eyes.states.session_places import session_record, trial_over, written_session
from playwright.sync_api import expect

PROBLEM = ".problem:not(:empty)"  # what a page says of a refusal
NOT_OF_ADA = "That is not the password of Ada."
NAMED_BY_AN_INCIDENT = "An incident names P-2: say why it is deleted all the same."
SET_FORWARD = (
    "The clock of this machine went on by 31 days for which it did not run: it was set forward, or the machine was "
    "off. Nothing is erased because of that: deleted patients, replaced files and old backups stay that much "
    "longer. Check date and time."
)


def of_every_kind(people: Any) -> Any:
    """Return the clinic's people, and one of each state that a person may have."""
    states = ("disabled", "invited")
    others = [{**people[-1], "id": 90 + i, "name": f"Person {i}", "state": state} for i, state in enumerate(states)]
    shown = [{**people[-1], "id": 95, "name": "Rita", "role": "reviewer", "state": "active", "patients": [1]}]
    return [*people, *others, *shown]


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


def with_backups(view: Any) -> Any:
    """Return the page's view with two backups, one of which failed, a course and two incidents."""

    def row(number: int, good: bool, words: str) -> Any:
        facts = {"files": 120, "bytes": 48_000_000, "encrypted": good, "with_keys": False, "in_folder": True}
        at = f"2026-03-0{number}T02:00:00+00:00"
        return {"at": at, "place": "daily", "name": f"bodydrive-{number}.zip", "good": good, "message": words, **facts}

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
    return {**view, **changes}


def never_answered(pattern: str) -> Open:
    """Return what lets requests wait for ever."""
    return lambda page, _: page.route(pattern, lambda _: None)


def unsaved_plan(page: Any, clinic: EyesClinic) -> None:
    """Change a plan, and go away from it without saving."""
    clinic.when_left.append(lambda: page.evaluate("() => localStorage.clear()"))
    steps(at("plans", "New plan"), shows(".sheet"))(page, clinic)
    title = page.get_by_label("Title", exact=True).first
    title.fill("The corridor of ward 3")
    title.press("Tab")
    page.get_by_role("link", name="All plans").click()
    expect(page.get_by_role("alertdialog")).to_be_visible()


def unsaved_plan_of_the_list(page: Any, clinic: EyesClinic) -> None:
    unsaved_plan(page, clinic)
    page.get_by_role("alertdialog").get_by_role("button").nth(1).click()
    expect(page.locator("main h1")).to_have_text("Floor plans")
    steps(tapped("New plan"), shows("role=alertdialog"))(page, clinic)


def start_of_another_session(page: Any, _clinic: EyesClinic) -> None:
    page.locator(".person").filter(has_text="P-2").get_by_role("button", name="Start session").click()


ASKED_PLACES: dict[str, Open] = {
    "lock, somebody else": steps(
        start_with(locked=True),
        refusing("**/auth/unlock", 401, NOT_OF_ADA),
        *(filled("Password of Ada", "not this one"), tapped("Unlock"), shows(f"text={NOT_OF_ADA}")),
        tapped("I am somebody else"),
    ),
    "set_up, refused": steps(
        start_with(signed_in=False, needs_setup=True),
        *(filled("Set-up code", "wrong"), filled("Name", "Ada"), filled("Password", "correct horse")),
        *(tapped("Set up and sign in"), shows(PROBLEM)),
    ),
    "invitation, old": steps(
        document("#invite=not-this-one"), shows(named("heading", "This invitation does not work"))
    ),
    "people, rights": at("people", "Change rights of Ben"),
    "people, invite a reviewer": steps(at("people", "Invite somebody"), chosen("Reviewer"), chosen("Chosen patients")),
    "people, of every kind": answered("/people", "people", of_every_kind),
    "settings, unpair": steps(
        lambda _, clinic: one_chair(clinic), at("settings", "Unpair Ward 3"), shows(named("group", "Unpair Ward 3"))
    ),
    "settings, wrong password": steps(
        at("settings"),
        *(filled("Your password until now", "wrong"), filled("Your new password", "correct horse battery staple")),
        *(pressed("Enter"), shows(f"form {PROBLEM}")),
    ),
    "drive, discard": steps(trial_over, tapped("Discard…"), chosen("Another reason")),
    "patients, reason": steps(
        at("patients"),
        refusing("**/api/v1/patients/2", 409, NAMED_BY_AN_INCIDENT),
        *(tapped("Delete P-2"), shows(f"text={NAMED_BY_AN_INCIDENT}")),
    ),
    "patients, open": opened("patients"),
    "patients, another session": steps(
        at("patients"), start_of_another_session, shows(named("button", "End it and start P-2"))
    ),
    "controls, suggesting": steps(at("controls", "Suggest for me"), shows(named("button", "Replace them"))),
    "session, refused": steps(
        session_record,
        refusing("**/goal", 503, "The disk is full."),
        lambda page, _: page.locator("textarea").first.fill("To get to the garden."),
        lambda page, _: page.locator("textarea").first.press("Tab"),
        *(pressed("Enter"), shows(".toast")),
    ),
    "session patient, withdrawn": withdrawn_consent,
    "log, changed": log_that_was_changed,
    "backup, made": steps(answered("/backups", "backup", with_backups), tapped("Lift the mark")),
    "backup, clock": steps(
        answered("/backups", "backup", lambda view: {**view, "clock": SET_FORWARD}), shows(f"text={SET_FORWARD}")
    ),
    "computer, measuring": steps(
        at("computer"), never_answered("**/computer/measurement"), tapped("Measure for"), shows("progress")
    ),
    "plans, unsaved": unsaved_plan,
    "plans, unsaved before": unsaved_plan_of_the_list,
    "share link, wrong PIN": steps(
        document(f"share.html#{'a' * 32}"), filled("PIN of this link", "0000"), tapped("Open"), shows(PROBLEM)
    ),
}
