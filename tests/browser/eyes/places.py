"""Every page in every state that a person meets, each opened from nothing by `PLACES[name](page, clinic)`.

A name without a comma is a page in its first state; "shirt, lamp" is another state of the page "shirt".
"""

import time
from typing import Any

from browser.eyes.eyes_clinic import EyesClinic
from browser.eyes.opening import Open, answered, at, go, leave, opened, patient_screen, start_with, tap
from browser.eyes.states.asked_places import ASKED_PLACES
from browser.eyes.states.calibrate_places import CALIBRATE_PLACES
from browser.eyes.states.chair_places import chair_page, no_chair, paired_chair
from browser.eyes.states.course_places import COURSE_PLACES
from browser.eyes.states.empty_places import EMPTY_PLACES
from browser.eyes.states.live_places import LIVE_PLACES
from browser.eyes.states.role_places import ROLE_PLACES
from browser.eyes.states.session_places import (
    ARCHIVE_PLACES,
    SESSION_PLACES,
    attention,
    commented,
    interface_test_over,
    interface_test_runs,
    review,
    revoke_links,
    shared_help,
    shared_records,
    trial_over,
    trial_runs,
    trial_stopped,
    unread,
    written_session,
)
from browser.eyes.states.tablet_places import TABLET_PLACES
from browser.eyes.states.trials_places import TRIALS_PLACES
from playwright.sync_api import expect

from app.faults import Fault
from app.session.trial import TrialFlow


def refused_sign_in(page: Any, clinic: EyesClinic) -> None:
    start_with(signed_in=False)(page, clinic)
    page.get_by_label("Name").fill("Ada")
    page.get_by_label("Password").fill("not this one")
    tap(page, "Sign in")
    expect(page.locator(".problem")).not_to_be_empty()


def invitation(page: Any, clinic: EyesClinic) -> None:
    ben = next(one for one in clinic.good("GET", "/people") if one["name"] == "Ben")
    link = clinic.good("POST", f"/people/{ben['id']}/link")["url"]
    leave(page, clinic)
    page.goto(f"{clinic.address}/#{link.partition('#')[2]}")
    expect(page.get_by_role("heading", name="Welcome")).to_be_visible()


def without_patients(page: Any, clinic: EyesClinic) -> None:
    answered("/patients", "patients", lambda _: [])(page, clinic)


def patient_is_deleted(page: Any, clinic: EyesClinic) -> None:
    go(page, clinic, "patients")
    tap(page, "Delete")
    expect(page.locator(".toast")).to_be_visible()


def erasure(page: Any, clinic: EyesClinic) -> None:
    clinic.good("DELETE", "/patients/2")
    at("backup", "Erase now")(page, clinic)
    expect(page.get_by_role("group", name="Erase now")).to_be_visible()


def refused_patient(page: Any, clinic: EyesClinic) -> None:
    at("patients", "New patient")(page, clinic)
    page.get_by_label("Code").fill("P-1")
    page.get_by_label("Pseudonym").fill("Again")
    tap(page, "Add")
    expect(page.locator(".problem")).not_to_be_empty()


def link_of_somebody(page: Any, clinic: EyesClinic) -> None:
    at("people", "New link for Ben")(page, clinic)
    expect(page.locator("img.qr")).to_be_visible()


def picked_lamp(page: Any, clinic: EyesClinic) -> None:
    go(page, clinic, "shirt")
    page.locator(".bodies .sensor").nth(20).click()


def first_step(page: Any, clinic: EyesClinic) -> None:
    at("calibrate", "Start")(page, clinic)
    page.wait_for_timeout(300)


def calibrated(page: Any, clinic: EyesClinic) -> None:
    clinic.set_calibration("result")
    opened("calibrate")(page, clinic)
    expect(page.get_by_role("heading", name="What this body can do")).to_be_visible()


def plan_editor(page: Any, clinic: EyesClinic) -> None:
    at("plans", "New plan")(page, clinic)
    expect(page.locator(".sheet")).to_be_visible()


def code_of_a_screen(page: Any, clinic: EyesClinic) -> None:
    at("drive/screen", "Pair a screen")(page, clinic)
    expect(page.get_by_role("heading", name="Pair a screen")).to_be_focused()


def patient_stopped(page: Any, clinic: EyesClinic) -> None:
    clinic.fault(Fault.STOP_TABLET)
    patient_screen(page, clinic)
    expect(page.locator(".band.stopped")).to_be_visible()


def computer_measured(page: Any, clinic: EyesClinic) -> None:
    go(page, clinic, "computer")
    words = {"good": "The clock is set by the network.", "attention": "Free disk: 4 GB.", "bad": "Port 8443 is taken."}
    findings = [{"verdict": verdict, "message": sentence} for verdict, sentence in words.items()]
    machine = {"verdict": "bad", "message": "This computer is not good enough for driving.", "findings": findings}
    found = {"machine": machine, "screens": findings[:2]}
    page.route("**/computer/measurement", lambda route: route.fulfill(json=found))
    tap(page, "Measure for")
    expect(page.get_by_role("heading", name="Screens that are open now")).to_be_visible()


def document(name: str) -> Open:
    """Return what opens a page of its own."""

    def open_place(page: Any, clinic: EyesClinic) -> None:
        leave(page, clinic)
        page.goto(f"{clinic.address}/{name}")
        page.wait_for_timeout(700)

    return open_place


# Where the address says so, no socket is ever opened.
CUT = """if (location.search === "?cut") {
  window.WebSocket = class extends EventTarget {
    static OPEN = 1;
    readyState = 3;
    constructor() {
      super();
      setTimeout(() => this.dispatchEvent(new Event("close")), 50);
    }
    send() {}
    close() {}
  };
}"""


def no_connection(page: Any, clinic: EyesClinic) -> None:
    page.unroute_all()
    page.add_init_script(CUT)
    page.goto(f"{clinic.address}/?cut#/patients")
    expect(page.locator(".note")).to_be_visible()


def other_session(page: Any, clinic: EyesClinic) -> None:
    go(page, clinic, "controls")
    clinic.be_here(2)
    expect(page.locator(".other-session")).to_be_visible()


def same_name(page: Any, clinic: EyesClinic) -> None:
    opened("shirt")(page, clinic)
    page.get_by_text("Replay of a file").click()
    file = {"name": "walk.csv", "mimeType": "text/csv", "buffer": b"t,a\n0.0,1\n0.01,1\n0.02,1\n"}
    for word in ("1", "2"):
        file["buffer"] = b"t,a\n" + b"".join(b"%.2f,%s\n" % (i / 100, word.encode()) for i in range(20))
        page.locator("input[type=file][accept='.csv,.parquet']").first.set_input_files(file)
        page.wait_for_timeout(500)
    expect(page.get_by_role("alertdialog")).to_be_visible()


def with_fault(page: Any, clinic: EyesClinic) -> None:
    clinic.fault(Fault.SHIRT_SILENT)
    go(page, clinic, "patients")
    expect(page.get_by_role("button", name="Take the stop back")).to_be_visible()


PLACES: dict[str, Open] = {
    "sign_in": start_with(signed_in=False),
    "sign_in, refused": refused_sign_in,
    "set_up": start_with(signed_in=False, needs_setup=True),
    "invitation": invitation,
    "lock": start_with(locked=True),
    "patients": at("patients"),
    "patients, none": without_patients,
    "patients, owner alone": answered("/people", "patients", lambda people: people[:1]),
    "patients, new": at("patients", "New patient"),
    "patients, deleted": patient_is_deleted,
    "patients, fault": with_fault,
    "shirt": at("shirt"),
    "shirt, lamp": picked_lamp,
    "shirt, open": opened("shirt"),
    "shirt, same name": same_name,
    "calibrate": opened("calibrate"),
    "calibrate, runs": first_step,
    "calibrate, result": calibrated,
    "controls": at("controls"),
    "controls, open": opened("controls"),
    "adapt": opened("adapt"),
    "interface_test": opened("interface_test"),
    "interface_test, runs": interface_test_runs,
    "interface_test, over": interface_test_over,
    "attention": attention,
    "review": review(""),
    "review trial": review("/trial/{first}"),
    "review, unread": unread,
    "review, comments": commented,
    "review compare": review("/compare/{first}/{second}"),
    **SESSION_PLACES,
    "settings": at("settings"),
    "settings, pair": at("settings", "Pair a chair"),
    "settings, paired": paired_chair,
    "plans": opened("plans"),
    "plans, edit": plan_editor,
    "people": at("people"),
    "people, invite": at("people", "Invite somebody"),
    "people, link": link_of_somebody,
    "log": at("log"),
    "first time": start_with(introduced=False),
    "help": at("calibrate", "What is this page for?"),
    "computer": at("computer"),
    "computer, measured": computer_measured,
    "backup": at("backup"),
    "backup, erase": erasure,
    "drive": opened("drive"),
    "drive tasks": opened("drive/tasks"),
    "drive chairs": opened("drive/chairs"),
    "drive screen": opened("drive/screen"),
    "drive, pair a screen": code_of_a_screen,
    "drive, over": trial_over,
    "drive, runs": trial_runs,
    "drive, stopped": trial_stopped,
    "chair": chair_page,
    "patient's screen, not paired": document("patient.html"),
    "patient's screen": patient_screen,
    "patient's screen, stopped": patient_stopped,
    "stereo": document("stereo.html"),
    "tablet": document("tablet.html"),
    "share link, none": document("share.html"),
    "share link, PIN": document("share.html#a-link"),
    "share link": shared_records,
    "share link, help": shared_help,
    "docs": document("docs/"),
    "docs clinicians": document("docs/clinicians"),
    "other session": other_session,
    "no connection": no_connection,
    **ARCHIVE_PLACES,
    **EMPTY_PLACES,
    **ASKED_PLACES,
    **CALIBRATE_PLACES,
    **LIVE_PLACES,
    **ROLE_PLACES,
    **COURSE_PLACES,
    **TRIALS_PLACES,
    **TABLET_PLACES,
}


def put_back(clinic: EyesClinic) -> None:
    """Undo what a place has left behind, so that the next one starts from the same clinic."""
    clinic.leave()
    clinic.clear()
    if clinic.stored() == clinic.put_back_to:  # most places are only looked at
        return
    written_session(clinic)  # not signed off
    revoke_links(clinic)
    clinic.client.request("POST", "/patients/2/restore")
    if (clinic.good("GET", "/session")["patient"] or {}).get("id") != 1:
        clinic.be_here()
    clinic.set_calibration("rest")
    while running := clinic.good("GET", "/calibration")["running"]:  # a step may end by itself meanwhile
        clinic.client.request("POST", f"/calibration/steps/{running['step']}/cancel")
    tests = clinic.good("GET", "/interface-tests?patient=1")["tests"]
    if tests and tests[-1]["status"] == "running":
        clinic.good("POST", "/interface-tests/current/end")
    if clinic.process.run:  # on a busy machine, the answer may come before it has been measured
        clinic.client.request("POST", "/trials/current/end", json={"reason": "by hand"})
        while clinic.app.state.parts[TrialFlow].current:
            time.sleep(0.05)
    no_chair(clinic)
    clinic.put_back_to = clinic.stored()
