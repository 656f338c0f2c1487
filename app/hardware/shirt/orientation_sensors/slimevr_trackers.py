"""The trackers of a SlimeVR shirt: who they are, what they send, what is answered; no socket, no clock."""

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Final

from app.hardware.shirt.arrival_watch import PATIENCE, ArrivalWatch, LeftOut
from app.hardware.shirt.frame_order import Sequence
from app.hardware.shirt.orientation_sensors.orientation_frames import OrientationFrames
from app.hardware.shirt.orientation_sensors.slimevr_packets import (
    HANDSHAKE_REPLY,
    HEARTBEAT,
    TrackerAcceleration,
    TrackerBattery,
    TrackerFlex,
    TrackerHandshake,
    TrackerPacket,
    TrackerRotation,
    TrackerSensor,
    read_packet,
    sensor_acknowledgement,
)
from app.hardware.shirt.sender_choice import SHIRT_SENDER_SILENCE, Address, SenderChoice

MOST_TRACKERS: Final = 64  # that are answered: addresses that nobody placed could fill the memory
GONE: Final = 10.0  # s of silence after which a tracker gets no heartbeat and is offered no more
LOW_BATTERY: Final = 0.15  # share
FLEX_MARK: Final = "flex"


def sensor_name(mac: str, sensor: int, is_flex: bool = False) -> str:
    """Return the name of a sensor: the tracker's address, behind it the sensor's number beyond the first, and flex."""
    return "/".join([mac, *([str(sensor)] if sensor else []), *([FLEX_MARK] if is_flex else [])])


@dataclass(slots=True)
class _Tracker:
    mac: str
    address: Address
    newest_t: float  # monotonic s
    choice: SenderChoice = field(default_factory=SenderChoice)
    moves: int = 0  # how often it was started again at another port
    order: Sequence = field(default_factory=Sequence)
    number: int = -1  # of its newest packet
    has_greeted: bool = False  # since its newest packet
    battery: float = 1.0  # share
    unplaced: set[str] = field(default_factory=set)  # names of its sensors that are on no part of the body


class SlimeTrackers:
    """Answers trackers, and hands the samples of those that were placed on the body on to the frames.

    Each tracker is the sender of the first handshake with its address (MAC). Handshakes with that address from
    elsewhere are counted and not answered, until a person chooses their sender, or, from the same machine, until the
    tracker was silent for so long that nothing is armed (safety S23).

    Attributes
    ----------
    junk : int
        Datagrams that are none of a tracker.
    repeated : int
        Packets that came again, or after a newer one.
    """

    def __init__(self, places: Mapping[str, str], frames: OrientationFrames, watch: ArrivalWatch) -> None:
        """Take the names of sensors (`sensor_name`) with the part of the body (of PARTS) that each is on.

        `watch` counts what arrives.
        """
        self.junk = 0
        self.repeated = 0
        self._places = places
        self._frames = frames
        self._watch = watch
        self._placed = {name.partition("/")[0] for name in places}
        self._trackers: dict[str, _Tracker] = {}
        self._by_address: dict[Address, _Tracker] = {}

    def receive(self, datagram: bytes, address: Address, t: float) -> bytes | None:
        """Take a datagram that came from `address` at `t` (monotonic s), and return what is to be answered."""
        packet = read_packet(datagram)
        if packet is None:
            self.junk += 1
            self._watch.leave_out(LeftOut(t, "foreign", len(datagram), address))
            return None
        if isinstance(packet.content, TrackerHandshake):
            if self._greet(packet.content.mac, address, t):
                self._notice_life(t)
                return HANDSHAKE_REPLY
            is_known = packet.content.mac in self._trackers  # otherwise there are too many trackers on nobody
            self._watch.leave_out(LeftOut(t, "senders" if is_known else "unplaced"))
            return None
        tracker = self._by_address.get(address)
        if tracker is None or not self._is_next(tracker, packet):
            self._notice_life(t)
            return None  # a tracker that nobody answers greets after three seconds
        tracker.newest_t = t
        return self._take(tracker, packet, t)

    def heartbeats(self, t: float) -> list[tuple[bytes, Address]]:
        """Return what is to be sent at least every second, at `t` (monotonic s): a tracker without it gives up."""
        return [(HEARTBEAT, tracker.address) for tracker in self._present(t)]

    def unplaced(self, t: float) -> list[str]:
        """Return the names of the sensors that send and are on no part of the body."""
        return sorted(name for tracker in self._present(t) for name in tracker.unplaced)

    def low(self, t: float) -> list[str]:
        """Return the parts of the body with a tracker whose battery is almost empty."""
        low = {tracker.mac for tracker in self._present(t) if tracker.battery < LOW_BATTERY}
        return [part for name, part in self._places.items() if name.partition("/")[0] in low]

    @property
    def sender_choice(self) -> SenderChoice:
        """The senders of the tracker that others send in the name of most; an empty choice when nobody does."""
        contested = [tracker.choice for tracker in self._trackers.values() if tracker.choice.other]
        return max(contested, key=lambda choice: choice.other_frames, default=SenderChoice())

    def use_sender(self, name: str) -> bool:
        """Accept another sender as the tracker in whose name it sends; False when there is none of this name."""
        accepted = [tracker.choice.use(name) for tracker in self._trackers.values()]
        return any(accepted)

    def _present(self, t: float) -> list[_Tracker]:
        return [tracker for tracker in self._trackers.values() if t - tracker.newest_t < GONE]

    def _greet(self, mac: str, address: Address, t: float) -> bool:
        """Return whether a handshake is that of the tracker `mac`, and take its sender as that tracker."""
        tracker = self._trackers.get(mac)
        if tracker is None:
            if not self._has_room(mac, t):
                return False
            tracker = self._trackers[mac] = _Tracker(mac, address, t)
        is_elsewhere = address != tracker.address
        # Who sends from the same machine counts as the same device, started once more.
        starts = tracker.moves + is_elsewhere if address[0] == tracker.address[0] else 0
        if not tracker.choice.accept(address, starts, t - tracker.newest_t > SHIRT_SENDER_SILENCE):
            return False
        if is_elsewhere:
            self._by_address.pop(tracker.address, None)
            tracker.address, tracker.moves = address, starts
            self._begin_anew(tracker)
        self._by_address[address] = tracker
        tracker.newest_t, tracker.has_greeted = t, True
        return True

    def _has_room(self, mac: str, t: float) -> bool:
        """Return whether another tracker can be answered; one that is gone gives way, unless it is on the body."""
        others = [tracker for tracker in self._trackers.values() if tracker.mac not in self._placed]
        gone = min(others, key=lambda tracker: tracker.newest_t, default=None)
        if len(others) < MOST_TRACKERS or mac in self._placed:
            return True
        if gone is None or t - gone.newest_t < GONE:
            return False
        del self._trackers[gone.mac]
        self._by_address.pop(gone.address, None)
        return True

    def _is_next(self, tracker: _Tracker, packet: TrackerPacket) -> bool:
        """Return whether a packet is newer than those before, or the tracker was started again."""
        restarts = tracker.order.restarts
        if tracker.has_greeted and packet.number <= tracker.number:
            self._begin_anew(tracker)
        tracker.has_greeted = False
        if not tracker.order.accept(packet.number & 0xFFFFFFFF):
            self.repeated += 1
            return False
        if tracker.order.restarts > restarts:
            self._begin_anew(tracker)
            tracker.order.accept(packet.number & 0xFFFFFFFF)
        tracker.number = packet.number
        return True

    def _begin_anew(self, tracker: _Tracker) -> None:
        """Count from the next packet on, of a tracker that was started again: its sensors have another north."""
        tracker.order.forget()
        for name, part in self._places.items():
            if name.partition("/")[0] == tracker.mac:
                self._frames.forget(part)

    def _take(self, tracker: _Tracker, packet: TrackerPacket, t: float) -> bytes | None:
        match packet.content:
            case TrackerRotation(sensor, orientation):
                part = self._place(tracker, sensor_name(tracker.mac, sensor), t)
                if part is not None:
                    self._watch.accept(t)
                    self._frames.take_orientation(part, orientation, t)
            case TrackerAcceleration(sensor):
                part = self._place(tracker, sensor_name(tracker.mac, sensor), t)
                if part is None:
                    return None
                if self._frames.take_sign(part, t):
                    self._watch.accept(t)
                else:
                    self._notice_life(t)
            case TrackerFlex(sensor, value):
                part = self._place(tracker, sensor_name(tracker.mac, sensor, is_flex=True), t)
                if part is not None:
                    self._watch.accept(t)
                    self._frames.take_bend(part, value, t)
            case TrackerBattery(share):
                tracker.battery = share
                self._notice_life(t)
            case TrackerSensor() as report:
                self._notice_life(t)
                return sensor_acknowledgement(report)
            case None:
                self._notice_life(t)
        return None

    def _place(self, tracker: _Tracker, name: str, t: float) -> str | None:
        """Return the part of the body that a sensor is on; None, and offer it, when it is on none."""
        part = self._places.get(name)
        if part is None:
            tracker.unplaced.add(name)
            self._watch.leave_out(LeftOut(t, "unplaced"))
        return part

    def _notice_life(self, t: float) -> None:
        """Note that a tracker lives, unless something else that is left out says more."""
        if self._watch.newest.reason == "idle" or t - self._watch.newest.t >= PATIENCE:
            self._watch.leave_out(LeftOut(t, "idle"), count=0)
