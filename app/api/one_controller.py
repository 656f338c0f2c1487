"""One controller at a time: only the person who armed continues and ends; everybody else may look, and stop."""

from dataclasses import dataclass

from fastapi import HTTPException
from starlette.requests import HTTPConnection

from app.api.live.screens import Screen
from app.api.nearby import require_nearby
from app.api.parts import WebParts
from app.api.sign_in.identity import SignedInPerson

ANOTHER = "Somebody else started this drive, and only they go on or end it here: you can stop it, and ask them."


@dataclass(frozen=True, slots=True)
class Controller:
    """The person who started the running trial or drive."""

    person_id: int
    real: bool


def controller_of(web: WebParts) -> Controller | None:
    """Return who started the running trial or drive, None when there is none."""
    drive, trial = web.drives.current, web.trials.current
    if drive is not None:
        return Controller(drive.person_id, real=True)
    return None if trial is None else Controller(trial.person_id, real=False)


def require_controller(web: WebParts, who: SignedInPerson) -> Controller | None:
    """Raise 409 unless this person started the running trial or drive; return None when there is none."""
    controller = controller_of(web)
    if controller is not None and controller.person_id != who.person_id:
        raise HTTPException(409, ANOTHER)
    return controller


def require_hand_on_chair(web: WebParts, who: SignedInPerson, connection: HTTPConnection) -> None:
    """Refuse to set the chair in motion, unless this person started the drive and, for a real chair, is nearby."""
    controller = require_controller(web, who)
    if controller is not None and controller.real:
        require_nearby(connection)


def require_picture(web: WebParts) -> None:
    """Raise 409 when a screen of the running trial has no picture to drive by."""
    trial = web.trials.current
    refusal = "" if trial is None else web.pictures.refusal(Screen(trial.person_id, trial.screen))
    if refusal:
        raise HTTPException(409, refusal)
