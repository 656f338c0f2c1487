"""Pages with nothing on them yet, or not ready, and pages whose request failed: each says what to do next."""

from typing import Any

from browser.eyes.eyes_clinic import EyesClinic
from browser.eyes.opening import Open, addressed, answered, answers, at, leave, named, opened, refusing, shows, steps
from playwright.sync_api import expect

NO_SHIRT: dict[str, Any] = {"shirt": None, "body": None, "layout": None, "unused": []}
OTHER_SHIRT = {
    "message": "The patient was calibrated in another shirt: calibrate in this one first.",
    "page": "calibrate",
}


EMPTY = shows(".body.empty")
WITHOUT_RECORDING = "The recording of this trial is not on this machine."


def with_nobody(where: str) -> Open:
    """Return what opens a page while no session is open."""
    return steps(leave, lambda _, clinic: clinic.good("DELETE", "/session"), at(where), EMPTY)


def not_calibrated(where: str) -> Open:
    """Return what opens a page for a patient who has no calibration."""
    return steps(leave, lambda _, clinic: clinic.be_here(2), at(where), EMPTY)


def failed(path: str, where: str, words: str = "The disk is full: delete what you do not need.") -> Open:
    """Return what opens a page whose request the program refuses."""
    refusal = refusing(f"**/api/v1{path}", 503, words)
    return steps(leave, refusal, addressed(where), shows(named("button", "Try again")))


def nobody_found(page: Any, _clinic: EyesClinic) -> None:
    page.get_by_label("Search").fill("Nightingale")
    expect(page.locator(".person")).to_have_count(0)


def without_shirt(page: Any, clinic: EyesClinic) -> None:
    steps_left = {"steps": clinic.good("GET", "/calibration")["steps"][-1:]}
    for path, change in (("calibration", steps_left), ("equipment", NO_SHIRT)):
        answers(page, f"**/api/v1/{path}", {**clinic.good("GET", f"/{path}"), **change})


EMPTY_PLACES: dict[str, Open] = {
    "shirt, nobody's": answered("/equipment", "shirt", lambda equipment: {**equipment, **NO_SHIRT}),
    "calibrate, nobody": with_nobody("calibrate"),
    "calibrate, no shirt": steps(leave, without_shirt, addressed("calibrate"), EMPTY),
    "controls, nobody": with_nobody("controls"),
    "controls, not calibrated": not_calibrated("controls"),
    "adapt, not calibrated": not_calibrated("adapt"),
    "drive, nobody": with_nobody("drive"),
    "drive, not calibrated": not_calibrated("drive"),
    "drive, other shirt": answered("/session", "drive", lambda view: {**view, "obstacle": OTHER_SHIRT}),
    "controls, other shirt": answered("/controls", "controls", lambda view: {**view, "obstacle": OTHER_SHIRT}),
    "patients, none found": steps(at("patients"), nobody_found),
    "patients, failed": failed("/patients", "patients"),
    "review, no trials": steps(opened("review/2"), EMPTY),
    "review trial, no recording": steps(
        *(leave, refusing("**/timeline", 404, WITHOUT_RECORDING)),
        lambda page, clinic: page.goto(f"{clinic.address}/#/review/1/trial/{clinic.trials[0]}"),
        shows(f"text={WITHOUT_RECORDING}"),
    ),
    "attention, nobody": answered("/attention", "attention", lambda _: []),
    "session patient, none": answered("/patients/2/sessions", "session/patient/2", lambda _: []),
    "plans, failed": failed("/own-floorplans", "plans"),
    "backup, no folder": answered(
        "/backups", "backup", lambda view: {**view, "folder": None, "made": [], "last_good": None}
    ),
    "settings, failed": failed("/limits", "settings"),
    "people, failed": failed("/people", "people"),
}
