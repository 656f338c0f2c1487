"""The picture for the patient's screen, 20 times a second: what to do and where the chair is, but no personal data."""

from pydantic import ConfigDict, Field

from app.api.live.live_picture import LivePicture
from app.api.live.message import CommonMessage, MessagePart, Number, RunMoment
from app.api.live.picture_sender import PictureSender
from app.calibration.script import movement_instruction
from app.faults import Fault, State
from app.session.equipment.shirt import Equipment
from app.session.patient_messages import Actor, patient_message
from app.session.runs import SessionRuns
from app.session.trial import TrialFlow
from app.store.patient_screens import ScreenSettings
from app.texts import Text


class PatientFault(MessagePart):
    """A fault in words for the patient."""

    name: str
    message: Text


class Waiting(MessagePart):
    """Who has to do something before the chair moves, and the words to say so."""

    model_config = ConfigDict(populate_by_name=True)

    actor: Actor = Field(alias="for")
    message: Text


class PatientTrial(MessagePart):
    """A trial that runs."""

    id: int
    t: Number
    done: Number
    length: Number
    stage: int
    stages: int
    instruction: Text
    target: list[float]
    movers: list[list[Number]]


class PatientCue(MessagePart):
    """A cue of a calibration."""

    index: int
    kind: str
    movement: str | None = Field(description="In words.")
    t: float = Field(description="Since its start.")
    length: float = Field(description="s")
    next: str | None = Field(description="Kind of the cue after it.")


class TrialEnd(MessagePart):
    """The trial that has ended last."""

    id: int
    end: str


class PatientMessage(CommonMessage):
    """What the patient's screen gets."""

    fault: PatientFault | None
    waits: Waiting
    trial: PatientTrial | None
    drives: bool
    cue: PatientCue | None
    over: TrialEnd | None
    camera: bool = Field(description="Whether the shirt in use is a camera, which this screen may be.")
    asks: ScreenSettings = Field(description="What the clinician wants this screen to show.")


class PatientPicture:
    """Makes the patient's picture from the clinician's, so that both show the same moment."""

    def __init__(self, live: LivePicture, equipment: Equipment, runs: SessionRuns, trials: TrialFlow) -> None:
        self._live = live
        self._equipment = equipment
        self._runs = runs
        self._trials = trials
        self.settings = ScreenSettings()  # of the open session

    def picture(self) -> PatientMessage:
        """Return the current picture."""
        live = self._live.picture()
        fault, over, drives = live.fault, self._trials.last_end, live.trial is not None or live.drive is not None
        message = patient_message(
            State[live.state.upper()],
            Fault.NONE if fault is None else Fault[fault.name.upper()],
            drives=drives,
            shirt_alive=live.shirt.alive,
        )
        common = {name: getattr(live, name) for name in CommonMessage.model_fields}
        return PatientMessage(
            **common,
            fault=None if fault is None else PatientFault(name=fault.name, message=message.happened or ""),
            waits=Waiting(actor=message.actor, message=message.wait),
            trial=None
            if live.trial is None
            else PatientTrial(**{name: getattr(live.trial, name) for name in PatientTrial.model_fields}),
            drives=drives,
            cue=self._cue(live.run),
            over=None if over is None else TrialEnd(id=over.id, end=over.end),
            camera=self._equipment.is_camera,
            asks=self.settings,
        )

    def _cue(self, shown: RunMoment | None) -> PatientCue | None:
        run = self._runs.open
        if run is None or shown is None or shown.cue is None or shown.t is None:
            return None
        cue = run.cues[shown.cue]
        after = run.cues[shown.cue + 1 :][:1]
        return PatientCue(
            index=shown.cue,
            kind=cue.kind,
            movement=self._movement(cue.joint),
            t=round(shown.t - cue.start, 3),
            length=round(cue.end - cue.start, 3),
            next=after[0].kind if after else None,
        )

    def _movement(self, joint: str | None) -> str | None:
        layout = self._equipment.layout
        if joint is None or layout is None:
            return None
        return next(
            (str(movement_instruction(layout_joint)) for layout_joint in layout.joints if layout_joint.name == joint),
            None,
        )


class PatientLive(PictureSender[PatientMessage]):
    """Sends the picture of the patient's screens."""
