"""What the patient's screen is told, 20 times a second: what to do, where the chair is, and nothing of who is here."""

from typing import Any

from app.api.live.picture import LivePicture
from app.calibration.script import movement_words
from app.faults import Fault, State
from app.session.equipment.shirt import Equipment
from app.session.runs import Runs
from app.session.trial import TrialFlow
from app.session.words.patient_words import patient_words
from app.store.patient_screens import ScreenSettings

SAID = ("tick", "t", "state", "control", "v", "pose", "contacts", "stops", "practice")
SAID_OF_TRIAL = ("id", "t", "done", "length", "stage", "stages", "instruction", "target", "movers")


class PatientPicture:
    """Makes the patient's picture out of the clinician's, so that both show the same moment in the same way."""

    def __init__(self, shown: LivePicture, equipment: Equipment, runs: Runs, trials: TrialFlow) -> None:
        self._shown = shown
        self._equipment = equipment
        self._runs = runs
        self._trials = trials
        self.settings = ScreenSettings()  # of the session that goes on

    def picture(self) -> dict[str, Any]:
        """Return the message of this moment."""
        shown = self._shown.picture()
        fault, trial = shown["fault"], shown["trial"]
        over, drives = self._trials.last_end, trial is not None or shown["drive"] is not None
        words = patient_words(
            State[shown["state"].upper()],
            Fault.NONE if fault is None else Fault[fault["name"].upper()],
            drives=drives,
            shirt_alive=shown["shirt"]["alive"],
        )
        return {
            **{name: shown[name] for name in SAID},
            "fault": fault and {"name": fault["name"], "words": words.happened},
            "waits": {"for": words.actor, "words": words.wait},
            "trial": trial and {name: trial[name] for name in SAID_OF_TRIAL},
            "drives": drives,
            "cue": self._cue(shown["run"]),
            "over": None if over is None else {"id": over.id, "end": over.end},
            "asks": self.settings.model_dump(),
        }

    def _cue(self, shown: dict[str, Any] | None) -> dict[str, Any] | None:
        run = self._runs.open
        if run is None or shown is None or shown["cue"] is None or shown["t"] is None:
            return None
        cue = run.cues[shown["cue"]]
        after = run.cues[shown["cue"] + 1 :][:1]
        return {
            "index": shown["cue"],
            "kind": cue.kind,
            "movement": self._movement(cue.joint),
            "t": round(shown["t"] - cue.start, 3),
            "length": round(cue.end - cue.start, 3),
            "next": after[0].kind if after else None,
        }

    def _movement(self, joint: str | None) -> str | None:
        layout = self._equipment.layout
        if joint is None or layout is None:
            return None
        return next((movement_words(known) for known in layout.joints if known.name == joint), None)
