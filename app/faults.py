"""The states of the safety gate, and all faults with their explanations."""

from enum import IntEnum
from typing import Final, NamedTuple


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

CONTINUE = ", then tap Continue."  # how the next step of a halted trial or drive ends


class Explanation(NamedTuple):
    """The explanation of a fault: what happened, and what to do next."""

    happened: str
    next_step: str

    @property
    def remedy(self) -> str:
        """What to do next, without "tap Continue": that button exists only during a trial or a drive."""
        return self.next_step.replace(CONTINUE, ".")


EXPLANATIONS: dict[Fault, Explanation] = {
    Fault.NONE: Explanation("Nothing is wrong.", "Go on."),
    Fault.STOP_TABLET: Explanation("Stop was pressed on the screen.", "Look around, then tap Continue."),
    Fault.STOP_GESTURE: Explanation("The patient made the stop gesture.", "Ask the patient, then tap Continue."),
    Fault.STOP_KEY: Explanation("Stop was pressed on the keyboard.", "Look around, then tap Continue."),
    Fault.NOT_NEUTRAL: Explanation(
        "The body was not at rest within 5 seconds.",
        "Ask the patient to rest, or raise “Counts from” of the active movement in Controls, then tap Continue.",
    ),
    Fault.SHIRT_SILENT: Explanation(
        "The shirt stopped sending, or its signals come too late.",
        "Check its battery and cable on the Shirt page, then tap Continue.",
    ),
    Fault.SHIRT_LOSSY: Explanation(
        "More than a tenth of the shirt's signals were lost.",
        "Bring the shirt's transmitter closer, then tap Continue.",
    ),
    Fault.CHANNELS_BAD: Explanation(
        "Sensors of two movements gave impossible values.",
        "See the lamps on the Shirt page; repeat the calibration without the bad sensors.",
    ),
    Fault.WEB_SILENT: Explanation(
        "The program sent nothing to the control process.",
        "Wait for the page to return, then start again.",
    ),
    Fault.SCREEN_LOST: Explanation(
        "The screen that started the drive sent nothing for 0.3 s: "
        "it was out of reach or overloaded, or its page was closed.",
        "See that this screen is connected and shows the page, then tap Continue.",
    ),
    Fault.SCREEN_HIDDEN: Explanation(
        "The page that started the drive was hidden or left.",
        "Bring it to the front and leave it there, then tap Continue.",
    ),
    Fault.SCREEN_SLOW: Explanation(
        "The page that started the drive stood still for too long, and Stop could not be pressed on it.",
        "Close other pages and programs on that screen, or make its window smaller, then tap Continue.",
    ),
    Fault.BAD_NUMBER: Explanation(
        "A command was not a number.", "Do not drive; repeat the calibration and report this."
    ),
    Fault.LOOP_LATE: Explanation(
        "The control loop stood still for too long.",
        "Close other programs on this machine, then tap Continue.",
    ),
    Fault.RECORDING_LOST: Explanation(
        "The recording could not be written.", "Free some disk space, then start a new trial."
    ),
    Fault.CONTROL_LOST: Explanation(
        "The control process ended, and the chair stands.",
        "A new one is starting, disarmed; then start again.",
    ),
    Fault.STOP_CHAIR: Explanation(
        "The chair's own stop switch was pressed, or the chair reports a fault.",
        "Look around, release the switch, then tap Continue.",
    ),
    Fault.CHAIR_SILENT: Explanation(
        "The chair no longer answers; it stops by itself.",
        "Check the chair's power and the network, then tap Continue.",
    ),
    Fault.CHAIR_DISARMED: Explanation(
        "The chair disarmed itself: too few commands reached it in time.",
        "Bring the chair nearer to the network, then tap Continue.",
    ),
    Fault.CHAIR_NOT_READY: Explanation(
        "The chair did not become ready within 5 seconds.",
        "See on the Chair page what it says, then tap Continue.",
    ),
    Fault.SHIRT_RATE: Explanation(
        "The shirt sends more or fewer signals per second than is set for it.",
        "Set its true rate on the Shirt page and calibrate again.",
    ),
    Fault.NO_MOVEMENT: Explanation(
        "The signals changed as no body moves: by jumps, as evenly as a machine, or in all joints alike.",
        "See that the shirt's plugs are firm and its cable hangs free, let the patient rest, then tap Continue.",
    ),
    Fault.BRAKE_BAD: Explanation(
        "A sensor of the movement that brakes or stops gave impossible values.",
        "See the lamps on the Shirt page; repeat the calibration without the bad sensors.",
    ),
    Fault.PICTURE_LOST: Explanation(
        "A screen lost the picture that the patient drives by.",
        "Wait until the picture is back, or choose the drawn plan, then tap Continue.",
    ),
}
