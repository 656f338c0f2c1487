"""One stream of the Lab Streaming Layer as it is received, and the search for it when it is lost."""

import threading
from collections.abc import Callable, Iterable
from contextlib import suppress
from typing import Any, NamedTuple

from app.hardware.shirt.lsl_streams import StreamFacts, streams_in
from app.hardware.shirt.stream_join import StreamSample, StreamSamples
from app.lsl_library import LslInfo, LslInlet, LslLibrary

LOOK = 1.0  # s for which streams may answer a look for them
ANSWER = 1.5  # s for which a chosen stream may take to each answer
LOOK_AGAIN = 0.5  # s between two looks for a lost stream
SEARCH_AFTER = 2.0  # s of silence of a regular stream, after which it may have been started again
BUFFER = 10  # s of samples that liblsl keeps while the loop is held up; of a stream without a rate 1,000 samples
AT_ONCE = 256  # samples that are taken over in one call
LARGEST_STAMP = 1e12  # s: 30,000 years; a time stamp beyond it is none


class OpenStream(NamedTuple):
    """A stream that is received."""

    facts: StreamFacts
    inlet: LslInlet
    info: LslInfo
    correction: float  # s: added to the sender's time stamps, it gives this machine's LSL clock


class StreamSearch(threading.Thread):
    """Looks for a stream that was started again, and opens it, so that the loop never waits for the network.

    Only a stream from the same machine with equal facts counts, and only while there is one such stream.
    """

    def __init__(self, lsl: LslLibrary, facts: StreamFacts) -> None:
        super().__init__(name="LSL search", daemon=True)
        self.found: list[OpenStream] = []  # one, once it is open
        self._lsl = lsl
        self._facts = facts
        self._given_up = threading.Event()

    def run(self) -> None:
        """Look until the stream is found, or nobody wants it any more."""
        while not self._given_up.is_set():
            try:
                visible = streams_in(self._lsl, self._lsl.resolve_streams(LOOK))
                restarts = [facts for facts in visible if facts.is_restart_of(self._facts)]
                if len(restarts) == 1:
                    self.found.append(opened_stream(self._lsl, restarts[0], visible[restarts[0]]))
                    return
            except RuntimeError:
                pass  # lost again meanwhile
            self._given_up.wait(LOOK_AGAIN)

    def give_up(self) -> None:
        """Look no more."""
        self._given_up.set()


class ReceivedStream:
    """One stream as it is received: its samples, on this machine's LSL clock, and the search for it when it is lost."""

    def __init__(self, lsl: LslLibrary, opened: OpenStream, samples: StreamSamples, now: Callable[[], float]) -> None:
        """`now` returns this machine's LSL time (s)."""
        self.facts = opened.facts
        self.samples = samples
        self._lsl = lsl
        self._inlets = [opened.inlet]  # empty while the stream is lost
        self._correction = opened.correction
        self._now = now
        self._heard = now()  # s, when the newest sample came
        self._search: StreamSearch | None = None

    @property
    def is_lost(self) -> bool:
        """Whether its sender has ended, and was not found again."""
        return not self._inlets

    @property
    def may_have_more(self) -> bool:
        """Whether a sample seems to have come."""
        return any(inlet.samples_available() > 0 for inlet in self._inlets)

    def take(self, wait: float = 0.0) -> None:
        """Take over the samples that have come; with `wait` (s), wait that long for the next one."""
        if self._inlets and not self._pull(self._inlets[0], wait):
            self._drop()

    def settle(self) -> None:
        """Read anew by how much the sender's clock differs, if that was measured again."""
        for inlet in self._inlets:
            with suppress(RuntimeError):
                self._correction = inlet.time_correction(0.0)

    def follow_search(self) -> None:
        """Search for the stream while it is lost or silent, and go on with what was found."""
        is_silent = self.is_lost or (self.samples.is_regular and self._now() - self._heard > SEARCH_AFTER)
        if not is_silent:
            self.end_search()
        elif self._search is None:
            self._search = StreamSearch(self._lsl, self.facts)
            self._search.start()
        elif self._search.found:
            (found,) = self._search.found
            self._search.found.clear()
            self._search = None
            self._drop()
            self.facts, self._correction, self._heard = found.facts, found.correction, self._now()
            self._inlets = [found.inlet]

    def end_search(self) -> None:
        """Search no more."""
        search, self._search = self._search, None
        if search is not None:
            search.give_up()
            end(search.found)

    def close(self) -> None:
        """Receive no more."""
        self.end_search()
        self._drop()

    def _pull(self, inlet: LslInlet, wait: float) -> bool:
        """Take over samples of the inlet; False when its sender has ended."""
        try:
            if wait > 0.0:
                values, stamp = inlet.pull_sample(wait)
                if values is None or stamp is None:
                    return True
                self._add(values, stamp)
            for values, stamp in zip(*inlet.pull_chunk(0.0, AT_ONCE), strict=True):
                self._add(values, stamp)
        except RuntimeError:
            return False
        return True

    def _add(self, values: Iterable[float], stamp: float) -> None:
        self._heard = now = self._now()
        if abs(stamp) <= LARGEST_STAMP:  # false for NaN
            self.samples.add(StreamSample(stamp + self._correction, tuple(values), now))

    def _drop(self) -> None:
        inlets, self._inlets = self._inlets, []
        end(inlets)


def opened_stream(lsl: LslLibrary, facts: StreamFacts, info: LslInfo) -> OpenStream:
    """Begin to receive a stream; raise RuntimeError when it does not answer in time."""
    # liblsl's own recovery would go on with an equal stream of any machine.
    inlet = lsl.StreamInlet(info, max_buflen=BUFFER, max_chunklen=1, recover=False)
    inlet.open_stream(ANSWER)
    return OpenStream(facts, inlet, inlet.info(ANSWER), inlet.time_correction(ANSWER))


def end(inlets: list[Any]) -> None:
    """End inlets in a thread, for that may take half a second; nobody else may refer to them."""
    if inlets:
        threading.Thread(target=inlets.clear, name="LSL end", daemon=True).start()
