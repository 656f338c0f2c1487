"""The states of the safety gate, and all faults with their explanations."""

from enum import IntEnum
from typing import Final, NamedTuple

from app.texts import Text


class State(IntEnum):
    """Whether motion is permitted."""

    DISARMED = 0
    CHECKING = 1  # neutral check: no motion until all bound gestures were at rest for long enough
    ARMED = 2
    FAULT = 3  # latched: stays until a person clears it


class Fault(IntEnum):
    """The reason for which motion was refused or ended. Recordings contain the numbers, so they never change."""

    NONE = 0
    STOP_TABLET = 1
    STOP_GESTURE = 2
    STOP_KEY = 3
    NOT_NEUTRAL = 4
    SHIRT_SILENT = 5
    SHIRT_LOSSY = 6
    CHANNELS_BAD = 7
    WEB_SILENT = 8
    SCREEN_LOST = 9
    BAD_NUMBER = 10
    LOOP_LATE = 11
    RECORDING_LOST = 12
    CONTROL_LOST = 13  # reported by the web process, because the control process has ended
    STOP_CHAIR = 14
    CHAIR_SILENT = 15
    CHAIR_DISARMED = 16
    CHAIR_NOT_READY = 17
    BRAKE_BAD = 18
    SCREEN_HIDDEN = 19
    SCREEN_SLOW = 20
    PICTURE_LOST = 21
    NO_MOVEMENT = 22
    SHIRT_RATE = 23


def is_pause(state: int, fault: int) -> bool:
    """Return whether the virtual chair waits for its screen: a reason not to move, and nothing latched."""
    return state != State.FAULT and fault != Fault.NONE


PEOPLE_STOPS: Final = frozenset({Fault.STOP_TABLET, Fault.STOP_GESTURE, Fault.STOP_KEY, Fault.STOP_CHAIR})
"""Stops that a person made on purpose; every other fault is a halt by the machine."""

NOT_CONTINUED: Final = frozenset(
    {
        *(Fault.NONE, Fault.CHANNELS_BAD, Fault.WEB_SILENT, Fault.BAD_NUMBER, Fault.RECORDING_LOST),
        *(Fault.CONTROL_LOST, Fault.SHIRT_RATE, Fault.BRAKE_BAD),
    }
)
"""Faults after which a trial or a drive does not go on with Continue."""


class Explanation(NamedTuple):
    """The explanation of a fault: what happened, and what to do next."""

    happened: Text
    remedy: Text  # what to do next, without "tap Continue": that button exists only during a trial or a drive
    next_step: Text  # what to do next during a trial or a drive
    patient: Text  # what happened, in words for the patient


def _explanation(fault: Fault) -> Explanation:
    name = fault.name.lower().replace("_", "-")
    remedy = Text(f"fault-{name}-remedy")
    continued = fault not in NOT_CONTINUED
    next_step = Text("remedy-continue", remedy=remedy) if continued else remedy
    return Explanation(Text(f"fault-{name}"), remedy, next_step, Text(f"fault-{name}-patient"))


EXPLANATIONS: Final = {fault: _explanation(fault) for fault in Fault}
