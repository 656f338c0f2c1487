"""Sends ticks, gestures and markers over LSL, from a thread of the web process that only reads the ring of ticks."""

import asyncio
import logging
import platform
import threading
from collections import deque
from collections.abc import Callable, Sequence
from typing import Final, Protocol

import numpy as np
from numpy.typing import NDArray

from app.clock import Clock, MonotonicClock
from app.cues import Cue
from app.features.lsl.outlets import (
    Mark,
    MarkFinder,
    OutletStream,
    gesture_samples,
    gestures_stream,
    marker_text,
    markers_stream,
    opened_outlet,
    tick_samples,
    ticks_stream,
)
from app.lsl_library import LslLibrary, LslOutlet, load_lsl, lsl_ahead

EVERY: Final = 0.04  # s between two looks at the ticks
NAMED_WITHIN: Final = 1.0  # s for which a marker waits for the name of its run, which the web process stores first
STEADY: Final = 1e-3  # s by which two comparisons of the clocks may differ without a step in the time stamps

logger = logging.getLogger("bodydrive")


class TickSource(Protocol):
    """The control link, as far as its ticks are read; from any thread."""

    def newest(self) -> np.void | None:
        """Return the newest tick, None without a control process."""
        ...

    def since(self, number: int) -> NDArray[np.void] | None:
        """Return the ticks after `number`, None without a control process."""
        ...


class RunNames(Protocol):
    """What the web process knows of the run of a number; from any thread."""

    def name_of(self, run: int) -> str | None:
        """Return the name of a run, such as "trial 12"; None while it is not known."""
        ...

    def cue_of(self, run: int, index: int) -> Cue | None:
        """Return the cue of a run; None while the run is not known."""
        ...

    def gestures(self) -> Sequence[str]:
        """Return the names of the gestures that are decoded now, in the order of a tick's."""
        ...


class LslOutlets:
    """Three streams: ticks, gestures and markers, each sample with the time of its tick on LSL's clock.

    The control process knows nothing of it: a thread here reads the ticks that the ring still holds.
    """

    def __init__(
        self,
        source: TickSource,
        names: RunNames,
        *,
        is_chosen: bool,
        clock: Clock | None = None,
        load: Callable[[], LslLibrary] | None = None,
    ) -> None:
        self._source = source
        self._names = names
        self._is_chosen = is_chosen
        self._clock = clock or MonotonicClock()
        self._load = load or load_lsl
        self._ended = threading.Event()
        self._thread: threading.Thread | None = None

    def start(self) -> None:
        """Begin to send, when people have chosen it."""
        if self._is_chosen:
            self._thread = threading.Thread(target=self._run, name="LSL outlets", daemon=True)
            self._thread.start()

    async def close(self) -> None:
        """Send no more."""
        self._ended.set()
        if self._thread is not None:
            await asyncio.to_thread(self._thread.join)

    def _run(self) -> None:
        is_good = True
        try:
            sender = TickSender(self._load(), self._source, self._names, self._clock)
        except Exception:
            logger.exception("Nothing is sent over LSL")
            return
        while not self._ended.wait(EVERY):
            try:
                sender.send()
                is_good = True
            except Exception:  # the next turn may succeed
                if is_good:
                    logger.exception("Ticks could not be sent over LSL")
                is_good = False


class TickSender:
    """Sends what is new at each call."""

    def __init__(self, lsl: LslLibrary, source: TickSource, names: RunNames, clock: Clock) -> None:
        self._lsl = lsl
        self._source = source
        self._names = names
        self._clock = clock
        self._machine = platform.node()
        self._ahead = lsl_ahead(lsl, clock)  # s
        self._ticks = self._opened(ticks_stream())
        self._markers = self._opened(markers_stream())
        self._gestures: LslOutlet | None = None
        self._gesture_names: tuple[str, ...] = ()
        self._finder = MarkFinder()
        self._marks = deque[Mark]()
        self._run_names: dict[int, str] = {}
        self._number: int | None = None  # of the newest tick that was sent; None: before the first
        newest = source.newest()
        if newest is not None:
            self._number = int(newest["number"])

    def send(self) -> None:
        """Send the ticks, gestures and markers since the last call."""
        self._follow_clock()
        self._follow_gestures()
        ticks = self._new_ticks()
        if len(ticks):
            self._send_ticks(ticks)
            self._marks += self._finder.marks(ticks)
        self._send_markers()

    def _new_ticks(self) -> NDArray[np.void]:
        newest, number = self._source.newest(), self._number
        if newest is None:
            if number is not None:
                self._marks += self._finder.control_lost(self._clock.now())
            self._number = None
            return np.empty(0, dtype=np.void)
        if number is None or int(newest["number"]) < number:  # another control process, which counts from 1
            number = 0
        ticks = self._source.since(number)
        if ticks is None or not len(ticks):
            return np.empty(0, dtype=np.void)
        self._number = int(ticks["number"][-1])
        return ticks

    def _send_ticks(self, ticks: NDArray[np.void]) -> None:
        if self._ticks.have_consumers():
            self._ticks.push_chunk(tick_samples(ticks), self._stamps(ticks))
        outlet, count = self._gestures, len(self._gesture_names)
        if outlet is not None and outlet.have_consumers():
            decoded = ticks[ticks["n_gestures"] == count]  # not those that were made with other parameters
            if len(decoded):
                outlet.push_chunk(gesture_samples(decoded, count), self._stamps(decoded))

    def _send_markers(self) -> None:
        """Send the markers in order, each as soon as the name of its run is known."""
        now = self._clock.now()
        while self._marks:
            mark = self._marks[0]
            text = marker_text(mark, self._name_of, self._names.cue_of)
            if text is None and now - mark.t < NAMED_WITHIN:
                return
            self._marks.popleft()
            if text is None:
                text = f"cue {mark.code}" if mark.what == "cue" else f"{mark.what} run {mark.run}"
            self._markers.push_chunk([[text]], [mark.t + self._ahead])

    def _name_of(self, run: int) -> str | None:
        """Return the name of a run also after its end."""
        name = self._run_names.get(run) or self._names.name_of(run)
        if name is not None:
            self._run_names = {run: name}
        return name

    def _follow_clock(self) -> None:
        """Follow LSL's clock, which stands while the machine sleeps."""
        ahead = lsl_ahead(self._lsl, self._clock)
        if abs(ahead - self._ahead) > STEADY:
            self._ahead = ahead

    def _follow_gestures(self) -> None:
        """Describe the gestures anew when others are decoded; without any, the stream stays without samples."""
        names = tuple(self._names.gestures())
        if names and names != self._gesture_names:
            self._gesture_names = names
            self._gestures = None  # ends before the next one begins: both have one source id
            self._gestures = self._opened(gestures_stream(names))

    def _opened(self, stream: OutletStream) -> LslOutlet:
        return opened_outlet(self._lsl, stream, self._machine)

    def _stamps(self, ticks: NDArray[np.void]) -> list[float]:
        stamps: list[float] = (ticks["t"] + self._ahead).tolist()
        return stamps
