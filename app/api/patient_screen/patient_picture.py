"""The picture for the patient's screen, 20 times a second: what to do and where the chair is, but no personal data."""

from typing import Any

from app.api.live.live_picture import LivePicture
from app.calibration.script import movement_words
from app.faults import Fault, State
from app.session.equipment.shirt import Equipment
from app.session.runs import SessionRuns
from app.session.trial import TrialFlow
from app.session.words.patient_words import patient_words
from app.store.patient_screens import ScreenSettings

FIELDS = ("tick", "t", "state", "control", "v", "pose", "contacts", "stops", "practice", "test")
TRIAL_FIELDS = ("id", "t", "done", "length", "stage", "stages", "instruction", "target", "movers")


class PatientPicture:
    """Makes the patient's picture from the clinician's, so that both show the same moment."""

    def __init__(self, live: LivePicture, equipment: Equipment, runs: SessionRuns, trials: TrialFlow) -> None:
        self._live = live
        self._equipment = equipment
        self._runs = runs
        self._trials = trials
        self.settings = ScreenSettings()  # of the open session

    def picture(self) -> dict[str, Any]:
        """Return the current picture."""
        live = self._live.picture()
        fault, trial = live["fault"], live["trial"]
        over, drives = self._trials.last_end, trial is not None or live["drive"] is not None
        words = patient_words(
            State[live["state"].upper()],
            Fault.NONE if fault is None else Fault[fault["name"].upper()],
            drives=drives,
            shirt_alive=live["shirt"]["alive"],
        )
        return {
            **{name: live[name] for name in FIELDS},
            "fault": fault and {"name": fault["name"], "words": words.happened},
            "waits": {"for": words.actor, "words": words.wait},
            "trial": trial and {name: trial[name] for name in TRIAL_FIELDS},
            "drives": drives,
            "cue": self._cue(live["run"]),
            "over": None if over is None else {"id": over.id, "end": over.end},
            "asks": self.settings.model_dump(),
        }

    def _cue(self, run_picture: dict[str, Any] | None) -> dict[str, Any] | None:
        run = self._runs.open
        if run is None or run_picture is None or run_picture["cue"] is None or run_picture["t"] is None:
            return None
        cue = run.cues[run_picture["cue"]]
        after = run.cues[run_picture["cue"] + 1 :][:1]
        return {
            "index": run_picture["cue"],
            "kind": cue.kind,
            "movement": self._movement(cue.joint),
            "t": round(run_picture["t"] - cue.start, 3),
            "length": round(cue.end - cue.start, 3),
            "next": after[0].kind if after else None,
        }

    def _movement(self, joint: str | None) -> str | None:
        layout = self._equipment.layout
        if joint is None or layout is None:
            return None
        return next((movement_words(known) for known in layout.joints if known.name == joint), None)
