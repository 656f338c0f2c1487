"""Pages while something moves, waits or was stopped: the chair's panel, the patient's screen, the notices of each page.

What the live sockets say is changed by `EyesClinic.shown`, as a chair or a trial that is under way would change it.
"""

from collections.abc import Callable
from typing import Any

from browser.eyes.eyes_clinic import EyesClinic
from browser.eyes.opening import Open, answered, go, leave, patient_screen
from browser.eyes.states.chair_places import chair_page
from browser.eyes.states.session_places import trial_stopped
from playwright.sync_api import expect

from app.api.live.live_picture import ClinicLive
from app.faults import Fault, State

DRIVE = {"id": 1, "t": 83.0, "waits": None}
CHAIR = {
    "kind": "udp", "state": "armed", "age": 0.02, "battery": 0.82, "stop_input": False, "v": 0.31, "omega": -0.2,
    "message": "",
}  # fmt: skip
TRIAL = {  # as the patient's screen gets it
    "id": 0, "t": 12.0, "done": 4.2, "length": 12.0, "stage": 0, "stages": 2,
    "instruction": "Follow the line to the kitchen.", "target": [4.0, 2.0], "movers": [],
}  # fmt: skip
CUE = {"index": 3, "kind": "move", "movement": "Lift the right shoulder", "t": 0.6, "length": 2.0, "next": "return"}
TEST = {
    "id": 1, "phase": "running", "remaining": 74.0, "cursor": [0.2, -0.1], "target": [0.6, 0.3], "radius": 0.15,
    "dwell": 0.4, "acquired": 12, "missed": 1,
}  # fmt: skip


def driven(state: State, **more: Any) -> Open:
    """Return what opens the panel of a chair that is armed."""

    def open_place(page: Any, clinic: EyesClinic) -> None:
        chair_page(page, clinic)
        clinic.process.state = state
        clinic.shown |= {"drive": DRIVE, "chair": CHAIR, "v": 0.31, "omega": -0.2, **more}
        expect(page.locator(".drive-panel")).to_be_visible()

    return open_place


def driven_and_stopped(fault: Fault) -> Open:
    """Return what opens the panel of a chair that was stopped."""

    def open_place(page: Any, clinic: EyesClinic) -> None:
        halted = {"drive": {**DRIVE, "waits": 271.0}, "chair": {**CHAIR, "state": "fault", "v": 0.0, "omega": 0.0}}
        driven(State.ARMED)(page, clinic)
        clinic.fault(fault)
        clinic.shown |= halted
        expect(page.get_by_role("button", name="Continue")).to_be_visible()

    return open_place


def to_the_patient(selector: str, *, state: State = State.DISARMED, wishes: Any = None, **shown: Any) -> Open:
    """Return what opens the patient's screen with these fields in its picture, and waits for an element."""

    def open_place(page: Any, clinic: EyesClinic) -> None:
        patient_screen(page, clinic)
        asks = {"arrow": True, "sounds": True, "large": False, "plan": False, **(wishes or {})}
        clinic.process.state = state
        clinic.shown_to_patient |= {"asks": asks, **shown}
        expect(page.locator(selector).first).to_be_visible()

    return open_place


def goal_reached(page: Any, clinic: EyesClinic) -> None:
    patient_screen(page, clinic)
    clinic.shown_to_patient |= {"over": {"id": 7, "end": "goal"}}
    expect(page.locator(".moment .word")).to_be_visible()


def go_word(page: Any, clinic: EyesClinic) -> None:
    to_the_patient(".moment .word", state=State.CHECKING, trial=TRIAL, drives=True)(page, clinic)
    clinic.process.state = State.ARMED
    expect(page.locator(".moment .go")).to_be_visible()


def session_over(page: Any, clinic: EyesClinic) -> None:
    patient_screen(page, clinic)
    clinic.good("DELETE", "/session")
    expect(page.locator(".code-form")).to_be_visible()


def refused_code(page: Any, clinic: EyesClinic) -> None:
    leave(page, clinic)
    page.context.clear_cookies(name="bodydrive_screen")
    page.goto(f"{clinic.address}/patient.html")
    page.get_by_role("textbox").fill("AAAA 1111")
    page.keyboard.press("Enter")
    expect(page.locator(".problem")).not_to_be_empty()


def noticed(where: str, words: str, **shown: Any) -> Open:
    """Return what opens a page above which a notice stands."""

    def open_place(page: Any, clinic: EyesClinic) -> None:
        go(page, clinic, where)
        clinic.shown |= shown
        expect(page.locator(".note").filter(has_text=words)).to_be_visible()

    return open_place


def without_consent(page: Any, clinic: EyesClinic) -> None:
    clinic.good("DELETE", "/patients/1/consents/recording")
    clinic.when_left.append(lambda: clinic.good("PUT", "/patients/1/consents/recording", {"given": "2026-03-01"}))
    noticed("controls", "consented", practice=None)(page, clinic)


def changed(change: Callable[[Any], Any], words: str) -> Open:
    """Return what opens the patients' list with another equipment, and waits for a notice."""

    def open_place(page: Any, clinic: EyesClinic) -> None:
        answered("/equipment", "patients", change)(page, clinic)
        expect(page.locator(".note").filter(has_text=words)).to_be_visible()

    return open_place


def estimated_lamps(clinic: EyesClinic) -> None:
    """Let others stand in for three sensors of the shirt."""
    clinic.lamps |= {**dict.fromkeys(range(52), "good"), **dict.fromkeys((3, 20, 41), "estimated")}


def estimated_sensors(page: Any, clinic: EyesClinic) -> None:
    estimated_lamps(clinic)
    go(page, clinic, "shirt")
    expect(page.get_by_text("49 of 52 sensors are good")).to_be_visible()
    page.locator(".bodies .sensor").nth(20).click()
    page.locator(".lamp-legend").evaluate("(legend) => { legend.open = true; }")


def silent_shirt(where: str) -> Open:
    """Return what opens a page while no frame comes from the shirt."""

    def open_place(page: Any, clinic: EyesClinic) -> None:
        clinic.silence("No frames from a shirt on 127.0.0.1:5252 (the shirt sends 40 sensors, its layout has 52).")
        go(page, clinic, where)
        expect(page.locator(".lamp", has_text="Shirt silent")).to_be_visible()

    return open_place


def screen_out_of_reach(page: Any, clinic: EyesClinic) -> None:
    """Show a halted trial whose patient's screen is out of reach."""
    trial_stopped(page, clinic)
    screen = {"id": 1, "number": 1, "paired": "2026-03-01T10:00:00+00:00", "connected": False, "picture": None}
    page.route("**/patient-screen", lambda route: route.fulfill(json={**route.fetch().json(), "screens": [screen]}))
    clinic.app.state.parts[ClinicLive].notify("screens")
    expect(page.locator(".screen-lamp")).to_be_visible()


FULL_DISK = {"message": "The disk is nearly full: 1.2 GB are free.", "free": 1_200_000_000}

LIVE_PLACES: dict[str, Open] = {
    "chair, checking": driven(State.CHECKING),
    "chair, driven": driven(State.ARMED),
    "chair, stopped": driven_and_stopped(Fault.STOP_TABLET),
    "chair, silent": driven_and_stopped(Fault.CHAIR_SILENT),
    "patient's screen, cue": to_the_patient(".cue-layer", cue=CUE),
    "patient's screen, rest": to_the_patient(".moment .word", state=State.CHECKING, trial=TRIAL, drives=True),
    "patient's screen, go": go_word,
    "patient's screen, drives": to_the_patient(".arrow", state=State.ARMED, trial=TRIAL, drives=True, v=0.4),
    "patient's screen, large": to_the_patient(
        ".arrow", state=State.ARMED, trial=TRIAL, drives=True, v=-0.2, wishes={"large": True, "plan": True}
    ),
    "patient's screen, goal": goal_reached,
    "patient's screen, test": to_the_patient(".target-cross", test=TEST),
    "patient's screen, over": session_over,
    "patient's screen, refused": refused_code,
    "settings, driven elsewhere": noticed("settings", "being driven", drive=DRIVE),
    "patients, program lost": noticed("patients", "control process", control="lost"),
    "patients, full disk": changed(lambda equipment: {**equipment, "disk": FULL_DISK}, "nearly full"),
    "controls, consent": without_consent,
    "shirt, estimated": estimated_sensors,
    "shirt, silent": silent_shirt("shirt"),
    "drive, silent": silent_shirt("drive"),
    "drive, screen out of reach": screen_out_of_reach,
}
