"""The screen of the person who started the trial or drive: when it goes out of view or is lost, the chair stops.

It is not the patient's screen, whose silence is in `app/api/patient_screen/patient_socket.py`.
"""

from app.api.live.screen_pictures import ScreenPictures
from app.api.live.screens import SILENCE_LIMIT, VIRTUAL_SILENCE_LIMIT, PageSign, Screen, Screens
from app.clock import monotonic
from app.session.control_link import ControlLink, ScreenSign
from app.session.real_drive import RealDriveFlow
from app.session.trial import TrialFlow


class DrivingScreen:
    """Finds the last report of the screen that drives, and stops the chair when that screen goes out of view."""

    def __init__(
        self,
        control: ControlLink,
        trials: TrialFlow,
        drives: RealDriveFlow,
        screens: Screens,
        pictures: ScreenPictures,
    ) -> None:
        self._control = control
        self._trials = trials
        self._drives = drives
        self._screens = screens
        self._pictures = pictures

    def sign(self) -> ScreenSign:
        """Return the last report of the screen that started the trial or drive; may be called from any thread."""
        drive, trial = self._drives.current, self._trials.current  # read once each: they may end meanwhile
        going_on = drive or trial
        if going_on is None:
            return ScreenSign()
        limit = VIRTUAL_SILENCE_LIMIT if drive is None else SILENCE_LIMIT
        screen = Screen(going_on.person_id, going_on.screen)
        sign = self._screens.sign(screen, monotonic(), limit)
        is_late = drive is None and sign.view == "in view" and self._pictures.is_late(screen)
        return ScreenSign(sign.age, "slow") if is_late else sign

    def report(self, screen: Screen, sign: PageSign) -> bool:
        """Store the report of a screen, unless another socket reports for that screen; return whether it was stored.

        When the screen that drives goes out of view, stop the chair by a heartbeat at once.
        """
        before = self.sign()
        is_taken = self._screens.report(screen, sign)
        if before.view == "in view" != self.sign().view:
            self._control.beat()
        return is_taken

    def lost(self, screen: Screen, socket: object) -> None:
        """Remove a screen whose socket has ended; when it is the one that drives, the chair stops."""
        before = self.sign()
        self._screens.remove(screen, socket)
        if before.age is not None and self.sign().age is None:
            self._control.beat()
