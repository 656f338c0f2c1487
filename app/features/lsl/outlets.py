"""What is sent over LSL: the streams with their descriptions, the ticks as samples, and the marks that ticks make.

`docs/protocols.md`, section 15, has the streams. No network, no clock.
"""

from collections.abc import Callable, Iterable, Mapping, Sequence
from enum import IntEnum
from typing import Any, Final, NamedTuple

import numpy as np
from numpy.typing import NDArray

from app import __version__
from app.cues import Cue
from app.faults import Fault, State, is_pause
from app.lsl_library import OWN_SOURCE, LslLibrary, LslOutlet
from app.messages import NO_CUE

TICKS: Final = (
    *(("u1", "1"), ("u2", "1"), ("v", "m/s"), ("omega", "rad/s"), ("x", "m"), ("y", "m"), ("theta", "rad")),
    *(("driven_v", "m/s"), ("driven_omega", "rad/s"), ("dial", "1"), ("state", "code"), ("fault", "code")),
    *(("in_contact", "1"), ("run", "number"), ("frame_seq", "number"), ("lost", "number")),
)
"""The channels of the stream of ticks, fields of `app.messages.TICK`, with their units."""
GESTURE: Final = (("score", "FS"), ("rate", "FS/s"), ("activation", "1"))
"""What the stream of gestures has of each gesture, with its unit; FS is the calibrated full scale."""
IRREGULAR: Final = 0.0  # in place of a nominal rate: the loop also makes ticks without a frame
CODES: Final[Mapping[str, type[IntEnum]]] = {"state": State, "fault": Fault}
"""The channels whose values are codes; the description of the stream has what each means."""

Ticks = NDArray[np.void]


class OutletStream(NamedTuple):
    """A stream that is sent."""

    name: str
    kind: str
    channels: tuple[tuple[str, str], ...]  # each with its unit
    is_text: bool = False


def ticks_stream() -> OutletStream:
    """Return the stream of ticks."""
    return OutletStream("bodydrive ticks", "Control", TICKS)


def gestures_stream(names: Iterable[str]) -> OutletStream:
    """Return the stream of the gestures of these names."""
    channels = tuple((f"{field}.{name}", unit) for field, unit in GESTURE for name in names)
    return OutletStream("bodydrive gestures", "Gestures", channels)


def markers_stream() -> OutletStream:
    """Return the stream of markers."""
    return OutletStream("bodydrive markers", "Markers", (("marker", "none"),), is_text=True)


def opened_outlet(lsl: LslLibrary, stream: OutletStream, machine: str) -> LslOutlet:
    """Begin to send a stream from this machine."""
    source = f"{OWN_SOURCE}{stream.name.rpartition(' ')[2]}.{machine}"
    form = lsl.cf_string if stream.is_text else lsl.cf_double64
    info = lsl.StreamInfo(stream.name, stream.kind, len(stream.channels), IRREGULAR, form, source)
    root = info.desc()
    channels = root.append_child("channels")
    for label, unit in stream.channels:
        channel = channels.append_child("channel")
        for name, value in (("label", label), ("unit", unit), ("type", stream.kind)):
            channel.append_child_value(name, value)
    coded = [label for label, _ in stream.channels if label in CODES]
    if coded:
        meanings = root.append_child("codes")
        for label in coded:
            of_channel = meanings.append_child(label)
            for code in CODES[label]:
                of_channel.append_child_value(code.name.lower(), str(code.value))
    acquisition = root.append_child("acquisition")
    for name, value in (("manufacturer", "bodydrive"), ("version", __version__)):
        acquisition.append_child_value(name, value)
    return lsl.StreamOutlet(info)


def tick_samples(ticks: Ticks) -> NDArray[np.float64]:
    """Return the samples (n, channels) of ticks (n,)."""
    return _samples([ticks[name] for name, _ in TICKS])


def gesture_samples(ticks: Ticks, count: int) -> NDArray[np.float64]:
    """Return the samples (n, channels) of the gestures of ticks (n,), `count` of them."""
    return _samples([ticks[name][:, i] for name, _ in GESTURE for i in range(count)])


def _samples(columns: Sequence[NDArray[Any]]) -> NDArray[np.float64]:
    return np.ascontiguousarray(np.column_stack(columns), dtype=np.float64)


class Mark(NamedTuple):
    """A moment to be marked: a run begins or ends, a cue comes into force, motion is refused or permitted again."""

    t: float  # s, of the tick
    what: str  # start, end, cue, stop, fault, pause or clear
    run: int  # its number
    code: int = 0  # index of the cue, or number of the fault


class MarkFinder:
    """Finds the marks in the ticks of one control process after the other."""

    def __init__(self) -> None:
        self._run, self._cue, self._fault = 0, NO_CUE, int(Fault.NONE)
        self._stops: int | None = None  # None: not known yet

    def marks(self, ticks: Ticks) -> list[Mark]:
        """Return the marks of the next ticks (n,), in order."""
        if not len(ticks):
            return []
        fields = np.column_stack([ticks[name].astype(np.int64) for name in ("run", "cue", "fault", "stops")])
        before = [[self._run, self._cue, self._fault, fields[0, 3] if self._stops is None else self._stops]]
        changed = np.flatnonzero((fields != np.concatenate((before, fields[:-1]))).any(axis=1))
        found = [mark for i in changed for mark in self._of(ticks[i])]
        self._stops = int(fields[-1, 3])
        return found

    def control_lost(self, t: float) -> list[Mark]:
        """Return the marks of the end of the control process, noticed at `t` (s); a new one counts anew."""
        found = [Mark(t, "end", self._run)] if self._run else []
        found.append(Mark(t, "fault", self._run, Fault.CONTROL_LOST))
        self._run, self._cue, self._fault, self._stops = 0, NO_CUE, int(Fault.NONE), None
        return found

    def _of(self, tick: np.void) -> list[Mark]:
        t, run, cue, fault = float(tick["t"]), int(tick["run"]), int(tick["cue"]), int(tick["fault"])
        stops, found = int(tick["stops"]), list[Mark]()
        if run != self._run:
            found += [Mark(t, "end", self._run)] if self._run else []
            found += [Mark(t, "start", run)] if run else []
            self._cue = NO_CUE
        if run and cue != self._cue:
            found.append(Mark(t, "cue", run, cue))
        is_again = self._stops is not None and stops != self._stops and fault != Fault.NONE
        if fault != self._fault or is_again:
            found.append(Mark(t, _kind(int(tick["state"]), fault), run, fault))
        self._run, self._cue, self._fault, self._stops = run, cue, fault, stops
        return found


def _kind(state: int, fault: int) -> str:
    if fault == Fault.NONE:
        return "clear"
    if is_pause(state, fault):
        return "pause"
    return "stop" if Fault(fault).name.startswith("STOP_") else "fault"


def marker_text(
    mark: Mark, name_of: Callable[[int], str | None], cue_of: Callable[[int, int], Cue | None]
) -> str | None:
    """Return the text of a mark's marker; None while the name of its run, or its cue, is not known yet."""
    if mark.what in {"start", "end"}:
        name = name_of(mark.run)
        return None if name is None else f"{mark.what} {name}"
    if mark.what == "cue":
        if mark.code == NO_CUE:
            return "cue none"
        cue = cue_of(mark.run, mark.code)
        if cue is None:
            return None
        return " ".join(["cue", cue.kind, *([cue.joint, str(cue.repetition)] if cue.joint else [])])
    return mark.what if mark.what == "clear" else f"{mark.what} {Fault(mark.code).name.lower()}"
