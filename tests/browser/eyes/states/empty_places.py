"""Pages with nothing on them yet, or not ready, and pages whose request failed: each says what to do next."""

from typing import Any

from browser.eyes.eyes_clinic import EyesClinic
from browser.eyes.opening import Open, answered, go, leave, opened
from playwright.sync_api import expect

NO_SHIRT: dict[str, Any] = {"shirt": None, "body": None, "layout": None, "unused": []}
OTHER_SHIRT = {
    "message": "The patient was calibrated in another shirt: calibrate in this one first.",
    "page": "calibrate",
}


def with_nobody(where: str) -> Open:
    """Return what opens a page while no session is open."""

    def open_place(page: Any, clinic: EyesClinic) -> None:
        leave(page, clinic)
        clinic.good("DELETE", "/session")
        go(page, clinic, where)
        expect(page.locator(".body.empty")).to_be_visible()

    return open_place


def not_calibrated(where: str) -> Open:
    """Return what opens a page for a patient who has no calibration."""

    def open_place(page: Any, clinic: EyesClinic) -> None:
        leave(page, clinic)
        clinic.be_here(2)
        go(page, clinic, where)
        expect(page.locator(".body.empty")).to_be_visible()

    return open_place


def failed(path: str, where: str, words: str = "The disk is full: delete what you do not need.") -> Open:
    """Return what opens a page whose request the program refuses."""

    def open_place(page: Any, clinic: EyesClinic) -> None:
        leave(page, clinic)
        page.route(f"**/api/v1{path}", lambda route: route.fulfill(status=503, json={"detail": words}))
        page.goto(f"{clinic.address}/#/{where}")
        expect(page.get_by_role("button", name="Try again")).to_be_visible()

    return open_place


def nobody_found(page: Any, clinic: EyesClinic) -> None:
    go(page, clinic, "patients")
    page.get_by_label("Search").fill("Nightingale")
    expect(page.locator(".person")).to_have_count(0)


def calibrate_without_shirt(page: Any, clinic: EyesClinic) -> None:
    leave(page, clinic)
    replies = {
        "calibration": {
            **clinic.good("GET", "/calibration"),
            "steps": clinic.good("GET", "/calibration")["steps"][-1:],
        },
        "equipment": {**clinic.good("GET", "/equipment"), **NO_SHIRT},
    }
    page.route("**/api/v1/calibration", lambda route: route.fulfill(json=replies["calibration"]))
    page.route("**/api/v1/equipment", lambda route: route.fulfill(json=replies["equipment"]))
    page.goto(f"{clinic.address}/#/calibrate")
    expect(page.locator(".body.empty")).to_be_visible()


def no_backup_folder(page: Any, clinic: EyesClinic) -> None:
    answered("/backups", "backup", lambda view: {**view, "folder": None, "made": [], "last_good": None})(page, clinic)


def review_without_trials(page: Any, clinic: EyesClinic) -> None:
    opened("review/2")(page, clinic)
    expect(page.locator(".body.empty")).to_be_visible()


def trial_without_recording(page: Any, clinic: EyesClinic) -> None:
    leave(page, clinic)
    words = "The recording of this trial is not on this machine."
    page.route("**/timeline", lambda route: route.fulfill(status=404, json={"detail": words}))
    page.goto(f"{clinic.address}/#/review/1/trial/{clinic.trials[0]}")
    expect(page.get_by_text(words)).to_be_visible()


EMPTY_PLACES: dict[str, Open] = {
    "shirt, nobody's": answered("/equipment", "shirt", lambda equipment: {**equipment, **NO_SHIRT}),
    "calibrate, nobody": with_nobody("calibrate"),
    "calibrate, no shirt": calibrate_without_shirt,
    "controls, nobody": with_nobody("controls"),
    "controls, not calibrated": not_calibrated("controls"),
    "adapt, not calibrated": not_calibrated("adapt"),
    "drive, nobody": with_nobody("drive"),
    "drive, not calibrated": not_calibrated("drive"),
    "drive, other shirt": answered("/session", "drive", lambda view: {**view, "obstacle": OTHER_SHIRT}),
    "controls, other shirt": answered("/controls", "controls", lambda view: {**view, "obstacle": OTHER_SHIRT}),
    "patients, none found": nobody_found,
    "patients, failed": failed("/patients", "patients"),
    "review, no trials": review_without_trials,
    "review trial, no recording": trial_without_recording,
    "attention, nobody": answered("/attention", "attention", lambda _: []),
    "session patient, none": answered("/patients/2/sessions", "session/patient/2", lambda _: []),
    "plans, failed": failed("/own-floorplans", "plans"),
    "backup, no folder": no_backup_folder,
    "settings, failed": failed("/limits", "settings"),
    "people, failed": failed("/people", "people"),
}
