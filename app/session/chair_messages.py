"""What a real chair reports of itself, as the pages show it."""

import math
from typing import Literal, get_args

import numpy as np
from pydantic import BaseModel, ConfigDict

from app.hardware.chair.link_texts import reason_text
from app.hardware.chair.reasons import Reason
from app.pipeline.safety_gate import CHAIR_SILENT
from app.texts import Text

StateName = Literal["disarmed", "checking", "armed", "fault"]
ChairState = Literal["silent", StateName]
STATE_NAMES: tuple[StateName, ...] = get_args(StateName)  # by their number: of `app.faults.State`, and of a chair
CHAIR_FAULT = 3  # index of "fault" in STATE_NAMES


def fault_sentence(fault: int) -> Text:
    """Return the sentence for the fault number of a chair whose state is "fault"."""
    return reason_text(fault) or Text("visit-chair-unknown-fault")


def is_silent(tick: np.void) -> bool:
    """Return whether the chair has sent nothing for longer than CHAIR_SILENT at this tick."""
    return not float(tick["chair_age"]) <= CHAIR_SILENT


class ChairMoment(BaseModel):
    """What a real chair reports of itself; without the other fields, of a chair that could not be opened."""

    model_config = ConfigDict(frozen=True, extra="forbid")

    kind: str = "udp"
    state: ChairState = "silent"  # also when its last report is too old
    age: float | None = None  # s, of the report
    battery: float | None = None  # share
    stop_input: bool = False
    own_joystick: bool = False  # whether somebody moves it
    v: float = 0.0  # m/s
    omega: float = 0.0  # rad/s
    measured: bool = False  # whether the chair measures these speeds; otherwise its receiver commands them
    message: Text | str  # empty when there is nothing to say


def chair_report(tick: np.void) -> ChairMoment:
    """Return the fields of a real chair in a tick (`app.messages.TICK`)."""
    state, fault = int(tick["chair_state"]), int(tick["chair_fault"])
    message: Text | str = ""
    if is_silent(tick):
        message = Text("visit-chair-silent")
    elif state == CHAIR_FAULT or fault != Reason.NONE:
        message = fault_sentence(fault)
    return ChairMoment(
        state="silent" if is_silent(tick) else STATE_NAMES[min(state, CHAIR_FAULT)],
        age=_number(tick["chair_age"]),
        battery=_number(tick["battery"]),
        stop_input=bool(tick["stop_input"]),
        own_joystick=bool(tick["own_joystick"]),
        v=_number(tick["driven_v"]) or 0.0,
        omega=_number(tick["driven_omega"]) or 0.0,
        measured=bool(tick["measured"]),
        message=message,
    )


def _number(value: float) -> float | None:
    number = float(value)
    return round(number, 3) if math.isfinite(number) else None
