"""Pages as people of another role than the owner meet them: what they may do, and what they are refused."""

import re
from typing import Any

from browser.eyes.eyes_clinic import EyesClinic
from browser.eyes.opening import Open, at, leave, opened, tap
from browser.eyes.states.session_places import review, session_record, written_session
from playwright.sync_api import expect


def as_a(role: str, open_place: Open) -> Open:
    """Return what opens a place for somebody of this role."""

    def open_as(page: Any, clinic: EyesClinic) -> None:
        leave(page, clinic)
        clinic.visit(page, role)
        open_place(page, clinic)

    return open_as


def read_session(page: Any, clinic: EyesClinic) -> None:
    opened(f"session/{written_session(clinic)}")(page, clinic)
    expect(page.get_by_text("To get from my bed")).to_be_visible()


def signed_for_a_clinician(page: Any, clinic: EyesClinic) -> None:
    session = written_session(clinic)
    clinic.good("POST", f"/sessions/{session}/sign-off")
    opened(f"session/{session}")(page, clinic)
    expect(page.get_by_text("signed off").first).to_be_visible()


def refused(where: str) -> Open:
    """Return what opens a page that this role may not see."""

    def open_place(page: Any, clinic: EyesClinic) -> None:
        at(where)(page, clinic)
        expect(page.locator("main").get_by_role("link", name=re.compile("^Go to “"))).to_be_visible()

    return open_place


def commenting(page: Any, clinic: EyesClinic) -> None:
    review("/trial/{first}")(page, clinic)
    tap(page, "Comment on this moment")


ROLE_PLACES: dict[str, Open] = {
    "patients, clinician": as_a("clinician", opened("patients")),
    "session, clinician": as_a("clinician", session_record),
    "session, signed, clinician": as_a("clinician", signed_for_a_clinician),
    "settings, clinician": as_a("clinician", at("settings")),
    "people, clinician": as_a("clinician", refused("people")),
    "log, clinician": as_a("clinician", refused("log")),
    "computer, clinician": as_a("clinician", refused("computer")),
    "backup, clinician": as_a("clinician", refused("backup")),
    "patients, reviewer": as_a("reviewer", opened("patients")),
    "attention, reviewer": as_a("reviewer", at("attention")),
    "review, reviewer": as_a("reviewer", review("")),
    "review trial, reviewer": as_a("reviewer", commenting),
    "session, reviewer": as_a("reviewer", read_session),
    "session patient, reviewer": as_a("reviewer", opened("session/patient/1")),
    "drive, reviewer": as_a("reviewer", at("drive")),
    "drive tasks, reviewer": as_a("reviewer", at("drive/tasks")),
    "controls, reviewer": as_a("reviewer", opened("controls")),
    "calibrate, reviewer": as_a("reviewer", opened("calibrate")),
    "adapt, reviewer": as_a("reviewer", opened("adapt")),
    "shirt, reviewer": as_a("reviewer", opened("shirt")),
    "plans, reviewer": as_a("reviewer", opened("plans")),
    "settings, reviewer": as_a("reviewer", at("settings")),
}
