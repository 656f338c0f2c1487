"""A shirt on a cable: a board sends its frames over USB or another serial line."""

import errno
import math
import os
import select
import threading
from collections import deque
from contextlib import suppress
from typing import TYPE_CHECKING, Annotated, Literal

from pydantic import Field
from pydantic.config import JsonDict

from app.arrivals import Arrivals, ArrivalVerdict
from app.clock import Clock
from app.hardware.addresses import Cable, is_radio
from app.hardware.base import HardwareError
from app.hardware.shirt.arrival_watch import GOOD, WAITING, ArrivalWatch, LeftOut, RateMeter
from app.hardware.shirt.kind import (
    FieldTexts,
    LayoutFile,
    ShirtKind,
    ShirtRate,
    SourceFacts,
    Trust,
    WiredConfig,
    page_texts,
)
from app.hardware.shirt.serial_bytes import FOREIGN, FrameDecoder, LineDecoder, SerialDecoder
from app.hardware.shirt.standard import standard_layout
from app.messages import ALIVE, SensorFrame
from app.texts import Figure, Text

if TYPE_CHECKING:
    from serial import Serial

AT_ONCE = 4096  # bytes of one read: the kernel keeps no more of a line
REOPEN_AFTER = 2.0  # s from the loss of a line to each try: longer than a shirt may be silent while armed (S4)
CAUSES = {
    errno.ENOENT: "missing",
    errno.ENODEV: "missing",
    errno.ENXIO: "missing",
    errno.EACCES: "forbidden",
    errno.EPERM: "forbidden",
    errno.EAGAIN: "busy",
    errno.EBUSY: "busy",
}


def _add_formats(schema: JsonDict) -> None:
    """Add what people call the formats to the JSON schema of a field."""
    frames, lines = str(Text("shirtdev-serial-format-frames")), str(Text("shirtdev-serial-format-lines"))
    schema["titles"] = {"frames": frames, "lines": lines}


class SerialConfig(WiredConfig):
    """A board that sends its sensors over USB or another serial line."""

    model_config = page_texts(
        Text("shirtdev-serial-title"),
        about=Text("shirtdev-serial-about"),
        in_use=Text("shirtdev-serial-in-use", device="{device}"),
        facts=SourceFacts(Text("shirtdev-serial-needs"), Text("shirtdev-serial-costs"), Text("shirtdev-serial-takes")),
    )

    kind: Literal["serial"]
    device: Annotated[Cable, FieldTexts(Text("shirtdev-serial-device"), Text("shirtdev-serial-device-hint"))] = (
        "/dev/ttyACM0"
    )
    baud: Annotated[int, Field(strict=True, ge=115_200, le=2_000_000), FieldTexts(Text("shirtdev-serial-baud"))] = (
        Field(
            default=115_200,
            json_schema_extra={
                "examples": [115_200, 230_400, 250_000, 460_800, 500_000, 921_600, 1_000_000, 2_000_000]
            },
        )
    )
    format: Annotated[
        Literal["frames", "lines"],
        FieldTexts(Text("shirtdev-serial-format"), Text("shirtdev-serial-format-hint")),
    ] = Field(default="frames", json_schema_extra=_add_formats)
    sample_rate: ShirtRate = 100.0
    layout: LayoutFile = Field(default_factory=standard_layout)


class SerialShirt:
    """Reads one serial line; one that was pulled out is opened again as soon as it is back.

    A line that is lost is silence, with which the gate stops the chair. It comes back no sooner than that stop, so that
    only a new arming drives with what was put in again.
    """

    def __init__(self, config: SerialConfig, clock: Clock) -> None:
        self.layout = config.layout
        self.sample_rate = config.sample_rate
        self._config = config
        self._clock = clock
        self._port: Serial | None = None
        self._reopening: _Reopening | None = None  # of a line that was lost
        self._frames: deque[SensorFrame] = deque()
        self._forget()

    def _forget(self) -> None:
        """Forget everything that was received."""
        self._decoder = self._new_decoder()
        self._bytes = 0  # that came
        self._bytes_t = -math.inf  # monotonic s, when the newest came
        self._watch = ArrivalWatch(self._clock.now())
        self._rate = RateMeter(self.sample_rate)

    @property
    def lost(self) -> int:
        """Frames missing in the board's own count, or unreadable, since the shirt was opened."""
        return self._decoder.lost

    def open(self) -> None:
        """Open the serial line.

        Raises
        ------
        HardwareError
            When there is no such line, or it may not or cannot be opened.
        """
        self.close()
        self._forget()
        try:
            self._port = open_line(self._config)
        except (OSError, ValueError) as error:  # a SerialException is an OSError; ValueError: a baud rate
            code = getattr(error, "errno", None)
            why, cause = os.strerror(code) if code else str(error), CAUSES.get(code or 0, "other")
            device, lines = self._config.device, wired_lines() if cause == "missing" else []
            text = Text("shirtdev-serial-failed", device=device, why=why, cause=cause, lines=lines or "none")
            raise HardwareError(text) from error

    def read(self, timeout: float) -> SensorFrame | None:
        """Return the next frame, waiting for it at most `timeout` (s); what is no frame is counted and left out."""
        deadline = self._clock.now() + timeout
        wait = timeout
        while not self._frames:
            port = self._current_port()
            if port is None:
                self._clock.sleep_until(deadline)
                break
            if not self._take_in(port, wait):
                break
            wait = deadline - self._clock.now()
            if wait <= 0.0:
                break
        return self._frames.popleft() if self._frames else None

    def pending(self) -> bool:
        """Return whether a whole frame has arrived already."""
        port = self._current_port()
        if not self._frames and port is not None:
            self._take_in(port, 0.0)
        return bool(self._frames)

    def description(self) -> Text:
        """Return the shirt's state in words."""
        device, decoder, now = self._config.device, self._decoder, self._clock.now()
        if self._reopening is not None:
            return Text("shirtdev-serial-lost", device=device)
        if self._port is None:
            return Text("shirtdev-serial-closed")
        if now - self._bytes_t > ALIVE:
            return Text("shirtdev-serial-silent", device=device)
        if now - self._watch.accepted_t > ALIVE:
            return Text("shirtdev-serial-unreadable", device=device, trouble=decoder.refusal or FOREIGN)
        return Text(
            "shirtdev-serial",
            device=device,
            sensors=len(self.layout.channels),
            lost=decoder.lost,
            refused=decoder.junk,
            trouble=decoder.refusal or "none",
            late="yes" if decoder.late_by else "no",
            delay=Figure(decoder.late_by, 1),
        )

    def arrivals(self) -> Arrivals:
        """Return what arrives on the line."""
        verdict: ArrivalVerdict = "gone" if self._port is None else self._watch.verdict(self._clock.now())
        if verdict == "arrives" and self._rate.is_wrong:
            verdict = "rate"
        return Arrivals(verdict, self._arrival_text(verdict), self._watch.accepted, self._watch.left_out)

    def _arrival_text(self, verdict: ArrivalVerdict) -> Text:
        """Return a verdict in words, with what to do."""
        device = self._config.device
        match verdict:
            case "gone" if self._reopening is not None:
                return Text("arrivals-serial-gone", device=device, lines=self._reopening.others or "none")
            case "gone":
                return self.description()
            case "nothing":
                return Text("shirtdev-serial-silent", device=device)
            case "foreign":
                why = self._decoder.refusal or FOREIGN
                return Text("arrivals-serial-foreign", device=device, bytes=self._bytes, why=why)
            case "rate":
                return Text("arrivals-rate", measured=round(self._rate.rate), expected=round(self.sample_rate, 2))
            case _:
                return GOOD if verdict == "arrives" else WAITING

    def close(self) -> None:
        """Close the serial line; closing twice does no harm."""
        if self._reopening is not None:
            self._reopening.end()
            self._reopening = None
        _close_port(self._port)
        self._port = None
        self._frames.clear()

    def _new_decoder(self) -> SerialDecoder:
        channels = len(self.layout.channels)
        if self._config.format == "frames":
            return FrameDecoder(channels, self.sample_rate)
        return LineDecoder(channels, self.sample_rate)

    def _current_port(self) -> "Serial | None":
        """Return the open port; one that was opened again replaces the lost one."""
        if self._reopening is not None and (port := self._reopening.take_port()) is not None:
            self._port, self._reopening = port, None
            self._decoder.begin_anew()
        return self._port

    def _take_in(self, port: "Serial", wait: float) -> bool:
        """Decode the bytes that come within `wait` (s); False when none came, or the line was lost."""
        try:
            if not select.select([port], [], [], max(0.0, wait))[0]:
                return False
            content = port.read(AT_ONCE)
        except OSError:
            self._lose_line()
            return False
        t, junk = self._clock.now(), self._decoder.junk
        frames = self._decoder.feed(content, t)
        self._frames.extend(frames)
        self._bytes += len(content)
        self._bytes_t = t
        self._watch.leave_out(LeftOut(t, "foreign", len(content)), self._decoder.junk - junk)
        if frames:
            self._watch.accept(t, len(frames))
            self._measure_rate(frames[-1])
        return True

    def _measure_rate(self, newest: SensorFrame) -> None:
        """Take in the newest frame: by the board's count and clock, or by ours where lines have neither."""
        if self._config.format == "frames":
            self._rate.add(newest.seq, newest.t_device)
        else:
            self._rate.add(self._watch.accepted + self._decoder.junk, newest.t)

    def _lose_line(self) -> None:
        """Close the port of a line that was pulled out, and begin to open it again."""
        _close_port(self._port)
        self._port = None
        self._reopening = _Reopening(self._config)
        self._reopening.start()


class _Reopening(threading.Thread):
    """Opens a lost line again once it is back; in a thread, because an opening may wait for the device.

    Attributes
    ----------
    others : list of str
        The lines that were there at the newest try.
    """

    def __init__(self, config: SerialConfig) -> None:
        super().__init__(name="reopens the serial line", daemon=True)
        self.others: list[str] = []
        self._config = config
        self._lock = threading.Lock()
        self._ended = threading.Event()
        self._port: Serial | None = None

    def run(self) -> None:
        """Try to open the line until that succeeds, or nobody wants it any more."""
        while not self._ended.wait(REOPEN_AFTER):
            try:
                port = open_line(self._config)
            except Exception:  # whatever the line raises, it is tried again
                with suppress(Exception):
                    self.others = wired_lines()
                continue
            with self._lock:
                if not self._ended.is_set():
                    self._port = port
                    return
            _close_port(port)

    def take_port(self) -> "Serial | None":
        """Return the port once it is open; from then on it is the caller's."""
        with self._lock:
            port, self._port = self._port, None
        return port

    def end(self) -> None:
        """Try no more, and close the port if it was opened."""
        with self._lock:
            self._ended.set()
        _close_port(self.take_port())


def wired_lines() -> list[str]:
    """Return the names of the serial lines of this machine, without those that are radio links by their names."""
    from serial.tools.list_ports import comports  # noqa: PLC0415  # as in open_line

    return sorted(port.device for port in comports() if not is_radio(port.device))


def open_line(config: SerialConfig) -> "Serial":
    """Return the open serial line, without bytes that came before; no other program gets it meanwhile.

    Raises
    ------
    OSError
        When the line cannot be opened.
    ValueError
        When it does not know the baud rate.
    """
    import serial  # noqa: PLC0415  # the web process imports this file, too

    return serial.Serial(config.device, config.baud, timeout=0, exclusive=True)


def _close_port(port: "Serial | None") -> None:
    if port is not None:
        with suppress(OSError):
            port.close()


KIND = ShirtKind(SerialConfig, SerialShirt, Trust.WIRED)
