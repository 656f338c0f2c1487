"""The reports of a real chair, in words for the pages."""

import math
from typing import Any

import numpy as np

from app.hardware.chair.reasons import WORDS, Reason
from app.pipeline.safety_gate import CHAIR_SILENT

STATES = ("disarmed", "checking", "armed", "fault")
CHAIR_FAULT = 3  # index of "fault" in STATES


def fault_sentence(fault: int) -> str:
    """Return the sentence for the fault number of a chair whose state is "fault"."""
    if fault == Reason.NONE or fault not in WORDS:
        return "The chair reports a fault that this program does not know."
    return WORDS[Reason(fault)]


def is_silent(tick: np.void) -> bool:
    """Return whether the chair has sent nothing for longer than CHAIR_SILENT at this tick."""
    return not float(tick["chair_age"]) <= CHAIR_SILENT


def chair_report(tick: np.void) -> dict[str, Any]:
    """Return the fields of a real chair in a tick (`app.messages.TICK`) for the live picture."""
    state, fault = int(tick["chair_state"]), int(tick["chair_fault"])
    if is_silent(tick):
        words = "The chair does not answer: check its power and the network."
    elif state == CHAIR_FAULT:
        words = fault_sentence(fault)
    else:
        words = "" if fault == Reason.NONE else fault_sentence(fault)
    return {
        "kind": "udp",
        "state": STATES[min(state, CHAIR_FAULT)],
        "age": _number(tick["chair_age"]),
        "battery": _number(tick["battery"]),
        "stop_input": bool(tick["stop_input"]),
        "v": _number(tick["driven_v"]) or 0.0,
        "omega": _number(tick["driven_omega"]) or 0.0,
        "words": words,
    }


def closed_chair_report(words: str) -> dict[str, Any]:
    """Return the fields of `chair_report` for a chair that was chosen and could not be opened."""
    return {
        "kind": "udp",
        "state": STATES[0],
        "age": None,
        "battery": None,
        "stop_input": False,
        "v": 0.0,
        "omega": 0.0,
        "words": words,
    }


def _number(value: Any) -> float | None:
    number = float(value)
    return round(number, 3) if math.isfinite(number) else None
