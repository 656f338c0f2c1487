"""Trackers of orientation that are made for SlimeVR, and phones with owoTrack: each is worn on one part of the body."""

import re
import select
import socket
from typing import Annotated, Final, Literal, Self

from pydantic import model_validator

from app.arrivals import Arrivals, ArrivalVerdict
from app.clock import Clock
from app.hardware.addresses import Host
from app.hardware.shirt.kind import FieldTexts, ShirtKind, SourceFacts, Trust, page_texts
from app.hardware.shirt.orientation_sensors.placed_sensors import PlacedSensorsConfig, PlacedSensorsShirt
from app.hardware.shirt.orientation_sensors.slimevr_packets import LONGEST
from app.hardware.shirt.orientation_sensors.slimevr_trackers import FLEX_MARK, SlimeTrackers, sensor_name
from app.hardware.shirt.sender_choice import SenderChoice, address_text
from app.hardware.shirt.udp_socket import bound_socket, reach_of
from app.ports import SLIMEVR_PORT
from app.quantities import Port
from app.texts import Text

BEAT_EVERY: Final = 1.0  # s: a tracker gives up after 3 s without a packet
AT_ONCE: Final = 256  # datagrams after which a flood no longer delays a frame
FOREIGN_TRACKER: Final = Text("arrivals-no-tracker")
_NAME: Final = re.compile(r"(?P<mac>[0-9A-F]{2}(:[0-9A-F]{2}){5})(/(?P<sensor>[0-9]{1,3}))?(?P<flex>/FLEX)?")


class SlimeVrConfig(PlacedSensorsConfig):
    """Trackers that send their orientation over the network, on parts of the body."""

    model_config = page_texts(
        Text("shirtdev-slimevr-title"),
        about=Text("shirtdev-slimevr-about"),
        in_use=Text("shirtdev-slimevr-in-use", port="{port}"),
        facts=SourceFacts(
            Text("shirtdev-slimevr-needs"), Text("shirtdev-slimevr-costs"), Text("shirtdev-slimevr-takes")
        ),
    )

    kind: Literal["slimevr"]
    # The address of this machine that the trackers send to. They look for it by broadcast, which comes to 0.0.0.0 only.
    host: Annotated[Host, FieldTexts(Text("shirtdev-udp-host"), Text("shirtdev-slimevr-host-hint"))] = "0.0.0.0"  # noqa: S104
    port: Annotated[Port, FieldTexts(Text("shirtdev-udp-port"))] = SLIMEVR_PORT  # 0: any free port

    @classmethod
    def checked_sensor(cls, name: str) -> str:
        """Return the name of a tracker's sensor as `sensor_name` writes it; ValueError for any other text."""
        match = _NAME.fullmatch(name.strip().upper())
        if match is None or int(match["sensor"] or 0) > 255:
            raise ValueError(Text("shirtdev-slimevr-no-name", given=name))
        return sensor_name(match["mac"], int(match["sensor"] or 0), match["flex"] is not None)

    @model_validator(mode="after")
    def _the_chair_has_an_orientation(self) -> Self:
        if self.chair is not None and is_flex(self.chair):
            raise ValueError(Text("shirtdev-slimevr-flex-chair", sensor=self.chair))
        return self


def is_flex(name: str) -> bool:
    """Return whether a name is that of a strain sensor."""
    return name.endswith(f"/{FLEX_MARK}")


class SlimeVrShirt(PlacedSensorsShirt):
    """Answers trackers that look for a server, and makes frames of what those on the body send.

    Bundles of packets, which newer trackers can send, come only to servers that offer to read them; this one does not.
    """

    def __init__(self, config: SlimeVrConfig, clock: Clock) -> None:
        self.address: tuple[str, int] = (config.host, config.port)  # with the true port once open
        self._socket: socket.socket | None = None
        bends = [part for part, name in config.sensors.items() if is_flex(name)]
        super().__init__("SlimeVR", config, bends, clock)

    def _begin(self) -> None:
        """Forget everything that was received."""
        super()._begin()
        places = {name: part for part, name in self._sensors.items()}
        self._trackers = SlimeTrackers(places, self._frames, self._watch)
        self._beat_t = self._clock.now()

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
        self._is_open = True

    def description(self) -> Text:
        """Return the shirt's state in words."""
        if not self._is_open:
            return Text("shirtdev-slimevr-closed")
        host, port = self.address
        trackers = Text(
            "shirtdev-slimevr",
            place=f"{host}:{port}",
            sending=self._count_sending(),
            placed=len(self._sensors),
            sensors=len(self.layout.channels),
            refused=self._trackers.junk,
        )
        found = self.found
        return self._sentences(
            trackers,
            low=self._trackers.low(self._clock.now()),
            found=Text("shirtdev-slimevr-found", sensors=found) if found else None,
        )

    def arrivals(self) -> Arrivals:
        """Return what arrives at the socket."""
        if self._socket is None:
            return Arrivals("gone", self.description())
        (host, port), newest, choice = self.address, self._watch.newest, self.sender_choice
        reach = reach_of(self._socket)
        reasons: dict[ArrivalVerdict, Text] = {
            "nothing": Text("arrivals-slimevr-nothing", place=f"{host}:{port}", port=port, reach=reach),
            "idle": Text("arrivals-slimevr-idle"),
        }
        if newest.sender is not None:
            sender = address_text(newest.sender)
            reasons["foreign"] = Text(
                "arrivals-foreign", count=self._trackers.junk, size=newest.size, sender=sender, why=FOREIGN_TRACKER
            )
        if choice.other:
            reasons["senders"] = Text("arrivals-senders", sender=choice.name, stranger=choice.other)
        if found := self.found:
            reasons["unplaced"] = Text("shirtdev-slimevr-found", sensors=found)
        return self._arrivals(reasons)

    def close(self) -> None:
        """Close the socket; closing twice does no harm."""
        self._is_open = False
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
