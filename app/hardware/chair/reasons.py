"""Why a chair stands, by its telemetry: numbers for the protocol, English for a receiver. Standard library only."""

from enum import IntEnum


class Reason(IntEnum):
    """The fault code of the telemetry; the numbers are part of the protocol and never change."""

    NONE = 0
    SILENT = 1  # no valid newer command for too long
    STOP_COMMAND = 2  # a command with the stop flag
    WITHDRAWN = 3  # the sender withdrew its permission to drive
    STOP_INPUT = 4
    NOT_NEUTRAL = 5  # no zero commands after a new epoch
    LATE = 6  # the receiver itself was held up
    OUTPUT = 7  # the receiver's output accepts no commands
    ENDING = 8  # the receiver was ended
    OWN_JOYSTICK = 9  # somebody moved the chair's own joystick
    CHAIR_ERROR = 10  # the chair reports an error of its own
    CHAIR_OFF = 11  # the chair is switched off


# For the output of a receiver, which has no catalogue; the pages have the message chairdev-reason.
DESCRIPTIONS = {
    Reason.NONE: "Nothing is wrong.",
    Reason.SILENT: "No new command reached the chair for too long.",
    Reason.STOP_COMMAND: "The chair received a stop.",
    Reason.WITHDRAWN: "The sender withdrew its permission to drive.",
    Reason.STOP_INPUT: "The chair was stopped by its own switch.",
    Reason.NOT_NEUTRAL: "After it was armed, the chair was not commanded to stand for the half second that it needs.",
    Reason.LATE: "The chair's own computer stood still for too long.",
    Reason.OUTPUT: "The chair's electronics accepted no commands.",
    Reason.ENDING: "The chair's receiver was ended.",
    Reason.OWN_JOYSTICK: "Somebody moved the chair's own joystick.",
    Reason.CHAIR_ERROR: "The chair reports an error of its own: look at its display.",
    Reason.CHAIR_OFF: "The chair is switched off.",
}
