"""The Calibrate page on the way to a result, when a step has failed, and where a ring of sensors sits otherwise."""

from collections.abc import Callable
from typing import Any

from browser.eyes.eyes_clinic import LAYOUT, EyesClinic
from browser.eyes.opening import Open, answered, opened, shows, steps, tapped

from app.calibration.linear_map import Arrangement
from building import taught_by_others

MOVED = "The body moved too much: let the arms hang, and repeat this step."
WEAK = "The movement is hardly larger than rest (1.4 times): make it larger, and repeat this step."


def calibration_at(step: str) -> Open:
    """Return what lets the open session's calibration be at a step."""
    return lambda _, clinic: clinic.set_calibration(step)


def viewed(change: Callable[[Any], Any]) -> Open:
    """Return what opens the page with another view of the calibration."""
    return answered("/calibration", "calibrate", change)


def failed(view: Any) -> Any:
    first, *others = view["steps"]
    return {**view, "steps": [{**first, "status": "failed", "message": MOVED}, *others], "current": first["id"]}


def judged(view: Any) -> Any:
    rest, free, weak, *others = view["steps"]
    done = [{**step, "status": "done"} for step in (rest, free, weak)]
    done[-1]["message"] = WEAK
    return {**view, "steps": [*done, *others], "current": weak["id"]}


def lacking(view: Any) -> Any:
    each = [{**step, "status": "waiting"} if i in (2, 4) else step for i, step in enumerate(view["steps"])]
    return {**view, "steps": each, "result": None}


def sits_otherwise(offer: str, **sits: Arrangement) -> Open:
    """Return what opens a result in which the ring of the right elbow sits otherwise than on other people."""

    def open_place(page: Any, clinic: EyesClinic) -> None:
        ring = next(channel.ring for channel in LAYOUT.channels if channel.joint == "right_elbow" and channel.ring)
        of_ring = {how: {ring: arrangement} for how, arrangement in sits.items()}
        clinic.set_calibration("result", lambda profile: taught_by_others(profile, 3, ["right_elbow"], **of_ring))
        steps(opened("calibrate"), shows(f'text="{offer}"'))(page, clinic)

    return open_place


CALIBRATE_PLACES: dict[str, Open] = {
    "calibrate, begin anew": steps(
        calibration_at("result"), opened("calibrate"), tapped("Begin anew"), shows(".toast")
    ),
    "calibrate, failed": steps(viewed(failed), shows(f"text={MOVED}")),
    "calibrate, judged": steps(viewed(judged), shows(f"text={WEAK}")),
    "calibrate, drive now": steps(
        viewed(lambda view: {**view, "may_drive_now": True, "others": 12}), shows(".drive-now")
    ),
    "calibrate, fitting": steps(
        calibration_at("result"),
        viewed(lambda view: {**view, "running": {"step": "result", "t": 0.0}}),
        shows(".working"),
    ),
    "calibrate, missing": steps(calibration_at("result"), viewed(lacking)),
    "calibrate, turned": sits_otherwise("It sits right", arrangement=Arrangement(shift=3)),
    "calibrate, mirrored": sits_otherwise("It sits right", arrangement=Arrangement(mirrored=True)),
    "calibrate, as worn": sits_otherwise("Treat it as turned", as_worn=Arrangement(shift=3)),
}
