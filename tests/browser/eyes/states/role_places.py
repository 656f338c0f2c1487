"""Pages as people of another role than the owner meet them: what they may do, and what they are refused."""

from typing import Any

from browser.eyes.eyes_clinic import EyesClinic
from browser.eyes.opening import Open, at, leave, opened, shows, steps, tapped
from browser.eyes.states.session_places import review, session_record, written_session


def as_a(role: str, open_place: Open) -> Open:
    """Return what opens a place for somebody of this role."""
    return steps(leave, lambda page, clinic: clinic.visit(page, role), open_place)


def session_with(words: str, *, signed: bool = False) -> Open:
    """Return what opens the record of a session, and waits for these words on it."""

    def open_place(page: Any, clinic: EyesClinic) -> None:
        session = written_session(clinic)
        if signed:
            clinic.good("POST", f"/sessions/{session}/sign-off")
        steps(opened(f"session/{session}"), shows(f"text={words}"))(page, clinic)

    return open_place


def refused(where: str) -> Open:
    """Return what opens a page that this role may not see."""
    return steps(at(where), shows("main >> role=link[name=/^Go to “/]"))


ROLE_PLACES: dict[str, Open] = {
    "patients, clinician": as_a("clinician", opened("patients")),
    "session, clinician": as_a("clinician", session_record),
    "session, signed, clinician": as_a("clinician", session_with("signed off", signed=True)),
    "settings, clinician": as_a("clinician", at("settings")),
    "people, clinician": as_a("clinician", refused("people")),
    "log, clinician": as_a("clinician", refused("log")),
    "computer, clinician": as_a("clinician", refused("computer")),
    "backup, clinician": as_a("clinician", refused("backup")),
    "patients, reviewer": as_a("reviewer", opened("patients")),
    "attention, reviewer": as_a("reviewer", at("attention")),
    "review, reviewer": as_a("reviewer", review("")),
    "review trial, reviewer": as_a("reviewer", steps(review("/trial/{first}"), tapped("Comment on this moment"))),
    "session, reviewer": as_a("reviewer", session_with("To get from my bed")),
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
