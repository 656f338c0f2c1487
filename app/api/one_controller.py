"""One controller at a time: only the person who armed continues and ends; everybody else may look, and stop."""

from dataclasses import dataclass
from typing import Annotated

from fastapi import Depends, HTTPException
from starlette.requests import HTTPConnection

from app.api.live.screen_pictures import ScreenPictures
from app.api.live.screens import Screen
from app.api.nearby import require_nearby
from app.api.parts import parts_for
from app.api.sign_in.identity import SignedInPerson
from app.session.real_drive import RealDriveFlow
from app.session.trial import TrialFlow
from app.texts import Text

ANOTHER = Text("api-another-controller")


@dataclass(frozen=True, slots=True)
class Controller:
    """The person who started the running trial or drive."""

    person_id: int
    real: bool


@dataclass(frozen=True, slots=True)
class DriveAuthority:
    """Who may go on with the running trial or drive, and end it."""

    trials: TrialFlow
    drives: RealDriveFlow
    pictures: ScreenPictures

    def controller(self) -> Controller | None:
        """Return who started the running trial or drive, None when there is none."""
        drive, trial = self.drives.current, self.trials.current
        if drive is not None:
            return Controller(drive.person_id, real=True)
        return None if trial is None else Controller(trial.person_id, real=False)

    def require_controller(self, person: SignedInPerson) -> Controller | None:
        """Raise 409 unless this person started the running trial or drive; return None when there is none."""
        controller = self.controller()
        if controller is not None and controller.person_id != person.person_id:
            raise HTTPException(409, ANOTHER)
        return controller

    def require_hand_on_chair(self, person: SignedInPerson, connection: HTTPConnection) -> None:
        """Refuse to set the chair in motion, unless this person started the drive and, for a real chair, is nearby."""
        controller = self.require_controller(person)
        if controller is not None and controller.real:
            require_nearby(connection)

    def require_picture(self) -> None:
        """Raise 409 when a screen of the running trial has no picture to drive by."""
        trial = self.trials.current
        refusal = None if trial is None else self.pictures.refusal(Screen(trial.person_id, trial.screen))
        if refusal is not None:
            raise HTTPException(409, refusal)


Authority = Annotated[DriveAuthority, Depends(parts_for(DriveAuthority))]
