"""Pages while something moves, waits or was stopped: the chair's panel, the patient's screen, the notices of each page.

What the live sockets say is changed by `EyesClinic.shown`, as a chair or a trial that is under way would change it.
"""

from typing import Any

from browser.eyes.eyes_clinic import EyesClinic
from browser.eyes.opening import Open, answered, at, document, leave, named, patient_screen, pressed, shows, steps
from browser.eyes.states.asked_places import PROBLEM
from browser.eyes.states.chair_places import chair_page
from browser.eyes.states.session_places import trial_stopped
from playwright.sync_api import expect

from app.api.live.live_picture import ClinicLive
from app.arrivals import Arrivals
from app.faults import Fault, State
from app.news import News
from app.texts import Text

DRIVE = {"id": 1, "t": 83.0, "waits": None}
CHAIR = {
    "kind": "udp", "state": "armed", "age": 0.02, "battery": 0.82, "stop_input": False, "v": 0.31, "omega": -0.2,
    "own_joystick": False, "measured": True, "message": "",
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


def showing(**fields: Any) -> Open:
    """Return what lets the live picture have these fields."""
    return lambda _, clinic: clinic.shown.update(fields)


def in_state(state: State) -> Open:
    """Return what lets the control process be in a state."""
    return lambda _, clinic: setattr(clinic.process, "state", state)


def without_document(page: Any, clinic: EyesClinic) -> None:
    """Open the page that arms a chair which misses its chair document."""
    process = clinic.process
    process.crawls = True
    clinic.when_left.append(lambda: setattr(process, "crawls", False))
    steps(chair_page, shows(".crawls"))(page, clinic)


def driven(state: State) -> Open:
    """Return what opens the panel of a chair that is armed."""
    fields = {"drive": DRIVE, "chair": CHAIR, "v": 0.31, "omega": -0.2}
    return steps(chair_page, in_state(state), showing(**fields), shows(".drive-panel"))


def driven_and_stopped(fault: Fault) -> Open:
    """Return what opens the panel of a chair that was stopped."""
    halted = {"drive": {**DRIVE, "waits": 271.0}, "chair": {**CHAIR, "state": "fault", "v": 0.0, "omega": 0.0}}
    return steps(
        driven(State.ARMED),
        lambda _, clinic: clinic.fault(fault),
        *(showing(**halted), shows(named("button", "Continue"))),
    )


def telling_the_patient(**fields: Any) -> Open:
    """Return what lets the patient's picture have these fields."""
    return lambda _, clinic: clinic.shown_to_patient.update(fields)


def to_the_patient(selector: str, *, state: State = State.DISARMED, large: bool = False, **shown: Any) -> Open:
    """Return what opens the patient's screen with these fields in its picture, and waits for an element."""
    asks = {"arrow": True, "sounds": True, "large": large, "plan": large}
    return steps(patient_screen, in_state(state), telling_the_patient(asks=asks, **shown), shows(selector))


def without_a_screen(page: Any, clinic: EyesClinic) -> None:
    """Forget that the browser is a paired screen."""
    leave(page, clinic)
    page.context.clear_cookies(name="bodydrive_screen")


def noticed(where: str, words: str, **shown: Any) -> Open:
    """Return what opens a page above which a notice stands."""
    return steps(at(where), showing(**shown), shows(f".note:has-text('{words}')"))


def without_consent(page: Any, clinic: EyesClinic) -> None:
    clinic.good("DELETE", "/patients/1/consents/recording")
    clinic.when_left.append(lambda: clinic.good("PUT", "/patients/1/consents/recording", {"given": "2026-03-01"}))
    noticed("controls", "consented", practice=None)(page, clinic)


def estimated_lamps(clinic: EyesClinic) -> None:
    """Let others stand in for three sensors of the shirt."""
    clinic.lamps |= {**dict.fromkeys(range(52), "good"), **dict.fromkeys((3, 20, 41), "estimated")}


def open_legend(page: Any, _clinic: EyesClinic) -> None:
    page.locator(".bodies .sensor").nth(20).click()
    page.locator(".lamp-legend").evaluate("(legend) => { legend.open = true; }")


def silent_shirt(where: str) -> Open:
    """Return what opens a page while no frame comes from the shirt."""
    words = "No frames from a shirt on 127.0.0.1:5252 (the shirt sends 40 sensors, its layout has 52)."
    return steps(lambda _, clinic: clinic.silence(words), at(where), shows(".lamp:has-text('Shirt silent')"))


def nothing_arrives(_page: Any, clinic: EyesClinic) -> None:
    """Let the shirt say why nothing arrives."""
    why = Text("arrivals-udp-nothing", place="0.0.0.0:5252", port=5252, reach="network")
    clinic.silence("No frames from a shirt on 0.0.0.0:5252.", Arrivals("nothing", why))


def screen_out_of_reach(page: Any, clinic: EyesClinic) -> None:
    """Show a halted trial whose patient's screen is out of reach."""
    trial_stopped(page, clinic)
    screen = {"id": 1, "number": 1, "paired": "2026-03-01T10:00:00+00:00", "connected": False, "picture": None}
    page.route("**/patient-screen", lambda route: route.fulfill(json={**route.fetch().json(), "screens": [screen]}))
    clinic.app.state.parts[ClinicLive].notify(News(what="screens"))
    expect(page.locator(".screen-lamp")).to_be_visible()


FULL_DISK = {"message": "The disk is nearly full: 1.2 GB are free.", "free": 1_200_000_000}

LIVE_PLACES: dict[str, Open] = {
    "chair, without its document": without_document,
    "chair, checking": driven(State.CHECKING),
    "chair, driven": driven(State.ARMED),
    "chair, stopped": driven_and_stopped(Fault.STOP_TABLET),
    "chair, silent": driven_and_stopped(Fault.CHAIR_SILENT),
    "patient's screen, cue": to_the_patient(".cue-layer", cue=CUE),
    "patient's screen, rest": to_the_patient(".moment .word", state=State.CHECKING, trial=TRIAL, drives=True),
    "patient's screen, go": steps(
        to_the_patient(".moment .word", state=State.CHECKING, trial=TRIAL, drives=True),
        *(in_state(State.ARMED), shows(".moment .go")),
    ),
    "patient's screen, drives": to_the_patient(".arrow", state=State.ARMED, trial=TRIAL, drives=True, v=0.4),
    "patient's screen, large": to_the_patient(
        ".arrow", state=State.ARMED, trial=TRIAL, drives=True, v=-0.2, large=True
    ),
    "patient's screen, goal": steps(
        patient_screen, telling_the_patient(over={"id": 7, "end": "goal"}), shows(".moment .word")
    ),
    "patient's screen, test": to_the_patient(".target-cross", test=TEST),
    "patient's screen, over": steps(
        patient_screen, lambda _, clinic: clinic.good("DELETE", "/session"), shows(".code-form")
    ),
    "patient's screen, refused": steps(
        without_a_screen,
        *(document("patient.html"), lambda page, _: page.get_by_role("textbox").fill("AAAA 1111")),
        *(pressed("Enter"), shows(PROBLEM)),
    ),
    "settings, driven elsewhere": noticed("settings", "being driven", drive=DRIVE),
    "patients, program lost": noticed("patients", "control process", control="lost"),
    "patients, full disk": steps(
        answered("/equipment", "patients", lambda equipment: {**equipment, "disk": FULL_DISK}),
        shows(".note:has-text('nearly full')"),
    ),
    "controls, consent": without_consent,
    "shirt, estimated": steps(
        lambda _, clinic: estimated_lamps(clinic), *(at("shirt"), shows("text=49 of 52 sensors are good"), open_legend)
    ),
    "shirt, silent": silent_shirt("shirt"),
    "shirt, nothing arrives": steps(nothing_arrives, at("shirt"), shows("text=Nothing arrives?")),
    "drive, silent": silent_shirt("drive"),
    "drive, screen out of reach": screen_out_of_reach,
}
