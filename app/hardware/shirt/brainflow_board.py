"""A board that BrainFlow reads as a shirt: OpenBCI's, and the amplifiers and movement sensors of other makers."""

import threading
from collections import deque
from collections.abc import Callable
from contextlib import suppress
from typing import Annotated, Any, Final, Literal

import numpy as np
from numpy.typing import NDArray
from pydantic import Field
from pydantic.config import JsonDict

from app.arrivals import Arrivals
from app.clock import Clock
from app.hardware.addresses import Host, SerialLine
from app.hardware.base import HardwareError, library_message
from app.hardware.shirt.arrival_watch import GOOD, WAITING, ArrivalWatch, RateMeter
from app.hardware.shirt.brainflow_library import (
    BRAINFLOW_MISSING,
    BoardChannels,
    BrainFlowBoard,
    BrainFlowLibrary,
    board_layout,
    board_number,
    chosen_channels,
    load_brainflow,
)
from app.hardware.shirt.kind import (
    LOWEST_RATE,
    FieldTexts,
    OwnLayout,
    ShirtConfig,
    ShirtKind,
    SourceFacts,
    Trust,
    page_texts,
)
from app.hardware.shirt.page_clock import PageClock
from app.hardware.shirt.stream_join import LONGEST_LAG, LedRows, StreamSample, StreamSamples
from app.layout import ShirtLayout
from app.messages import ALIVE, SensorFrame
from app.quantities import Line, Name, Port
from app.texts import Figure, Text

LOOK: Final = 6  # s for which a board may be looked for; an opening has 8 s
POLL: Final = 0.004  # s between two questions whether samples have come
KEPT: Final = 10.0  # s of samples that BrainFlow keeps
MOST_CHUNKS: Final = 2500  # that wait for a loop that is held up: those of ten seconds
SILENT: Final = 3.0  # s without a sample after which a board is opened anew: a silent shirt has stopped the chair (S4)
REOPEN_AFTER: Final = 2.0  # s before each try
CLOSE_LIMIT: Final = 3.0  # s that a closing waits for BrainFlow, whose calls cannot be broken off
PRESETS: Final = ("default", "auxiliary", "ancillary")  # streams of a board, in the order of BrainFlow's numbers
CAUSES: Final = {1: "port", 2: "port", 3: "port", 4: "port", 7: "missing", 13: "fields", 18: "missing"}
"""What to look at, by BrainFlow's exit codes."""
PARAMETERS: Final = ("serial_port", "mac_address", "ip_address", "ip_port", "serial_number", "other_info")
"""The fields that stand in BrainFlow's parameters by these names."""

BoardText = Annotated[str, Field(min_length=1, max_length=64, pattern=r"^[A-Za-z0-9][A-Za-z0-9_.:-]*$")] | None


def _add_presets(schema: JsonDict) -> None:
    """Add what people call the streams of a board to the JSON schema of a field."""
    schema["titles"] = {
        "default": str(Text("shirtdev-brainflow-preset-default")),
        "auxiliary": str(Text("shirtdev-brainflow-preset-auxiliary")),
        "ancillary": str(Text("shirtdev-brainflow-preset-ancillary")),
    }


class BrainFlowConfig(ShirtConfig):
    """A board of BrainFlow's list, such as of OpenBCI."""

    model_config = page_texts(
        Text("shirtdev-brainflow-title"),
        about=Text("shirtdev-brainflow-about"),
        in_use=Text("shirtdev-brainflow-in-use", board="{board}"),
        facts=SourceFacts(
            Text("shirtdev-brainflow-needs"), Text("shirtdev-brainflow-costs"), Text("shirtdev-brainflow-takes")
        ),
    )

    kind: Literal["brainflow"]
    board: Annotated[Name, FieldTexts(Text("shirtdev-brainflow-board"), Text("shirtdev-brainflow-board-hint"))] = (
        "CYTON_BOARD"
    )
    data: Annotated[
        Annotated[Line, Field(min_length=1, max_length=200)],
        FieldTexts(Text("shirtdev-brainflow-data"), Text("shirtdev-brainflow-data-hint")),
    ] = "accel"
    preset: Annotated[
        Literal["default", "auxiliary", "ancillary"],
        FieldTexts(Text("shirtdev-brainflow-preset"), Text("shirtdev-brainflow-preset-hint")),
    ] = Field(default="default", json_schema_extra=_add_presets)
    # What a board needs of these, BrainFlow's list of boards says; None and port 0: nothing.
    serial_port: Annotated[
        SerialLine | None, FieldTexts(Text("shirtdev-serial-device"), Text("shirtdev-brainflow-needs-hint"))
    ] = None
    mac_address: Annotated[BoardText, FieldTexts(Text("shirtdev-brainflow-mac"))] = None
    ip_address: Annotated[Host | None, FieldTexts(Text("shirtdev-brainflow-ip"))] = None
    ip_port: Annotated[Port, FieldTexts(Text("shirtdev-udp-port"), Text("shirtdev-brainflow-port-hint"))] = 0
    serial_number: Annotated[BoardText, FieldTexts(Text("shirtdev-brainflow-number"))] = None
    other_info: Annotated[BoardText, FieldTexts(Text("shirtdev-brainflow-other"))] = None
    layout: Annotated[
        OwnLayout | None,
        Field(json_schema_extra={"format": "layout"}),
        FieldTexts(Text("shirtdev-layout"), Text("shirtdev-brainflow-layout-hint")),
    ] = None  # None: each kind of data is a joint


class BoardReader(threading.Thread):
    """Takes over from BrainFlow what has come, and opens a board that fell silent anew.

    BrainFlow has one lock for all of its calls, and holds it while it looks for a board; therefore the control loop
    itself never calls BrainFlow.

    Attributes
    ----------
    chunks : deque of (time, samples)
        What has come: when (monotonic s), and the samples (n_rows, n).
    trouble : str
        Why the board was lost, in BrainFlow's words; empty while it is not.
    """

    def __init__(self, board: BrainFlowBoard, kept: int, preset: int, clock: Clock) -> None:
        """`kept` is the number of samples that BrainFlow keeps."""
        super().__init__(name="BrainFlow", daemon=True)
        self.chunks: deque[tuple[float, NDArray[np.float64]]] = deque(maxlen=MOST_CHUNKS)
        self.trouble = ""
        self._board = board
        self._kept = kept
        self._preset = preset
        self._clock = clock
        self._arrived = threading.Event()
        self._ended = threading.Event()

    def connect(self) -> None:
        """Connect the board and let it send; when that raises, nothing is left open."""
        try:
            self._board.prepare_session()
            self._board.start_stream(self._kept)
        except Exception:
            self._release()
            raise

    def run(self) -> None:
        """Take over samples until nobody wants them any more."""
        heard = self._clock.now()
        while not self._ended.wait(POLL):
            try:
                has_samples = self._take_over()
            except Exception as error:  # whatever BrainFlow raises, the board is opened anew
                has_samples, self.trouble = False, library_message(error)
            if has_samples:
                heard, self.trouble = self._clock.now(), ""
            elif self.trouble or self._clock.now() - heard > SILENT:
                self._reconnect()
                heard = self._clock.now()
        self._release()

    def wait(self, longest: float) -> None:
        """Wait at most `longest` (s) for samples; those that have come since the last call end the wait at once."""
        self._arrived.wait(longest)
        self._arrived.clear()

    def end(self) -> None:
        """Take over no more; the board is released at once, or as soon as BrainFlow answers."""
        self._ended.set()
        self.join(CLOSE_LIMIT)

    def _take_over(self) -> bool:
        """Take over what has come; False when nothing has."""
        if not self._board.get_board_data_count(self._preset):
            return False
        samples = self._board.get_board_data(preset=self._preset)
        self.chunks.append((self._clock.now(), samples))
        self._arrived.set()
        return True

    def _reconnect(self) -> None:
        """Release the board, and try to open it again until it is open or nobody wants it any more."""
        self._release()
        while not self._ended.wait(REOPEN_AFTER):
            try:
                self.connect()
            except Exception as error:  # whatever BrainFlow raises, it is tried again
                self.trouble = library_message(error)
            else:
                self.trouble = ""
                return

    def _release(self) -> None:
        with suppress(Exception):  # a board that is gone cannot be released
            self._board.release_session()


class BrainFlowShirt:
    """Makes a frame of each sample of the chosen channels of one board.

    A board that is lost is silence, with which the gate stops the chair. It comes back no sooner than that stop.
    """

    def __init__(
        self, config: BrainFlowConfig, clock: Clock, load: Callable[[], BrainFlowLibrary] = load_brainflow
    ) -> None:
        self._config = config
        self._clock = clock
        self._load = load
        self._layout = config.layout
        self._reader: BoardReader | None = None
        self._begin(BoardChannels({}, 0, LOWEST_RATE))

    def _begin(self, channels: BoardChannels) -> None:
        """Forget everything that was received, and expect these channels."""
        self._channels = channels
        self._board_rows = list(channels.rows.values())  # of the samples
        self._samples = StreamSamples(len(channels.rows), channels.rate, is_regular=True)
        self._rows = LedRows([self._samples], 0)
        self._board_clock = PageClock()
        self._age = 0.0  # s, of the newest sample when it was taken over
        self._received = 0  # samples
        self._watch = ArrivalWatch(self._clock.now())
        self._rate = RateMeter(channels.rate)

    @property
    def layout(self) -> ShirtLayout:
        """Names and joints of the channels: of the configuration, or as the board describes them once open."""
        if self._layout is None:
            raise HardwareError(Text("shirtdev-brainflow-closed"))
        return self._layout

    @property
    def sample_rate(self) -> float:
        """Frames per second (Hz), those of the board once it is open."""
        return self._channels.rate

    @property
    def lost(self) -> int:
        """Frames that are missing by the times of the samples since the shirt was opened."""
        return self._rows.lost

    def open(self) -> None:
        """Connect the board.

        Raises
        ------
        HardwareError
            Without BrainFlow, for a board or data that it does not have, or when the board does not answer.
        """
        self.close()
        config = self._config
        try:
            library = self._load()
        except BRAINFLOW_MISSING as error:
            raise HardwareError(Text("shirtdev-brainflow-no-library", why=library_message(error))) from error
        number, preset = board_number(library.BoardIds, config.board), PRESETS.index(config.preset)
        try:
            description = library.BoardShim.get_board_descr(number, preset)
        except library.BrainFlowError as error:
            raise HardwareError(Text("shirtdev-brainflow-no-stream", board=config.board)) from error
        channels = chosen_channels(description, config.board, config.data)
        layout = config.layout or board_layout(config.board, channels.rows)
        count, named = len(channels.rows), len(layout.channels)
        if count != named:
            raise HardwareError(Text("shirtdev-brainflow-misfit", channels=count, named=named))
        board = library.BoardShim(number, self._parameters(library))
        reader = BoardReader(board, round(KEPT * channels.rate), preset, self._clock)
        try:
            reader.connect()
        except library.BrainFlowError as error:
            cause = CAUSES.get(getattr(error, "exit_code", 0), "other")
            text = Text("shirtdev-brainflow-failed", board=config.board, why=library_message(error), cause=cause)
            raise HardwareError(text) from error
        self._layout = layout
        self._begin(channels)
        self._reader = reader
        reader.start()

    def read(self, timeout: float) -> SensorFrame | None:
        """Return the next frame, waiting for it at most `timeout` (s)."""
        deadline = self._clock.now() + timeout
        while True:
            self._take_in()
            now = self._clock.now()
            row = self._rows.next(now)
            if row is not None:
                self._watch.accept(now)
                return SensorFrame(row.seq & 0xFFFFFFFF, row.t, now, row.values)
            if now >= deadline:
                return None
            if self._reader is None:
                self._clock.sleep_until(deadline)
            else:
                self._reader.wait(deadline - now)

    def pending(self) -> bool:
        """Return whether another frame has arrived already."""
        self._take_in()
        return bool(self._samples.waiting)

    def description(self) -> Text:
        """Return the shirt's state in words."""
        board, reader = self._config.board, self._reader
        if reader is None:
            return Text("shirtdev-brainflow-closed")
        if self._clock.now() - self._watch.accepted_t > ALIVE:
            return self._silence(reader)
        return Text(
            "shirtdev-brainflow",
            board=board,
            sensors=len(self.layout.channels),
            rate=round(self.sample_rate, 2),
            age=Figure(1000.0 * self._age),
            lost=self.lost,
        )

    def arrivals(self) -> Arrivals:
        """Return what arrives from the board."""
        reader, verdict = self._reader, self._watch.verdict(self._clock.now())
        if reader is None:
            return Arrivals("gone", self.description())
        message = GOOD if verdict == "arrives" else WAITING
        if verdict == "arrives" and self._rate.is_wrong:
            verdict = "rate"
            rates = {"measured": round(self._rate.rate), "expected": round(self.sample_rate, 2)}
            message = Text("arrivals-brainflow-rate", board=self._config.board, **rates)
        elif verdict == "nothing":
            verdict = "gone" if reader.trouble else verdict
            message = self._silence(reader)
        return Arrivals(verdict, message, self._watch.accepted)

    def close(self) -> None:
        """Release the board; closing twice does no harm."""
        reader, self._reader = self._reader, None
        if reader is not None:
            reader.end()
        self._samples.waiting.clear()

    def _silence(self, reader: BoardReader) -> Text:
        """Return in words why nothing comes, as far as that is known, with what to do."""
        return Text("shirtdev-brainflow-silent", board=self._config.board, why=reader.trouble or "none")

    def _parameters(self, library: BrainFlowLibrary) -> Any:
        """Return BrainFlow's parameters with what people filled in."""
        parameters = library.BrainFlowInputParams()
        for name in PARAMETERS:
            value = getattr(self._config, name)
            if value:
                setattr(parameters, name, value)
        parameters.timeout = LOOK
        return parameters

    def _take_in(self) -> None:
        """Make samples of what the reader has taken over."""
        reader = self._reader
        while reader is not None and reader.chunks:
            t, chunk = reader.chunks.popleft()
            self._received += chunk.shape[1]
            self._rate.add(self._received, t)
            stamps = chunk[self._channels.timestamp]
            gaps = np.diff(stamps)
            gaps[~((gaps >= 0.0) & (gaps <= LONGEST_LAG))] = 1.0 / self._channels.rate  # a step of the time; also NaN
            times = t - self._age_of(float(stamps[-1]), t) - np.append(np.cumsum(gaps[::-1])[::-1], 0.0)
            for sample_t, values in zip(times.tolist(), chunk[self._board_rows].T.tolist(), strict=True):
                self._samples.add(StreamSample(sample_t, values, t))

    def _age_of(self, stamp: float, t: float) -> float:
        """Return how old (s) a sample of this time was at `t` (monotonic s), beyond the quickest one.

        BrainFlow stamps most boards' samples by this machine's time, which can be set: a step of it begins anew.
        """
        self._age = self._board_clock.age(stamp, stamp, t)
        if not self._age <= LONGEST_LAG:  # also for NaN
            self._board_clock, self._age = PageClock(), 0.0
        return self._age


KIND = ShirtKind(BrainFlowConfig, BrainFlowShirt, Trust.NEVER)
