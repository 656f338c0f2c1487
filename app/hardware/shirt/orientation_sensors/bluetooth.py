"""WitMotion's orientation sensors over Bluetooth Low Energy: each is worn on one part of the body."""

import re
from collections import Counter
from collections.abc import Callable
from typing import Annotated, Final, Literal

from pydantic import Field

from app.arrivals import Arrivals, ArrivalVerdict
from app.clock import Clock
from app.hardware.base import HardwareError, library_message
from app.hardware.shirt.arrival_watch import LeftOut, RateMeter
from app.hardware.shirt.kind import LOWEST_RATE, FieldTexts, ShirtKind, SourceFacts, Trust, page_texts
from app.hardware.shirt.orientation_sensors.bluetooth_links import (
    BleakLibrary,
    SensorLinks,
    SensorNotification,
    load_bleak,
)
from app.hardware.shirt.orientation_sensors.body_parts import part_title
from app.hardware.shirt.orientation_sensors.placed_sensors import PlacedSensorsConfig, PlacedSensorsShirt
from app.hardware.shirt.orientation_sensors.witmotion import (
    LOW_VOLTS,
    RATES,
    SensorDecoder,
    SensorMotion,
    SensorVoltage,
    sensor_orientation,
)
from app.messages import ALIVE
from app.quantities import Hertz
from app.texts import Text, in_sequence

READY_LIMIT: Final = 4.0  # s within which Bluetooth must begin to look; an opening, which ends another shirt, has 8 s
_ADDRESS: Final = re.compile(r"[0-9A-F]{2}(:[0-9A-F]{2}){5}|[0-9A-F]{8}(-[0-9A-F]{4}){3}-[0-9A-F]{12}")
"""An address, or the UUID that macOS gives in place of it."""

SensorRate = Annotated[Hertz, Field(ge=LOWEST_RATE, le=max(RATES)), FieldTexts(Text("shirtdev-rate"))]


class BluetoothConfig(PlacedSensorsConfig):
    """Orientation sensors of WitMotion on parts of the body, over Bluetooth."""

    model_config = page_texts(
        Text("shirtdev-bluetooth-title"),
        about=Text("shirtdev-bluetooth-about"),
        in_use=Text("shirtdev-bluetooth-in-use", rate="{sample_rate}"),
        facts=SourceFacts(
            Text("shirtdev-bluetooth-needs"), Text("shirtdev-bluetooth-costs"), Text("shirtdev-bluetooth-takes")
        ),
    )

    kind: Literal["bluetooth"]
    sample_rate: SensorRate = Field(default=50.0, json_schema_extra={"unit": "Hz", "examples": [*RATES]})

    @classmethod
    def checked_sensor(cls, name: str) -> str:
        """Return the address of a sensor in capital letters; ValueError for any other text."""
        address = name.strip().upper()
        if _ADDRESS.fullmatch(address) is None:
            raise ValueError(Text("shirtdev-bluetooth-no-address", given=name))
        return address


class BluetoothShirt(PlacedSensorsShirt):
    """Frames of the newest orientation of each sensor; their connections have a thread of their own.

    A sensor at rest repeats its angles, because it rounds them. A sensor that hangs repeats its acceleration and turn
    rate, too, which otherwise are never quite still: such a frame is no new sample, and without one the sensor's
    channels become NaN (safety S5).
    """

    def __init__(self, config: BluetoothConfig, clock: Clock, load: Callable[[], BleakLibrary] = load_bleak) -> None:
        self._load = load
        self._links: SensorLinks | None = None
        super().__init__("Bluetooth", config, (), clock)

    def _begin(self) -> None:
        """Forget everything that was received."""
        super()._begin()
        self.repeated = 0  # frames with nothing new in them
        self._parts = {address: part for part, address in self._sensors.items()}
        self._decoders = {address: SensorDecoder() for address in self._parts}
        self._newest = dict.fromkeys(self._parts, b"")  # content of the newest frame
        self._sent: Counter[str] = Counter()  # frames of each sensor
        self._rates = {address: RateMeter(self.sample_rate) for address in self._parts}
        self._volts: dict[str, float] = {}

    @property
    def found(self) -> list[str]:
        """The addresses of the sensors that announce themselves and are on no part of the body."""
        return self._links.found if self._links is not None else []

    def open(self) -> None:
        """Begin to look for the sensors, which may take a while to come.

        Raises
        ------
        HardwareError
            Without bleak, or where this machine's Bluetooth cannot be used.
        """
        self.close()
        try:
            library = self._load()
        except ImportError as error:
            raise HardwareError(Text("shirtdev-bluetooth-no-library", why=library_message(error))) from error
        links = SensorLinks(library, self._sensors.values(), self.sample_rate, self._clock)
        links.start()
        if not links.ready.wait(READY_LIMIT) or links.failure:
            links.end()
            raise HardwareError(Text("shirtdev-bluetooth-failed", why=links.failure or "none"))
        self._begin()
        self._links, self._is_open = links, True

    def description(self) -> Text:
        """Return the shirt's state in words."""
        links = self._links
        if links is None:
            return Text("shirtdev-bluetooth-closed")
        sensors = Text(
            "shirtdev-bluetooth",
            sending=self._count_sending(),
            placed=len(self._sensors),
            sensors=len(self.layout.channels),
            refused=self._junk,
            repeated=self.repeated,
            trouble=links.trouble or "none",
        )
        found = self.found
        return self._sentences(
            sensors,
            low=[part for address, part in self._parts.items() if self._volts.get(address, LOW_VOLTS) < LOW_VOLTS],
            found=Text("shirtdev-slimevr-found", sensors=found) if found else None,
        )

    def arrivals(self) -> Arrivals:
        """Return what arrives from the sensors."""
        links = self._links
        if links is None:
            return Arrivals("gone", self.description())
        reasons: dict[ArrivalVerdict, Text] = {
            "nothing": Text("arrivals-bluetooth-nothing", why=links.trouble or "none"),
            "idle": Text("arrivals-bluetooth-idle"),
            "foreign": Text("arrivals-bluetooth-foreign", count=self._junk),
            "repeated": Text("arrivals-bluetooth-repeated"),
        }
        silence: ArrivalVerdict = "idle" if links.connected else "nothing"
        found = self.found
        if found and silence == "nothing" and not links.trouble:
            silence = "unplaced"
            parts = [part_title(part) for part in self._sensors]
            worn = [Text("shirtdev-sensors-silent", parts=parts)] if parts else []
            reasons["unplaced"] = in_sequence([*worn, Text("shirtdev-slimevr-found", sensors=found)])
        arrivals = self._arrivals(reasons, silence)
        slow = self._slowest() if arrivals.verdict in {"arrives", "moving"} else None
        if slow is None:
            return arrivals
        part, rate = part_title(self._parts[slow]), round(self._rates[slow].rate)
        message = Text("arrivals-bluetooth-rate", part=part, measured=rate, expected=round(self.sample_rate, 2))
        return arrivals._replace(verdict="rate", message=message)

    def close(self) -> None:
        """Disconnect the sensors; closing twice does no harm."""
        self._is_open = False
        links, self._links = self._links, None
        if links is not None:
            links.end()

    def _receive_until(self, t: float) -> None:
        """Take in what has come until `t` (monotonic s)."""
        super()._receive_until(t)
        measured: dict[str, tuple[SensorMotion, float]] = {}
        while self._links is not None and self._links.notifications:
            self._take(self._links.notifications.popleft(), measured)
        for address, (motion, received) in measured.items():
            self._frames.take_orientation(self._parts[address], sensor_orientation(*motion.angles_deg), received)

    def _take(self, notification: SensorNotification, measured: dict[str, tuple[SensorMotion, float]]) -> None:
        """Take in a notification; `measured` gets the newest of its sensor, and when that came (monotonic s)."""
        address, content, t = notification
        decoder = self._decoders[address]
        if not content:
            decoder.begin_anew()
            measured.pop(address, None)
            self._frames.forget(self._parts[address])  # a sensor that was off may have another north
            return
        junk = decoder.junk
        found = decoder.feed(content)
        if decoder.junk > junk:
            self._watch.leave_out(LeftOut(t, "foreign", len(content)))
        for received in found:
            match received:
                case SensorVoltage(volts):
                    self._volts[address] = volts
                case SensorMotion(motion, _):
                    self._sent[address] += 1
                    self._rates[address].add(self._sent[address], t)
                    if motion == self._newest[address]:
                        self.repeated += 1
                        self._watch.leave_out(LeftOut(t, "repeated"))
                        continue
                    self._newest[address] = motion
                    self._watch.accept(t)
                    measured[address] = received, t

    @property
    def _junk(self) -> int:
        """Messages that are none of such a sensor."""
        return sum(decoder.junk for decoder in self._decoders.values())

    def _slowest(self) -> str | None:
        """Return the address of the sensor that sends least often, None while each sends often enough."""
        now = self._clock.now()
        low = {
            address: meter.rate
            for address, meter in self._rates.items()
            if meter.is_low and now - meter.newest_t <= ALIVE
        }
        return min(low, key=lambda address: low[address], default=None)


KIND = ShirtKind(BluetoothConfig, BluetoothShirt, Trust.NEVER)
