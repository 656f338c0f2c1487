"""Every page in every state that a person meets, each opened from nothing by `PLACES[name](page, clinic)`.

A name without a comma is a page in its first state; "shirt, lamp" is another state of the page "shirt".
"""

import time
from typing import Any

from browser.eyes.eyes_clinic import EyesClinic
from browser.eyes.opening import (
    Open,
    answered,
    answers,
    at,
    document,
    filled,
    go,
    named,
    opened,
    patient_screen,
    pauses,
    shows,
    start_with,
    steps,
    tapped,
)
from browser.eyes.states.asked_places import ASKED_PLACES, PROBLEM
from browser.eyes.states.calibrate_places import CALIBRATE_PLACES, calibration_at
from browser.eyes.states.chair_places import chair_page, no_chair, paired_chair
from browser.eyes.states.course_places import COURSE_PLACES
from browser.eyes.states.empty_places import EMPTY_PLACES
from browser.eyes.states.layout_places import own_layout
from browser.eyes.states.live_places import LIVE_PLACES
from browser.eyes.states.recording_places import IMPORT_PLACES
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
    shared_records,
    trial_over,
    trial_runs,
    trial_stopped,
    written_session,
)
from browser.eyes.states.tablet_places import TABLET_PLACES
from browser.eyes.states.trials_places import TRIALS_PLACES
from browser.script import script
from playwright.sync_api import expect

from app.faults import Fault
from app.session.trial import TrialFlow


def invitation(page: Any, clinic: EyesClinic) -> None:
    ben = next(one for one in clinic.good("GET", "/people") if one["name"] == "Ben")
    link = clinic.good("POST", f"/people/{ben['id']}/link")["url"]
    steps(document(f"#{link.partition('#')[2]}"), shows(named("heading", "Welcome")))(page, clinic)


def picked_lamp(page: Any, clinic: EyesClinic) -> None:
    go(page, clinic, "shirt")
    page.locator(".bodies .sensor").nth(20).click()


def layout_editor(page: Any, clinic: EyesClinic) -> None:
    go(page, clinic, f"layouts/edit/{own_layout(clinic)}")
    expect(page.locator(".place-mark[role=slider]")).to_be_visible()


def computer_measured(page: Any, clinic: EyesClinic) -> None:
    go(page, clinic, "computer")
    words = {"good": "The clock is set by the network.", "attention": "Free disk: 4 GB.", "bad": "Port 8443 is taken."}
    findings = [{"verdict": verdict, "message": sentence} for verdict, sentence in words.items()]
    machine = {"verdict": "bad", "message": "This computer is not good enough for driving.", "findings": findings}
    answers(page, "**/computer/measurement", {"machine": machine, "screens": findings[:2]})
    steps(tapped("Measure for"), shows("text=Screens that are open now"))(page, clinic)


# Where the address says so, no socket is ever opened.
CUT = script("no_socket")


def no_connection(page: Any, clinic: EyesClinic) -> None:
    page.unroute_all()
    page.add_init_script(CUT)
    page.goto(f"{clinic.address}/?cut#/patients")
    expect(page.locator(".note")).to_be_visible()


def same_name(page: Any, clinic: EyesClinic) -> None:
    opened("shirt")(page, clinic)
    page.get_by_text("Replay of a file").click()
    for word in ("1", "2"):
        rows = "".join(f"{i / 100:.2f},{word}\n" for i in range(20))
        file = {"name": "walk.csv", "mimeType": "text/csv", "buffer": f"t,a\n{rows}".encode()}
        page.locator("input[type=file][accept='.csv,.parquet']").first.set_input_files(file)
        page.wait_for_timeout(500)
    expect(page.get_by_role("alertdialog")).to_be_visible()


def settled(name: str) -> Open:
    """Return what opens a page of its own, and waits until it stands still."""
    return steps(document(name), pauses(700))


def stopped_by(fault: Fault) -> Open:
    """Return what lets the control process stop the chair."""
    return lambda _, clinic: clinic.fault(fault)


PLACES: dict[str, Open] = {
    "sign_in": start_with(signed_in=False),
    "sign_in, refused": steps(
        start_with(signed_in=False),
        filled("Name", "Ada"),
        filled("Password", "wrong"),
        tapped("Sign in"),
        shows(PROBLEM),
    ),
    "set_up": start_with(signed_in=False, needs_setup=True),
    "invitation": invitation,
    "lock": start_with(locked=True),
    "patients": at("patients"),
    "patients, none": answered("/patients", "patients", lambda _: []),
    "patients, owner alone": answered("/people", "patients", lambda people: people[:1]),
    "patients, new": at("patients", "New patient"),
    "patients, deleted": steps(at("patients", "Delete"), shows(".toast")),
    "patients, fault": steps(
        stopped_by(Fault.SHIRT_SILENT), at("patients"), shows(named("button", "Take the stop back"))
    ),
    "shirt": at("shirt"),
    "shirt, lamp": picked_lamp,
    "shirt, open": opened("shirt"),
    "shirt, same name": same_name,
    "layouts": opened("layouts"),
    "layouts edit": layout_editor,
    "calibrate": opened("calibrate"),
    "calibrate, runs": steps(at("calibrate", "Start"), pauses(300)),
    "calibrate, result": steps(
        calibration_at("result"), opened("calibrate"), shows("text=Every movement this body can make")
    ),
    "controls": at("controls"),
    "controls, open": opened("controls"),
    "adapt": opened("adapt"),
    "interface_test": opened("interface_test"),
    "interface_test, runs": interface_test_runs,
    "interface_test, over": interface_test_over,
    "attention": attention,
    "review": review(""),
    "review trial": review("/trial/{first}"),
    "review, unread": steps(
        lambda _, clinic: clinic.add_comment(3.0, "Well turned."), review(""), shows("text=unread comment")
    ),
    "review, comments": commented,
    "review compare": review("/compare/{first}/{second}"),
    **SESSION_PLACES,
    "settings": at("settings"),
    "settings, pair": at("settings", "Pair a chair"),
    "settings, paired": paired_chair,
    "plans": opened("plans"),
    "plans, edit": steps(at("plans", "New plan"), shows(".sheet")),
    "people": at("people"),
    "people, invite": at("people", "Invite somebody"),
    "people, link": steps(at("people", "New link for Ben"), shows("img.qr")),
    "log": at("log"),
    "first time": start_with(introduced=False),
    "help": steps(at("calibrate", "What is this page for?"), shows(".page-help")),
    "computer": at("computer"),
    "computer, measured": computer_measured,
    "backup": at("backup"),
    "backup, erase": steps(
        lambda _, clinic: clinic.good("DELETE", "/patients/2"),
        *(at("backup", "Erase now"), shows(named("group", "Erase now"))),
    ),
    "drive": opened("drive"),
    "drive tasks": opened("drive/tasks"),
    "drive chairs": opened("drive/chairs"),
    "drive screen": opened("drive/screen"),
    "drive, pair a screen": steps(at("drive/screen", "Pair a screen"), shows(":is(h1, h2, h3):focus")),
    "drive, over": trial_over,
    "drive, runs": trial_runs,
    "drive, stopped": trial_stopped,
    "chair": chair_page,
    "patient's screen, not paired": settled("patient.html"),
    "patient's screen": patient_screen,
    "patient's screen, stopped": steps(stopped_by(Fault.STOP_TABLET), patient_screen, shows(".band.stopped")),
    "stereo": settled("stereo.html"),
    "tablet": settled("tablet.html"),
    "phone": settled("phone.html"),
    "share link, none": settled("share.html"),
    "share link, PIN": settled("share.html#a-link"),
    "share link": shared_records,
    "share link, help": steps(shared_records, tapped("What is this page for?"), shows("role=dialog")),
    "docs": settled("docs/"),
    "docs clinicians": settled("docs/clinicians"),
    "other session": steps(at("controls"), lambda _, clinic: clinic.be_here(2), shows(".other-session")),
    "no connection": no_connection,
    **ARCHIVE_PLACES,
    **EMPTY_PLACES,
    **IMPORT_PLACES,
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
