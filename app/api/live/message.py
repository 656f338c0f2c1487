"""The messages of the live sockets; the types of the pages are made from these models (`make api-types`).

Lengths in m, angles in rad, times in s. A number that is not known is None.
"""

from typing import Literal

from pydantic import BaseModel, ConfigDict, Field

from app.arrivals import ArrivalVerdict
from app.session.chair_messages import ChairMoment, StateName
from app.texts import Text

Number = float | None
TestPhase = Literal["ready", "running", "over"]


class MessagePart(BaseModel):
    """A part of a message."""

    model_config = ConfigDict(frozen=True, extra="forbid", serialize_by_alias=True)


class FaultMessage(MessagePart):
    """A fault in words."""

    name: str
    happened: Text
    next_step: Text
    remedy: Text = Field(description="The next step without the word of the button.")


class HeadMoment(MessagePart):
    """The direction of the head, and the age of that report."""

    yaw: Number
    pitch: Number
    roll: Number
    age: Number


class ShirtMoment(MessagePart):
    """The shirt in use."""

    chosen: bool = False
    alive: bool = False
    sample_rate: float = Field(0.0, description="Hz")
    lost: int = Field(0, description="Frames missing in the shirt's own count.")
    age: Number = Field(None, description="Of the newest frame.")


class RunMoment(MessagePart):
    """The recording that is being made."""

    kind: str
    t: Number
    cue: int | None


class TrialMoment(MessagePart):
    """A trial that runs."""

    id: int
    waits: Number = Field(description="For how much longer a halted or paused trial waits; None: it is neither.")
    paused: FaultMessage | None = Field(description="Why it is paused, and goes on by itself.")
    pauses: int
    measuring: bool = Field(description="Whether it is over and is being measured.")
    t: Number
    done: Number = Field(description="Length driven along the path.")
    length: Number = Field(description="Of the path.")
    cross_track: Number
    e_diff: Number = Field(description="m²")
    leader_distance: Number
    movers: list[list[Number]] = Field(description="The pose of each.")
    leader: list[Number] | None = Field(description="Its pose.")
    stage: int = Field(description="From 0.")
    stages: int
    kind: str
    title: Text
    instruction: Text
    target: list[float] = Field(description="Where the path ends.")


class DriveMoment(MessagePart):
    """A drive of a real chair."""

    id: int
    t: Number
    waits: Number


class TestMoment(MessagePart):
    """An interface test that runs; lengths in arms of its cross, ahead and to the left."""

    id: int
    phase: TestPhase
    remaining: Number = Field(description="Until the first target, then until the end.")
    cursor: list[Number]
    target: list[Number] | None
    radius: Number = Field(description="Of the target.")
    dwell: Number = Field(description="Share of the time for which the cursor must stay in the target.")
    acquired: int
    missed: int


class CommonMessage(MessagePart):
    """What the sockets of clinicians and of the patient's screen have in common."""

    tick: int = Field(0, description="Number of the tick; 0 without a control process.")
    t: Number
    state: StateName
    control: str = Field(description='"alive", or why the control process does not answer.')
    v: Number = Field(0.0, description="m/s")
    pose: list[Number] = Field([0.0, 0.0, 0.0], description="x, y, heading")
    contacts: int = 0
    stops: int = 0
    practice: str | None = Field(description="Kind of the shirt in use when nobody wears it.")
    test: TestMoment | None = None


class LiveMessage(CommonMessage):
    """What clinicians get. Without the other fields, no chair moves and nobody is shown."""

    fault: FaultMessage | None
    u1: Number = 0.0
    u2: Number = 0.0
    omega: Number = Field(0.0, description="rad/s")
    scene_t: Number = 0.0
    head: HeadMoment | None = None
    in_contact: bool = False
    gestures: list[str] = []
    score: list[Number] = Field([], description="Of each gesture, as are `rate` and `activation`.")
    rate: list[Number] = []
    activation: list[Number] = []
    values: list[Number] | None = Field(None, description="Of each channel in the newest frame.")
    shirt: ShirtMoment = ShirtMoment()
    dial: float = Field(1.0, description="Share of the speed limits.")
    chair: ChairMoment | None = None
    run: RunMoment | None = None
    trial: TrialMoment | None = None
    drive: DriveMoment | None = None
    session: int | None = Field(None, description="The open session.")
    hidden: bool = Field(False, description="Whether a patient is left out, whom the viewer may not see.")

    def without_patient(self) -> "LiveMessage":
        """Return what those may see who may not see the patient: the chair's state and the program's, for Stop."""
        return LiveMessage(
            tick=self.tick,
            t=self.t,
            state=self.state,
            fault=self.fault,
            control=self.control,
            stops=self.stops,
            practice=self.practice,
            hidden=True,
        )


class ArrivalsMoment(MessagePart):
    """What arrives at the shirt."""

    verdict: ArrivalVerdict
    message: Text | str = Field(description="What is so, and what to do.")
    accepted: int = Field(description="Frames, or samples, that have counted since the shirt was opened.")
    left_out: int = Field(description="Packets, messages or pieces of a stream that have not.")


class Quality(MessagePart):
    """What clinicians get once a second, in the same message."""

    quality: list[str] = Field(description="The condition of each channel.")
    noise: list[Number] = Field(description="Of each channel, in units of its signal.")
    shirt_words: Text | str = Field(description="The state of the shirt.")
    arrivals: ArrivalsMoment | None = Field(None, description="None: there is no shirt, or it does not say.")
