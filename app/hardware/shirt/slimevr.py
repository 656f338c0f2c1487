"""Trackers of orientation that are made for SlimeVR, and phones with owoTrack: each is worn on one part of the body."""

import re
import select
import socket
from collections.abc import Mapping
from typing import Annotated, Final, Literal, Self

from pydantic import AfterValidator, Field, model_validator

from app.clock import Clock
from app.hardware.addresses import Host
from app.hardware.shirt.body_parts import PARTS, TRUNK, layout_of, part_title
from app.hardware.shirt.frame_grid import FrameGrid
from app.hardware.shirt.kind import FieldTexts, ShirtConfig, ShirtKind, ShirtRate, Trust, page_texts
from app.hardware.shirt.orientation_frames import OrientationFrames
from app.hardware.shirt.sender_choice import SenderChoice
from app.hardware.shirt.slimevr_packets import LONGEST, PORT
from app.hardware.shirt.slimevr_trackers import FLEX_MARK, SlimeTrackers, sensor_name
from app.hardware.shirt.udp_socket import bound_socket
from app.messages import SensorFrame
from app.quantities import Line, Port
from app.texts import Text, in_sequence

BEAT_EVERY: Final = 1.0  # s: a tracker gives up after 3 s without a packet
AT_ONCE: Final = 256  # datagrams after which a flood no longer delays a frame
_NAME: Final = re.compile(r"(?P<mac>[0-9A-F]{2}(:[0-9A-F]{2}){5})(/(?P<sensor>[0-9]{1,3}))?(?P<flex>/FLEX)?")


def checked_sensor(text: str) -> str:
    """Return the name of a tracker's sensor as `sensor_name` writes it; ValueError for any other text."""
    match = _NAME.fullmatch(text.strip().upper())
    if match is None or int(match["sensor"] or 0) > 255:
        raise ValueError(Text("shirtdev-slimevr-no-name", given=text))
    return sensor_name(match["mac"], int(match["sensor"] or 0), match["flex"] is not None)


SensorName = Annotated[Line, Field(min_length=1, max_length=40), AfterValidator(checked_sensor)]
PlacedSensor = Annotated[SensorName | None, Field(json_schema_extra={"format": "tracker"})]


class SlimeVrConfig(ShirtConfig):
    """Trackers that send their orientation over the network, on parts of the body."""

    model_config = page_texts(
        Text("shirtdev-slimevr-title"),
        about=Text("shirtdev-slimevr-about"),
        in_use=Text("shirtdev-slimevr-in-use", port="{port}"),
    )

    kind: Literal["slimevr"]
    # The address of this machine that the trackers send to. They look for it by broadcast, which comes to 0.0.0.0 only.
    host: Annotated[Host, FieldTexts(Text("shirtdev-udp-host"), Text("shirtdev-slimevr-host-hint"))] = "0.0.0.0"  # noqa: S104
    port: Annotated[Port, FieldTexts(Text("shirtdev-udp-port"))] = PORT  # 0: any free port
    sample_rate: ShirtRate = 50.0
    from_neighbour: Annotated[bool, FieldTexts(Text("shirtdev-from-neighbour"))] = False
    trunk: Annotated[PlacedSensor, FieldTexts(Text("shirtdev-part-trunk"), Text("shirtdev-slimevr-sensor-hint"))] = None
    chair: Annotated[PlacedSensor, FieldTexts(Text("shirtdev-part-chair"), Text("shirtdev-slimevr-chair-hint"))] = None
    head: Annotated[PlacedSensor, FieldTexts(Text("shirtdev-part-head"))] = None
    left_upper_arm: Annotated[PlacedSensor, FieldTexts(Text("shirtdev-part-left-upper-arm"))] = None
    right_upper_arm: Annotated[PlacedSensor, FieldTexts(Text("shirtdev-part-right-upper-arm"))] = None
    left_forearm: Annotated[PlacedSensor, FieldTexts(Text("shirtdev-part-left-forearm"))] = None
    right_forearm: Annotated[PlacedSensor, FieldTexts(Text("shirtdev-part-right-forearm"))] = None
    left_hand: Annotated[PlacedSensor, FieldTexts(Text("shirtdev-part-left-hand"))] = None
    right_hand: Annotated[PlacedSensor, FieldTexts(Text("shirtdev-part-right-hand"))] = None
    left_fingers: Annotated[PlacedSensor, FieldTexts(Text("shirtdev-part-left-fingers"))] = None
    right_fingers: Annotated[PlacedSensor, FieldTexts(Text("shirtdev-part-right-fingers"))] = None
    left_thigh: Annotated[PlacedSensor, FieldTexts(Text("shirtdev-part-left-thigh"))] = None
    right_thigh: Annotated[PlacedSensor, FieldTexts(Text("shirtdev-part-right-thigh"))] = None
    left_lower_leg: Annotated[PlacedSensor, FieldTexts(Text("shirtdev-part-left-lower-leg"))] = None
    right_lower_leg: Annotated[PlacedSensor, FieldTexts(Text("shirtdev-part-right-lower-leg"))] = None
    left_foot: Annotated[PlacedSensor, FieldTexts(Text("shirtdev-part-left-foot"))] = None
    right_foot: Annotated[PlacedSensor, FieldTexts(Text("shirtdev-part-right-foot"))] = None

    @property
    def sensors(self) -> Mapping[str, str]:
        """The names of the sensors by the parts of the body (names of PARTS)."""
        named: dict[str, str | None] = {part: getattr(self, part) for part in PARTS}
        return {part: name for part, name in named.items() if name is not None}

    @model_validator(mode="after")
    def _a_sensor_is_on_one_part(self) -> Self:
        names = list(self.sensors.values())
        for name in names:
            if names.count(name) > 1:
                raise ValueError(Text("shirtdev-slimevr-twice", sensor=name))
        if is_flex(self.chair or ""):
            raise ValueError(Text("shirtdev-slimevr-flex-chair", sensor=str(self.chair)))
        return self


def is_flex(name: str) -> bool:
    """Return whether a name is that of a strain sensor."""
    return name.endswith(f"/{FLEX_MARK}")


class SlimeVrShirt:
    """Answers trackers that look for a server, and makes frames of what those on the body send.

    Bundles of packets, which newer trackers can send, come only to servers that offer to read them; this one does not.
    """

    def __init__(self, config: SlimeVrConfig, clock: Clock) -> None:
        sensors = config.sensors
        bends = [part for part, name in sensors.items() if is_flex(name)]
        # Without a sensor on the body there is a shirt all the same, so that the page can offer those that are found.
        has_signals = any(PARTS[part].joint is not None for part in sensors)
        self.layout = layout_of("SlimeVR", sensors if has_signals else [TRUNK], bends)
        self.sample_rate = config.sample_rate
        self.address: tuple[str, int] = (config.host, config.port)  # with the true port once open
        self._config = config
        self._bends = bends
        self._clock = clock
        self._socket: socket.socket | None = None
        self._begin()

    def _begin(self) -> None:
        """Forget everything that was received."""
        sensors = self._config.sensors
        self._frames = OrientationFrames(sensors, self._bends, self.sample_rate, self._config.from_neighbour)
        self._trackers = SlimeTrackers({name: part for part, name in sensors.items()}, self._frames)
        self._grid = FrameGrid(self._clock, self.sample_rate)
        self._beat_t = self._clock.now()

    @property
    def lost(self) -> int:
        """Instants of the nominal rate without a sample of any tracker, since the first frame."""
        return self._grid.lost

    @property
    def found(self) -> list[str]:
        """The names of the sensors that send and are on no part of the body."""
        return self._trackers.unplaced(self._clock.now())

    @property
    def sender_choice(self) -> SenderChoice:
        """The senders of a tracker in whose name others send, too."""
        return self._trackers.sender_choice

    def use_sender(self, name: str) -> bool:
        """Accept another sender as the tracker in whose name it sends; False when there is none of this name."""
        return self._trackers.use_sender(name)

    def lost_key(self) -> Text | None:
        """Return None: trackers have no keys."""
        return None

    def open(self) -> None:
        """Open the socket.

        Raises
        ------
        HardwareError
            When the address is not of this machine, or another program listens on its port.
        """
        self.close()
        self._socket = bound_socket(*self.address)
        self._socket.setblocking(False)
        self.address = (self.address[0], self._socket.getsockname()[1])
        self._begin()

    def read(self, timeout: float) -> SensorFrame | None:
        """Return the next frame, waiting for it at most `timeout` (s); junk is counted and ignored."""
        end = self._clock.now() + timeout
        if self._socket is None:
            self._clock.sleep_until(end)
            return None
        while True:
            self._receive_until(min(self._grid.due, end))
            if self._clock.now() < self._grid.due:
                return None
            values = self._frames.frame(self._grid.advance())
            if values is not None:
                return self._grid.frame(values)
            if self._clock.now() >= end:
                return None

    def pending(self) -> bool:
        """Return whether the next frame is due already."""
        return self._socket is not None and self._grid.due <= self._clock.now()

    def description(self) -> Text:
        """Return the shirt's state in words."""
        if self._socket is None:
            return Text("shirtdev-slimevr-closed")
        now = self._clock.now()
        placed, silent, found = list(self._config.sensors), self._frames.silent(now), self.found
        host, port = self.address
        sentences = [
            Text(
                "shirtdev-slimevr",
                place=f"{host}:{port}",
                sending=len(placed) - len(silent),
                placed=len(placed),
                sensors=len(self.layout.channels),
                refused=self._trackers.junk,
            )
        ]
        for message, parts in (
            ("shirtdev-sensors-silent", silent),
            ("shirtdev-sensors-moving", [part for part in self._frames.moving if part not in silent]),
            ("shirtdev-sensors-drift", self._frames.drifting),
            ("shirtdev-sensors-battery", self._trackers.low(now)),
        ):
            if parts:
                sentences.append(Text(message, parts=[part_title(part) for part in parts]))
        if found:
            sentences.append(Text("shirtdev-slimevr-found", sensors=found))
        return in_sequence(sentences)

    def close(self) -> None:
        """Close the socket; closing twice does no harm."""
        if self._socket is not None:
            self._socket.close()
            self._socket = None

    def _receive_until(self, t: float) -> None:
        """Take in what comes until `t` (monotonic s), and send the heartbeats that are due."""
        listening = self._socket
        if listening is None:
            return
        taken = 0
        while True:
            now = self._clock.now()
            self._beat(listening, now)
            if self._receive(listening, now):
                taken += 1
                if taken >= AT_ONCE and now >= t:
                    return
                continue
            if now >= t:
                return
            if not select.select([listening], [], [], t - now)[0]:
                self._clock.sleep_until(t)

    def _receive(self, listening: socket.socket, now: float) -> bool:
        """Take in one datagram and answer it; False when there was none."""
        try:
            datagram, address = listening.recvfrom(LONGEST + 1)  # one byte more shows what is too long
        except ConnectionError:  # what was sent before did not arrive
            return True
        except OSError:
            return False
        answer = self._trackers.receive(datagram, address, now)
        if answer is not None:
            _send(listening, answer, address)
        return True

    def _beat(self, listening: socket.socket, now: float) -> None:
        if now - self._beat_t >= BEAT_EVERY:
            self._beat_t = now
            for heartbeat, address in self._trackers.heartbeats(now):
                _send(listening, heartbeat, address)


def _send(listening: socket.socket, datagram: bytes, address: tuple[str, int] | tuple[str, int, int, int]) -> None:
    try:
        listening.sendto(datagram, address)
    except OSError:
        return  # a tracker out of reach is silent, which the page says


KIND = ShirtKind(SlimeVrConfig, SlimeVrShirt, Trust.NEVER)
