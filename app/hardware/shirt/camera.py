"""A camera in a browser: its page reads the person's joints in each picture, and sends samples of them, no picture."""

import math
from struct import Struct
from typing import Annotated, Literal, NamedTuple

import numpy as np
from numpy.typing import NDArray
from pydantic import Field

from app.arrivals import Arrivals, ArrivalVerdict
from app.clock import Clock
from app.hardware.shirt.arrival_watch import GOOD, WAITING, ArrivalWatch, LeftOut
from app.hardware.shirt.kind import FieldTexts, ShirtConfig, ShirtKind, SourceFacts, Trust, page_texts
from app.hardware.shirt.page_clock import LONGEST_PAGE, TOO_OLD, PageClock
from app.hardware.shirt.simulator import Pace
from app.hardware.shirt.standard import bundled_layout
from app.messages import ALIVE, FRESH_PERIODS, SensorFrame
from app.quantities import Hertz
from app.texts import Figure, Text, Value

CAMERA_LAYOUT = "camera-upper-body.json"
SHORTEST_INTERVAL = 1e-3  # s
SMOOTHING = 0.1  # weight of the newest interval in the measured rate of pictures

VERSION = 1
HEADER = Struct("<BBHIdd")
"""Version, 0, channel count, seq (u32), times of picture and sending (s of the page's clock)."""
LARGEST_VALUE = 10.0  # rad, or widths of the shoulders: an arm is about two of them long
LONGEST_READING = 60.0  # s from a picture to its sample: the first one in a browser may take long

CameraRate = Annotated[Hertz, Field(ge=10, le=60), FieldTexts(Text("shirtdev-rate"), Text("shirtdev-camera-rate-hint"))]


class CameraSample(NamedTuple):
    """What a page has read in one picture."""

    seq: int
    picture_t: float  # s of the page's clock
    sent_t: float  # s of the page's clock
    values: NDArray[np.float32]  # (n_channels,), NaN: not visible


def decode_sample(message: bytes, channels: int) -> CameraSample | None:
    """Return the sample in a message, None when it is not one of `channels` channels with possible numbers."""
    if len(message) != HEADER.size + 4 * channels:
        return None
    version, zero, count, seq, picture_t, sent_t = HEADER.unpack_from(message)
    if (version, zero, count) != (VERSION, 0, channels):
        return None
    # The comparisons are written so that a NaN is refused.
    if not (0.0 <= picture_t <= sent_t <= LONGEST_PAGE and sent_t - picture_t <= LONGEST_READING):
        return None
    values = np.frombuffer(message, "<f4", channels, HEADER.size).astype(np.float32)
    if not np.all(np.isnan(values) | (np.abs(values) <= LARGEST_VALUE)):
        return None
    return CameraSample(seq, picture_t, sent_t, values)


class CameraConfig(ShirtConfig):
    """The movements of the upper body that the camera of a tablet, laptop or phone sees."""

    model_config = page_texts(
        Text("shirtdev-camera-title"),
        about=Text("shirtdev-camera-about"),
        in_use=Text("shirtdev-camera-in-use", rate="{sample_rate}"),
        facts=SourceFacts(Text("shirtdev-camera-needs"), Text("shirtdev-camera-costs"), Text("shirtdev-camera-takes")),
    )

    kind: Literal["camera"]
    sample_rate: CameraRate = Field(default=30.0, json_schema_extra={"unit": "Hz", "examples": [10, 15, 30]})


class CameraShirt:
    """Frames at a steady rate, each with the newest sample of one page; nothing is interpolated.

    Three periods after a sample every channel is missing, and after `ALIVE` the shirt is silent. A person is never so
    still that two pictures give the same numbers: such a sample shows that the camera hangs, and does not count (S5).
    """

    def __init__(self, config: CameraConfig, clock: Clock) -> None:
        self.layout = bundled_layout(CAMERA_LAYOUT)
        self.sample_rate = config.sample_rate
        self._clock = clock
        self._is_open = False
        self._forget()

    def _forget(self) -> None:
        self.lost = 0
        self.refused = 0  # messages that are no sample of this layout, or come again
        self.late = 0  # samples of pictures that were too old
        self._page = -1
        self._seq = -1  # of the page's newest sample
        self._page_clock = PageClock()
        self._age = 0.0  # s, of the newest sample's picture when it came
        self._received = -math.inf  # monotonic s, when the newest sample came
        self._interval = 1.0 / self.sample_rate  # s between samples, smoothed
        self._values: NDArray[np.float32] = np.full(len(self.layout.channels), np.nan, np.float32)
        self._watch = ArrivalWatch(self._clock.now())
        self._pace: Pace | None = None  # None before the first sample
        self._number = self._passed_on = -1  # of the newest frame, and of the newest that `read` returned

    def open(self) -> None:
        """Accept samples from now on."""
        self._forget()
        self._is_open = True

    def add_sample(self, page: int, message: bytes, received: float) -> None:
        """Take a message of a page that came at `received` (monotonic s); another page begins anew.

        Messages that are no sample, come again or show a body of the past are counted and left out.
        """
        if not self._is_open:
            return
        sample = decode_sample(message, len(self.layout.channels))
        if page != self._page and sample is not None:
            self._page, self._seq, self._page_clock = page, -1, PageClock()
        if sample is None or sample.seq <= self._seq:
            self.refused += 1
            self._watch.leave_out(LeftOut(received, "foreign"))
            return
        self._seq = sample.seq
        received = min(received, self._clock.now())
        self._age = self._page_clock.age(sample.picture_t, sample.sent_t, received)
        if self._age > TOO_OLD:
            self.late += 1
            self._watch.leave_out(LeftOut(received, "late"))
            return
        if np.array_equal(sample.values, self._values, equal_nan=True) and not np.isnan(sample.values).all():
            self._watch.leave_out(LeftOut(received, "idle"))
            return
        self._watch.accept(received)
        if received - self._received <= ALIVE:
            self._interval += SMOOTHING * (received - self._received - self._interval)
        self._received, self._values = received, sample.values
        if self._pace is None:
            self._pace = Pace(self._clock, self.sample_rate)

    def read(self, timeout: float) -> SensorFrame | None:
        """Return the next frame when it is due within `timeout` (s) and the page is not silent."""
        if self._pace is None:
            self._clock.sleep_until(self._clock.now() + timeout)
            return None
        if not self._pace.wait(timeout):
            return None
        self._number += 1 + self._pace.missed()
        now = self._clock.now()
        if self._is_silent(now):
            return None
        self.lost += self._number - self._passed_on - 1
        self._passed_on = self._number
        is_fresh = now - self._received <= FRESH_PERIODS / self.sample_rate
        values = self._values.copy() if is_fresh else np.full_like(self._values, np.nan)
        return SensorFrame(self._number & 0xFFFFFFFF, self._number / self.sample_rate, now, values)

    def pending(self) -> bool:
        """Return whether the next frame is due already."""
        return self._pace is not None and not self._is_silent(self._clock.now()) and self._pace.is_due()

    def description(self) -> Text:
        """Return the shirt's state in words."""
        if not self._is_open:
            return Text("shirtdev-camera-closed")
        common: dict[str, Value] = {"refused": self.refused, "late": self.late}
        if self._is_silent(self._clock.now()):
            return Text("shirtdev-camera-silent", delay=Figure(self._age, 1), **common)
        common |= {"sensors": len(self.layout.channels), "lost": self.lost}
        if np.isnan(self._values).all():
            return Text("shirtdev-camera-nobody", **common)
        return Text(
            "shirtdev-camera",
            pictures=round(1.0 / max(self._interval, SHORTEST_INTERVAL)),
            delay=round(1000.0 * self._age),
            **common,
        )

    def arrivals(self) -> Arrivals:
        """Return what arrives from pages."""
        verdict: ArrivalVerdict = self._watch.verdict(self._clock.now()) if self._is_open else "gone"
        if verdict == "arrives":
            too_slow = FRESH_PERIODS / self.sample_rate < self._interval
            verdict = "nobody" if np.isnan(self._values).all() else "rate" if too_slow else verdict
        return Arrivals(verdict, self._arrival_text(verdict), self._watch.accepted, self._watch.left_out)

    def _arrival_text(self, verdict: ArrivalVerdict) -> Text:
        """Return a verdict in words, with what to do."""
        match verdict:
            case "gone":
                return self.description()
            case "nothing":
                return Text("arrivals-camera-nothing")
            case "foreign":
                return Text("arrivals-page-foreign", count=self.refused)
            case "late":
                return Text("arrivals-camera-late", delay=Figure(self._age, 1))
            case "nobody":
                return Text("arrivals-camera-nobody")
            case "idle":
                return Text("arrivals-camera-idle")
            case "rate":
                pictures = round(1.0 / max(self._interval, SHORTEST_INTERVAL))
                return Text("arrivals-camera-slow", pictures=pictures, expected=round(self.sample_rate, 2))
            case _:
                return GOOD if verdict == "arrives" else WAITING

    def close(self) -> None:
        """Accept no more samples, and end the frames."""
        self._is_open, self._pace = False, None

    def _is_silent(self, now: float) -> bool:
        return now - self._received > ALIVE


KIND = ShirtKind(CameraConfig, CameraShirt, Trust.NEVER)
