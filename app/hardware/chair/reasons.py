"""Why a chair stands, as its receiver tells: numbers on the wire, words for people. Standard library only."""

from enum import IntEnum


class Reason(IntEnum):
    """The fault code of the telemetry; the numbers are part of the protocol, so they never change."""

    NONE = 0
    SILENT = 1  # no valid newer command for too long
    TOLD_TO_STOP = 2  # a command with the stop flag
    WITHDRAWN = 3  # the sender took back its permission to drive
    STOP_INPUT = 4
    NOT_NEUTRAL = 5  # no zero commands after a new epoch
    LATE = 6  # the receiver itself was held up
    OUTPUT = 7  # what the receiver drives does not take commands
    ENDING = 8  # somebody ended the receiver


WORDS = {
    Reason.NONE: "Nothing is wrong.",
    Reason.SILENT: "The chair heard no new command for too long.",
    Reason.TOLD_TO_STOP: "The chair was told to stop.",
    Reason.WITHDRAWN: "The sender withdrew its permission to drive.",
    Reason.STOP_INPUT: "The chair was stopped by its own switch.",
    Reason.NOT_NEUTRAL: "The chair was not commanded to stand for half a second after it was armed.",
    Reason.LATE: "The chair's own computer was held up for too long.",
    Reason.OUTPUT: "The chair's electronics took no commands.",
    Reason.ENDING: "The chair's receiver was ended.",
}
