"""Streams of the Lab Streaming Layer as a shirt: one, or several that are joined by their clocks."""

from collections.abc import Callable
from typing import Annotated, Literal

from pydantic import Field

from app.arrivals import Arrivals
from app.clock import Clock
from app.hardware.base import HardwareError
from app.hardware.shirt.arrival_watch import GOOD, WAITING, ArrivalWatch
from app.hardware.shirt.kind import (
    HIGHEST_RATE,
    LOWEST_RATE,
    FieldTexts,
    OwnLayout,
    ShirtConfig,
    ShirtKind,
    SourceFacts,
    Trust,
    page_texts,
)
from app.hardware.shirt.lsl_reception import LOOK, OpenStream, ReceivedStream, opened_stream
from app.hardware.shirt.lsl_streams import (
    CRITERIA,
    StreamFacts,
    channels_of,
    chosen_streams,
    layout_of,
    sought_of,
    streams_in,
)
from app.hardware.shirt.stream_join import GridRows, LedRows, Row, Rows, StreamSamples
from app.layout import ShirtLayout
from app.lsl_library import LSL_MISSING, LslInfo, LslLibrary, load_lsl, lsl_ahead
from app.messages import ALIVE, SensorFrame
from app.quantities import Hertz, Line
from app.texts import Figure, Text

LOOKS = 2  # for streams, of LOOK seconds each, at the opening
SETTLE_EVERY = 1.0  # s between two readings of the clocks' differences

SoughtText = Annotated[Line, Field(min_length=1, max_length=200)] | None


class LslConfig(ShirtConfig):
    """Streams of the Lab Streaming Layer, such as of an amplifier or of motion capture."""

    model_config = page_texts(
        Text("shirtdev-lsl-title"),
        about=Text("shirtdev-lsl-about"),
        in_use=Text("shirtdev-lsl-in-use"),
        facts=SourceFacts(Text("shirtdev-lsl-needs"), Text("shirtdev-lsl-costs"), Text("shirtdev-lsl-takes")),
    )

    kind: Literal["lsl"]
    # What the stream must have; of several values, between commas, each names a stream. None: anything.
    name: Annotated[SoughtText, FieldTexts(Text("shirtdev-lsl-name"), Text("shirtdev-lsl-name-hint"))] = None
    source_id: Annotated[SoughtText, FieldTexts(Text("shirtdev-lsl-source"))] = None
    type: Annotated[SoughtText, FieldTexts(Text("shirtdev-lsl-type"))] = None
    host: Annotated[SoughtText, FieldTexts(Text("shirtdev-lsl-host"))] = None
    sample_rate: Annotated[
        Hertz,
        Field(ge=LOWEST_RATE, le=HIGHEST_RATE),
        FieldTexts(Text("shirtdev-rate"), Text("shirtdev-lsl-rate-hint")),
    ] = 50.0
    layout: Annotated[
        OwnLayout | None,
        Field(json_schema_extra={"format": "layout"}),
        FieldTexts(Text("shirtdev-layout"), Text("shirtdev-lsl-layout-hint")),
    ] = None  # None: the layout that the streams describe


class LslShirt:
    """Receives the streams that people chose; each row of all their channels is a frame.

    The fastest regular stream leads, and each of its samples makes a frame. Streams without a rate alone are put on a
    grid. A stream that is lost is looked for, and goes on with its next start on the same machine.
    """

    def __init__(self, config: LslConfig, clock: Clock, load: Callable[[], LslLibrary] = load_lsl) -> None:
        self.sample_rate = config.sample_rate
        self._config = config
        self._clock = clock
        self._load = load
        self._layout = config.layout
        self._lsl: LslLibrary | None = None
        self._streams: list[ReceivedStream] = []
        self._rows: Rows | None = None
        self._ahead = 0.0  # s by which LSL's clock is ahead of `clock`
        self._settle_at = 0.0  # s
        self._watch = ArrivalWatch()

    @property
    def layout(self) -> ShirtLayout:
        """Names and joints of the channels: of the configuration, or as the streams describe them once open."""
        if self._layout is None:
            raise HardwareError(Text("shirtdev-lsl-closed"))
        return self._layout

    @property
    def lost(self) -> int:
        """Frames that are missing by the times of the samples since the shirt was opened."""
        return 0 if self._rows is None else self._rows.lost

    def open(self) -> None:
        """Look for the streams and open them.

        Raises
        ------
        HardwareError
            When they are not there, several fit, one does not answer, or they do not fit the layout.
        """
        self.close()
        try:
            lsl = self._lsl = self._load()
        except LSL_MISSING as error:
            raise HardwareError(Text("shirtdev-lsl-no-library")) from error
        opened = [self._opened(lsl, facts, info) for facts, info in self._chosen(lsl)]
        described = layout_of([(stream.facts, channels_of(stream.info)) for stream in opened])
        self._layout = self._config.layout or described
        count, named = len(described.channels), len(self._layout.channels)
        if count != named:
            raise HardwareError(Text("shirtdev-lsl-misfit", channels=count, named=named))
        self._settle(lsl)
        self._watch = ArrivalWatch(self._clock.now())
        self._begin(lsl, opened)

    def read(self, timeout: float) -> SensorFrame | None:
        """Return the next frame, waiting for it at most `timeout` (s)."""
        deadline, wait = self._clock.now() + timeout, 0.0
        while True:
            row = self._next_row()
            if row is None:
                self._receive(wait)
                row = self._next_row()
            now = self._clock.now()
            if row is not None:
                self._watch.accept(now)
                return SensorFrame(row.seq & 0xFFFFFFFF, row.t, now, row.values)
            if now >= deadline:
                return None
            wait = deadline - now

    def pending(self) -> bool:
        """Return whether another frame seems to have arrived already."""
        if self._rows is None:
            return False
        stream, wait = self._rows.wait(self._lsl_time())
        return wait <= 0.0 if stream is None else self._streams[stream].may_have_more

    def description(self) -> Text:
        """Return the shirt's state in words."""
        if self._rows is None:
            return Text("shirtdev-lsl-closed")
        if self._clock.now() - self._watch.accepted_t > ALIVE:
            return Text("shirtdev-lsl-silent", streams=[stream.facts.text for stream in self._streams])
        age = self._lsl_time() - max(stream.samples.newest for stream in self._streams)
        return Text(
            "shirtdev-lsl",
            sensors=len(self.layout.channels),
            rate=round(self.sample_rate, 2),
            age=Figure(max(0.0, 1000.0 * age)),
            lost=self.lost,
            gone=self._lost_streams or "none",
        )

    def arrivals(self) -> Arrivals:
        """Return what arrives from the streams."""
        if self._rows is None:
            return Arrivals("gone", self.description())
        verdict, lost = self._watch.verdict(self._clock.now()), self._lost_streams
        message = GOOD if verdict == "arrives" else WAITING
        if verdict == "nothing":
            verdict = "gone" if lost else verdict
            streams = lost or [stream.facts.text for stream in self._streams]
            message = Text("arrivals-lsl-silent", streams=streams, ended="yes" if lost else "no")
        return Arrivals(verdict, message, self._watch.accepted)

    def close(self) -> None:
        """Release the streams; closing twice does no harm."""
        streams, self._streams, self._rows = self._streams, [], None
        for stream in streams:
            stream.close()

    @property
    def _lost_streams(self) -> list[Text]:
        """The streams whose senders have ended, in words."""
        return [stream.facts.text for stream in self._streams if stream.is_lost]

    def _chosen(self, lsl: LslLibrary, looks: int = LOOKS) -> list[tuple[StreamFacts, LslInfo]]:
        """Return the streams that people seek; HardwareError when it is not clear which they are."""
        sought = sought_of({name: getattr(self._config, name) for name in CRITERIA})
        visible = streams_in(lsl, lsl.resolve_streams(LOOK))
        try:
            return [(facts, visible[facts]) for facts in chosen_streams(sorted(visible), sought)]
        except HardwareError:
            if looks == 1:
                raise
        return self._chosen(lsl, looks - 1)

    def _opened(self, lsl: LslLibrary, facts: StreamFacts, info: LslInfo) -> OpenStream:
        try:
            return opened_stream(lsl, facts, info)
        except RuntimeError as error:
            raise HardwareError(Text("shirtdev-lsl-no-answer", stream=facts.text)) from error

    def _begin(self, lsl: LslLibrary, opened: list[OpenStream]) -> None:
        """Begin to make rows of the streams."""
        rates = [stream.facts.rate for stream in opened]
        self.sample_rate = fastest = max(rates) or self._config.sample_rate
        if not LOWEST_RATE <= fastest <= HIGHEST_RATE:
            limits = {"low": LOWEST_RATE, "high": HIGHEST_RATE}
            raise HardwareError(Text("shirtdev-lsl-rate", rate=round(fastest, 2), **limits))
        for stream in opened:
            rate = stream.facts.rate
            samples = StreamSamples(stream.facts.channels, rate or self._config.sample_rate, is_regular=rate > 0.0)
            self._streams.append(ReceivedStream(lsl, stream, samples, self._lsl_time))
        received = [stream.samples for stream in self._streams]
        self._rows = LedRows(received, rates.index(fastest)) if fastest in rates else GridRows(received, fastest)

    def _next_row(self) -> Row | None:
        return None if self._rows is None else self._rows.next(self._lsl_time())

    def _receive(self, longest: float) -> None:
        """Take over what has come, waiting at most `longest` (s) for what the next row needs."""
        lsl, rows = self._lsl, self._rows
        if lsl is None or rows is None:
            self._clock.sleep_until(self._clock.now() + longest)
            return
        now = self._lsl_time()
        if now >= self._settle_at:
            self._settle(lsl)
        awaited, wait = rows.wait(now)
        wait = min(wait, longest)
        if awaited is None or self._streams[awaited].is_lost:
            self._clock.sleep_until(self._clock.now() + wait)
        else:
            self._streams[awaited].take(wait)
        for number, stream in enumerate(self._streams):
            if number != awaited:
                stream.take()
            stream.follow_search()

    def _settle(self, lsl: LslLibrary) -> None:
        """Read anew by how much the clocks differ."""
        self._ahead = lsl_ahead(lsl, self._clock)
        self._settle_at = self._lsl_time() + SETTLE_EVERY
        for stream in self._streams:
            stream.settle()

    def _lsl_time(self) -> float:
        return self._clock.now() + self._ahead


KIND = ShirtKind(LslConfig, LslShirt, Trust.NEVER)
