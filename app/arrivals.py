"""What arrives at a shirt: a verdict, with a sentence that says what to do, and counts."""

from typing import Any, Literal, NamedTuple

from app.texts import Text, from_document

ArrivalVerdict = Literal[
    "arrives",  # signals, as they should
    "waiting",  # nothing, for too short a time to say why
    "nothing",  # nothing at all
    "foreign",  # what is no frame of this shirt
    "refused",  # frames that are not signed with the shirt's key
    "late",  # frames that are too old
    "repeated",  # frames that were used before
    "disk",  # frames that do not count, because the number of the newest one cannot be stored
    "senders",  # frames of another sender
    "rate",  # frames at another rate than the one that is set
    "partial",  # signals of some sensors on the body, and none of others
    "unplaced",  # signals of sensors that are on no part of the body
    "moving",  # signals of sensors that were not at rest yet
    "idle",  # signs of life of sensors, and no movement; of a camera, one picture again and again
    "nobody",  # pictures without a person
    "unopened",  # nothing, for the device cannot be opened
    "gone",  # nothing more: the device is gone, or was closed
    "ended",  # nothing more: a file was played to its end
]


class Arrivals(NamedTuple):
    """What arrives at a shirt."""

    verdict: ArrivalVerdict
    message: Text | str  # what is so, and what to do
    accepted: int = 0  # frames, or samples, that have counted since the shirt was opened
    left_out: int = 0  # packets, messages or pieces of a stream that have not


def arrivals_from(document: dict[str, Any] | None) -> Arrivals | None:
    """Return what the status of the control process says of arrivals; None when it says nothing."""
    return None if document is None else Arrivals(**{**document, "message": from_document(document["message"])})
