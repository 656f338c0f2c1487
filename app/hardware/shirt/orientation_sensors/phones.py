"""Phones and tablets as sensors: a page on each sends how it is held, as angles of the W3C's Device Orientation."""

import math
from dataclasses import dataclass, field
from struct import Struct
from typing import Final, Literal, NamedTuple

import numpy as np

from app.arrivals import Arrivals, ArrivalVerdict
from app.clock import Clock
from app.hardware.shirt.arrival_watch import LeftOut
from app.hardware.shirt.kind import ShirtKind, SourceFacts, Trust, page_texts
from app.hardware.shirt.orientation_sensors.orientation import Rotations, exponential, product
from app.hardware.shirt.orientation_sensors.placed_sensors import PlacedSensorsConfig, PlacedSensorsShirt
from app.hardware.shirt.page_clock import LONGEST_PAGE, TOO_OLD, PageClock
from app.texts import Figure, Text

MOST_PHONES: Final = 6
OFFERED: Final = 2.0  # s of silence after which a phone on no part of the body is offered no more
VERSION: Final = 1
MESSAGE: Final = Struct("<BBHIId3f")
"""Version, 0, 0, page (a random number), seq, time of sending (s of the page's clock); alpha, beta, gamma (degrees)."""
LARGEST_ANGLE_DEG: Final = 360.0


class PhoneSample(NamedTuple):
    """How a phone is held."""

    page: int
    seq: int
    sent_t: float  # s of the page's clock
    angles_deg: tuple[float, float, float]  # alpha, beta, gamma


def decode_phone(message: bytes) -> PhoneSample | None:
    """Return the sample in a message, None when it is not one with possible numbers."""
    if len(message) != MESSAGE.size:
        return None
    version, zero, none, page, seq, sent_t, *angles = MESSAGE.unpack(message)
    if (version, zero, none) != (VERSION, 0, 0) or not 0.0 <= sent_t <= LONGEST_PAGE:
        return None
    if not all(abs(angle) <= LARGEST_ANGLE_DEG for angle in angles):  # also for NaN
        return None
    alpha, beta, gamma = angles
    return PhoneSample(page, seq, sent_t, (alpha, beta, gamma))


def device_orientation(alpha_deg: float, beta_deg: float, gamma_deg: float) -> Rotations:
    """Return the orientation (4,) of a device whose angles are those of the W3C's Device Orientation.

    The device turns by alpha about its z, then by beta about its x, then by gamma about its y (intrinsic Z-X'-Y'').
    Source: W3C, Device Orientation and Motion, www.w3.org/TR/orientation-event.
    """
    turns = exponential(np.radians(np.array(((0.0, 0.0, alpha_deg), (beta_deg, 0.0, 0.0), (0.0, gamma_deg, 0.0)))))
    return product(product(turns[0], turns[1]), turns[2])


class PhonesConfig(PlacedSensorsConfig):
    """Phones and tablets that are tied to parts of the body."""

    model_config = page_texts(
        Text("shirtdev-phones-title"),
        about=Text("shirtdev-phones-about"),
        in_use=Text("shirtdev-phones-in-use", rate="{sample_rate}"),
        facts=SourceFacts(Text("shirtdev-phones-needs"), Text("shirtdev-phones-costs"), Text("shirtdev-phones-takes")),
    )

    kind: Literal["phones"]

    @classmethod
    def checked_sensor(cls, name: str) -> str:
        """Return the number of a phone as a text; ValueError for any other text."""
        if name.strip() not in map(str, range(1, MOST_PHONES + 1)):
            raise ValueError(Text("shirtdev-phones-no-number", given=name, most=MOST_PHONES))
        return name.strip()


@dataclass(slots=True)
class _Phone:
    page: int = -1  # the page that sends, -1 before its first message
    seq: int = -1  # of its newest message
    clock: PageClock = field(default_factory=PageClock)
    newest_t: float = -math.inf  # monotonic s, when the newest message came


class PhonesShirt(PlacedSensorsShirt):
    """Frames of the newest orientation of each phone; the web process hands on what their pages send.

    Browsers round the angles, so that those of a limb at rest are constant. A page sends only while its sensor tells
    something, and a phone that sends nothing makes its channels NaN: so a sensor that hangs is found (safety S5).
    """

    def __init__(self, config: PhonesConfig, clock: Clock) -> None:
        self._parts = {int(name): part for part, name in config.sensors.items()}
        super().__init__("Phones", config, (), clock)

    def _begin(self) -> None:
        """Forget everything that was received."""
        super()._begin()
        self.refused = 0  # messages that are no sample, or come again
        self.late = 0  # samples that show the past
        self._age = 0.0  # s, of the newest sample
        self._phones: dict[int, _Phone] = {}

    @property
    def found(self) -> list[str]:
        """The numbers of the phones that send and are on no part of the body."""
        now = self._clock.now()
        others = self._phones.keys() - self._parts.keys()
        return [str(number) for number in sorted(others) if now - self._phones[number].newest_t < OFFERED]

    def open(self) -> None:
        """Accept samples from now on."""
        self._begin()
        self._is_open = True

    def add_sample(self, page: int, message: bytes, received: float) -> None:
        """Take the message of the phone of the number `page` that came at `received` (monotonic s).

        Messages that are no sample, come again or show the past are counted and left out.
        """
        if not self._is_open:
            return
        sample = decode_phone(message) if 1 <= page <= MOST_PHONES else None
        if sample is None:
            self._refuse(received)
            return
        phone, part = self._phones.setdefault(page, _Phone()), self._parts.get(page)
        if sample.page != phone.page:
            phone.page, phone.seq, phone.clock = sample.page, -1, PageClock()
            if part is not None:
                self._frames.forget(part)  # a page that was loaded again may have another north
        if sample.seq <= phone.seq:
            self._refuse(received)
            return
        received = min(received, self._clock.now())
        phone.seq, phone.newest_t = sample.seq, received
        self._age = phone.clock.age(sample.sent_t, sample.sent_t, received)
        if self._age > TOO_OLD:
            self.late += 1
            self._watch.leave_out(LeftOut(received, "late"))
        elif part is not None:
            self._watch.accept(received)
            self._frames.take_orientation(part, device_orientation(*sample.angles_deg), received)
        else:
            self._watch.leave_out(LeftOut(received, "unplaced"))

    def description(self) -> Text:
        """Return the shirt's state in words."""
        if not self._is_open:
            return Text("shirtdev-phones-closed")
        phones = Text(
            "shirtdev-phones",
            sending=self._count_sending(),
            placed=len(self._sensors),
            sensors=len(self.layout.channels),
            refused=self.refused,
            late=self.late,
            delay=Figure(self._age, 1),
        )
        found = self.found
        return self._sentences(phones, found=Text("shirtdev-phones-found", phones=found) if found else None)

    def arrivals(self) -> Arrivals:
        """Return what arrives from the pages of the phones."""
        if not self._is_open:
            return Arrivals("gone", self.description())
        reasons: dict[ArrivalVerdict, Text] = {
            "nothing": Text("arrivals-phones-nothing"),
            "foreign": Text("arrivals-page-foreign", count=self.refused),
            "late": Text("arrivals-phones-late", delay=Figure(self._age, 1)),
        }
        if found := self.found:
            reasons["unplaced"] = Text("shirtdev-phones-found", phones=found)
        return self._arrivals(reasons)

    def close(self) -> None:
        """Accept no more samples."""
        self._is_open = False

    def _refuse(self, t: float) -> None:
        """Count a message that is no sample, or comes again, and came at `t` (monotonic s)."""
        self.refused += 1
        self._watch.leave_out(LeftOut(t, "foreign"))


KIND = ShirtKind(PhonesConfig, PhonesShirt, Trust.NEVER)
