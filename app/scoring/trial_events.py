"""The events of a recorded trial: armed, stops, faults, contacts, the goal."""

from typing import Any, Literal

import numpy as np
from numpy.typing import NDArray

from app.faults import EXPLANATIONS, PEOPLE_STOPS, Fault, State
from app.quantities import Document
from app.recording.reader import Columns

EventKind = Literal["checking", "armed", "stop", "fault", "disarmed", "contact", "goal"]

ONE_CONTACT = 0.5  # s; a touch within this time after a contact's beginning belongs to that contact
WORDS = {
    "checking": "The check for rest began.",
    "armed": "Motion was permitted.",
    "disarmed": "Motion was permitted no more.",
    "contact": "The chair touched something.",
    "goal": "The goal was reached.",
}


class Event(Document):
    """An event of a trial."""

    t: float  # s since motion was first permitted
    kind: EventKind
    words: str


def events_of(columns: Columns, t: NDArray[np.float64], end: str | None) -> list[Event]:
    """Return the events of a trial in the order of time.

    Parameters
    ----------
    columns
        Of the whole recording: `state`, `fault` and `contacts`, (n,) each.
    t
        (n,) s, times of the rows; the events' times are taken from them.
    end
        How the trial ended; "goal" adds the event of reaching the goal, at the last row with motion permitted.
    """
    events = _state_events(columns, t) + _contacts(columns["contacts"], t)
    armed = np.flatnonzero(columns["state"] == State.ARMED)
    if end == "goal" and len(armed):
        events.append(_event(t[armed[-1]], "goal"))
    return sorted(events, key=lambda event: event.t)


def _state_events(columns: Columns, t: NDArray[np.float64]) -> list[Event]:
    state = columns["state"]
    changes = np.flatnonzero(np.diff(state, prepend=np.uint8(State.DISARMED)))
    return [_state_event(int(state[row]), int(columns["fault"][row]), t[row]) for row in changes]


def _state_event(state: int, fault: int, t: float) -> Event:
    if state != State.FAULT:
        kinds: dict[int, EventKind] = {
            State.DISARMED: "disarmed",
            State.CHECKING: "checking",
            State.ARMED: "armed",
        }
        return _event(t, kinds[state])
    why = Fault(fault)
    return _event(t, "stop" if why in PEOPLE_STOPS else "fault", EXPLANATIONS[why].happened)


def _contacts(contacts: NDArray[Any], t: NDArray[np.float64]) -> list[Event]:
    events: list[Event] = []
    for row in np.flatnonzero(np.diff(contacts.astype(np.int64), prepend=0) > 0):
        if not events or t[row] - events[-1].t > ONE_CONTACT:
            events.append(_event(t[row], "contact"))
    return events


def _event(t: float, kind: EventKind, words: str = "") -> Event:
    return Event(t=round(float(t), 3), kind=kind, words=words or WORDS[kind])
