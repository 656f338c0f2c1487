"""The Calibrate page on the way to a result, when a step has failed, and where a ring of sensors sits otherwise."""

from typing import Any

from browser.eyes.eyes_clinic import LAYOUT, EyesClinic
from browser.eyes.opening import Open, answered, opened, tap
from playwright.sync_api import expect

from app.calibration.linear_map import Arrangement
from building import taught_by_others


def restarting(page: Any, clinic: EyesClinic) -> None:
    clinic.set_calibration("result")
    opened("calibrate")(page, clinic)
    tap(page, "Begin anew")
    expect(page.locator(".toast")).to_be_visible()


def failed_step(page: Any, clinic: EyesClinic) -> None:
    words = "The body moved too much: let the arms hang, and repeat this step."

    def change(view: Any) -> Any:
        first, *others = view["steps"]
        return {**view, "steps": [{**first, "status": "failed", "message": words}, *others], "current": first["id"]}

    answered("/calibration", "calibrate", change)(page, clinic)
    expect(page.get_by_text(words)).to_be_visible()


def judged_step(page: Any, clinic: EyesClinic) -> None:
    words = "The movement is hardly larger than rest (1.4 times): make it larger, and repeat this step."

    def change(view: Any) -> Any:
        rest, free, judged, *others = view["steps"]
        done = [{**step, "status": "done"} for step in (rest, free)]
        return {
            **view,
            "steps": [*done, {**judged, "status": "done", "message": words}, *others],
            "current": judged["id"],
        }

    answered("/calibration", "calibrate", change)(page, clinic)
    expect(page.get_by_text(words)).to_be_visible()


def drive_now(page: Any, clinic: EyesClinic) -> None:
    def change(view: Any) -> Any:
        return {**view, "may_drive_now": True, "others": 12}

    answered("/calibration", "calibrate", change)(page, clinic)
    expect(page.locator(".drive-now")).to_be_visible()


def fitting(page: Any, clinic: EyesClinic) -> None:
    clinic.set_calibration("result")
    running = {"step": "result", "t": 0.0}
    answered("/calibration", "calibrate", lambda view: {**view, "running": running})(page, clinic)
    expect(page.locator(".working")).to_be_visible()


def missing_steps(page: Any, clinic: EyesClinic) -> None:
    clinic.set_calibration("result")

    def change(view: Any) -> Any:
        steps = [{**step, "status": "waiting"} if i in (2, 4) else step for i, step in enumerate(view["steps"])]
        return {**view, "steps": steps, "result": None}

    answered("/calibration", "calibrate", change)(page, clinic)


def sits_otherwise(offer: str, **sits: Arrangement) -> Open:
    """Return what opens a result in which the ring of the right elbow sits otherwise than on other people."""

    def open_place(page: Any, clinic: EyesClinic) -> None:
        ring = next(channel.ring for channel in LAYOUT.channels if channel.joint == "right_elbow" and channel.ring)
        of_ring = {how: {ring: arrangement} for how, arrangement in sits.items()}
        clinic.set_calibration("result", lambda profile: taught_by_others(profile, 3, ["right_elbow"], **of_ring))
        opened("calibrate")(page, clinic)
        expect(page.get_by_text(offer, exact=True)).to_be_visible()

    return open_place


CALIBRATE_PLACES: dict[str, Open] = {
    "calibrate, begin anew": restarting,
    "calibrate, failed": failed_step,
    "calibrate, judged": judged_step,
    "calibrate, drive now": drive_now,
    "calibrate, fitting": fitting,
    "calibrate, missing": missing_steps,
    "calibrate, turned": sits_otherwise("It sits right", arrangement=Arrangement(shift=3)),
    "calibrate, mirrored": sits_otherwise("It sits right", arrangement=Arrangement(mirrored=True)),
    "calibrate, as worn": sits_otherwise("Take it as turned", as_worn=Arrangement(shift=3)),
}
