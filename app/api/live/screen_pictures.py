"""The picture that each screen shows to drive by: 3D view, drawn plan or none. Nobody drives blind (S24)."""

from typing import Literal

from app.api.live.screens import Screen
from app.faults import State
from app.session.control_link import ControlLink
from app.session.trial import TrialFlow
from app.texts import Text

Picture = Literal["view", "plan", "none"]
ScreenPicture = Picture | Literal["late"]  # late: older than what can be driven by; it pauses a trial (S7)

MAY_MOVE = frozenset({State.CHECKING, State.ARMED})
NO_PICTURE = Text("api-no-picture")
NO_PICTURE_FOR_PATIENT = Text("api-no-picture-for-patient")
PATIENTS_SCREEN_AWAY = Text("api-patients-screen-away")


class ScreenPictures:
    """Keeps the last picture report of each screen, by its socket, and halts a trial without a picture.

    A screen that never reported counts as one with a picture: a program may drive over the API.
    """

    def __init__(self, control: ControlLink, trials: TrialFlow) -> None:
        self._control = control
        self._trials = trials
        self._screens: dict[object, tuple[Screen, ScreenPicture]] = {}
        self._late: frozenset[Screen] = frozenset()  # replaced as a whole: the heartbeat's thread reads it
        self._patients: dict[object, tuple[int, Picture]] = {}
        self._away: dict[int, int] = {}  # the patient's screens that are out of reach -> the trial that lost them

    def of_screen(self, screen: Screen, picture: ScreenPicture, socket: object) -> None:
        """Store the report of the screen of a person who is signed in; one socket at a time reports for a screen."""
        for other in [
            known_socket
            for known_socket, (shown_screen, _) in self._screens.items()
            if shown_screen == screen and known_socket is not socket
        ]:
            del self._screens[other]  # a dead socket that was never closed: its last report is outdated
        self._screens[socket] = (screen, picture)
        self._note_late()
        self._halt_if_blind()

    def of_patient(self, screen_id: int, picture: Picture, socket: object) -> bool:
        """Store the report of one of the patient's screens; return whether it differs from the last one."""
        is_news = self._patients.get(socket) != (screen_id, picture)
        self._away.pop(screen_id, None)
        self._patients[socket] = (screen_id, picture)
        self._halt_if_blind()
        return is_news

    def forget(self, socket: object) -> None:
        """Forget the screen of a socket that has ended; a lost screen of the patient halts the trial."""
        self._screens.pop(socket, None)
        self._note_late()
        lost, trial = self._patients.pop(socket, None), self._trials.current
        if lost is not None and trial is not None:
            screen_id = lost[0]
            if screen_id not in self.patients():  # no other socket reports for it
                self._away[screen_id] = trial.id
            self._halt()

    def unpair(self, screen_id: int) -> None:
        """Forget one of the patient's screens for good: no trial waits for it."""
        for socket in [
            known_socket for known_socket, (shown_screen, _) in self._patients.items() if shown_screen == screen_id
        ]:
            self.forget(socket)
        self._away.pop(screen_id, None)

    def patients(self) -> dict[int, Picture]:
        """Return the picture of each of the patient's screens by its id."""
        return dict(self._patients.values())

    def is_late(self, screen: Screen) -> bool:
        """Return whether this screen's picture is late; from any thread."""
        return screen in self._late

    def _note_late(self) -> None:
        self._late = frozenset(screen for screen, picture in self._screens.values() if picture == "late")

    def refusal(self, screen: Screen) -> Text | None:
        """Return why nobody may drive from this screen, in a sentence; None when there is a picture."""
        return NO_PICTURE if self.is_late(screen) else self._blindness(screen)

    def _blindness(self, screen: Screen) -> Text | None:
        if (screen, "none") in self._screens.values():
            return NO_PICTURE
        if "none" in self.patients().values():
            return NO_PICTURE_FOR_PATIENT
        trial = self._trials.current
        return PATIENTS_SCREEN_AWAY if trial is not None and trial.id in self._away.values() else None

    def _halt_if_blind(self) -> None:
        # Checked with every report, not only with a changed one: a trial may begin, or go on, between two reports.
        trial = self._trials.current
        if trial is not None and self._blindness(Screen(trial.person_id, trial.screen)):
            self._halt()

    def _halt(self) -> None:
        tick = self._control.newest()
        if tick is not None and State(int(tick["state"])) in MAY_MOVE:
            self._control.begin_stop("picture")
