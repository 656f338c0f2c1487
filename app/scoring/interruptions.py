"""Interruptions of a trial: when the chair was not permitted to move, why, and the trial without that time.

A tick's state decides over the time since the tick before.
"""

from collections.abc import Mapping
from functools import reduce
from itertools import pairwise
from typing import Final, Literal, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from app.faults import PEOPLE_STOPS, Fault, State
from app.scoring.measures import MeasureValues
from app.texts import Figure, Text

Numbers = NDArray[np.float64]
Kind = Literal["machine", "pause", "person"]

MOST_HALTS: Final = 1  # by the machine, pauses included; with more, a trial counts only when a person confirms it
LARGEST_SHARE: Final = 0.1  # of the trial's time that the machine may have taken
STANDING: Final = 1e-9  # m and rad between two ticks; the virtual chair that stands does not move at all
POSE: Final = ("x", "y", "theta")


class Interruption(NamedTuple):
    """A time within a trial in which the chair was not permitted to move."""

    kind: Kind
    at: float  # s of permitted motion before it
    duration: float  # s, with the check for rest that ended it


def interruptions(t: ArrayLike, state: ArrayLike, fault: ArrayLike) -> list[Interruption]:
    """Return the interruptions of a trial, in the order of time.

    Parameters
    ----------
    t
        (n,) s, from the first row in which motion was permitted.
    state, fault
        (n,) `State` and `Fault` of each row. A fault without a latched state is a pause.
    """
    times, states, faults = (np.asarray(column) for column in (t, state, fault))
    dt = np.diff(times, prepend=times[:1])
    permitted = states == State.ARMED
    kinds = _kinds(states.tolist(), faults.tolist())
    edges = [0, *(np.flatnonzero(np.array(kinds[1:], dtype=object) != np.array(kinds[:-1], dtype=object)) + 1).tolist()]
    all_interruptions = []
    for first, end in pairwise([*edges, len(kinds)]):
        kind = kinds[first]
        if kind is not None:
            before = float(dt[:first][permitted[:first]].sum())
            all_interruptions.append(Interruption(kind, before, float(dt[first:end].sum())))
    return all_interruptions


def _kinds(states: list[int], faults: list[int]) -> list[Kind | None]:
    """Return for each row what interrupts the trial; None: nothing, or its end.

    After Continue, the check for rest belongs to the interruption before; so does a fault of that check.
    """
    kinds: list[Kind | None] = []
    kind: Kind | None = None
    for state, fault in zip(states, faults, strict=True):
        if state == State.ARMED:
            kind = None
        elif fault != Fault.NONE and not (kind is not None and fault == Fault.NOT_NEUTRAL):
            kind = "pause" if state != State.FAULT else "person" if Fault(fault) in PEOPLE_STOPS else "machine"
        kinds.append(kind)
    return kinds


def driven_rows(columns: Mapping[str, Numbers]) -> dict[str, Numbers]:
    """Return the rows in which the chair was permitted to move or still ran out, as if no wait had been between.

    Parameters
    ----------
    columns
        (n,) each: t (s), x, y (m), theta (rad), state, and others.

    Returns
    -------
    dict
        The rows, with `t` without the waits, and two columns more: `permitted` (0 or 1), and `restart`, 1 where the
        chair has not moved since an interruption. Speed is zero on both sides of a wait that was left out.
    """
    permitted = columns["state"] == State.ARMED
    stands = np.all([np.abs(np.diff(columns[name], prepend=columns[name][:1])) < STANDING for name in POSE], axis=0)
    waits = ~permitted & stands
    dt = np.diff(columns["t"], prepend=columns["t"][:1])
    t = columns["t"][0] + np.cumsum(np.where(waits, 0.0, dt))
    restart = permitted & stands & _since_interruption(permitted, stands)
    rows = {**columns, "t": t, "permitted": permitted.astype(np.float64), "restart": restart.astype(np.float64)}
    return {name: column[~waits] for name, column in rows.items()}


def _since_interruption(permitted: NDArray[np.bool_], stands: NDArray[np.bool_]) -> NDArray[np.bool_]:
    """Return (n,) whether the newest row without permission is newer than the newest permitted row with motion."""
    row = np.arange(len(permitted))
    interrupted = np.maximum.accumulate(np.where(permitted, -1, row))
    moved = np.maximum.accumulate(np.where(permitted & ~stands, row, -1))
    return interrupted > moved


def interruption_measures(all_interruptions: list[Interruption], time: float, *, reached: bool) -> MeasureValues:
    """Return count and duration (s) of the interruptions, by kind, in the trial's first `time` s of permitted motion.

    `reached`: the trial was done after `time`; an interruption that began then is after it.
    """
    counted = [interruption for interruption in all_interruptions if interruption.at < time or not reached]
    measures: MeasureValues = {}
    kinds: dict[Kind, tuple[str, str]] = {
        "machine": ("halts", "halt_time"),
        "pause": ("pauses", "pause_time"),
        "person": ("person_stops", "person_stop_time"),
    }
    for kind, (count, duration) in kinds.items():
        durations = [interruption.duration for interruption in counted if interruption.kind == kind]
        measures |= {count: len(durations), duration: float(sum(durations))}
    lost = measures["halt_time"] + measures["pause_time"]
    often = measures["halts"] + measures["pauses"] > MOST_HALTS
    return {**measures, "interrupted": bool(often or lost > LARGEST_SHARE * (time + lost))}


MACHINE_KINDS: Final = (("halted", "halts", "halt_time"), ("paused", "pauses", "pause_time"))
PERSON_KIND: Final = ("stopped", "person_stops", "person_stop_time")


def interruptions_of(measures: MeasureValues | None) -> MeasureValues:
    """Return count and duration (s) of the interruptions in a trial's measures, of those kinds that there were."""
    if measures is None:
        return {}
    kinds = [(count, duration) for _, count, duration in (*MACHINE_KINDS, PERSON_KIND) if measures.get(count)]
    return {name: measures.get(name) for kind in kinds for name in kind}


def interruption_text(measures: MeasureValues | None) -> Text | None:
    """Return the interruptions of a trial as text, such as "halted 3 times, 14 s"; None when there was none."""
    return _listed(measures or {}, *MACHINE_KINDS, PERSON_KIND)


def reason_to_ask(measures: MeasureValues) -> Text | None:
    """Return why a trial counts only when a person confirms it, None when it counts."""
    if not measures.get("interrupted"):
        return None
    return Text("interruptions-asked", interruptions=_listed(measures, *MACHINE_KINDS) or "")


def _listed(measures: MeasureValues, *kinds: tuple[str, str, str]) -> Text | None:
    parts = [
        Text(f"interruption-{what}", times=times, seconds=Figure(measures.get(duration) or 0.0))
        for what, count, duration in kinds
        if (times := int(measures.get(count) or 0))
    ]
    return (
        reduce(lambda before, after: Text("interruptions-several", before=before, after=after), parts)
        if parts
        else None
    )
