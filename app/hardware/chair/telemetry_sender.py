"""Sends a receiver's telemetry: to which address, and when. Standard library only."""

import math
import socket
from contextlib import suppress

from app.hardware.chair.inputs import Inputs
from app.hardware.chair.packet import is_hello
from app.hardware.chair.readings import NO_READINGS, ChairReadings
from app.hardware.chair.receiver import Receiver, ReceiverState
from app.hardware.shirt.sender_choice import Address

PERIOD = 0.1  # s between two telemetries
ANSWER_PAUSE = 0.02  # s between two answers to hellos: anybody on the network can send a hello


class TelemetrySender:
    """Sends telemetry to the driver; at rest also to the paired address, or else to the last sender of a hello."""

    def __init__(self, receiver: Receiver, key_id: int, end: socket.socket, paired: Address | None) -> None:
        self._receiver = receiver
        self._key_id = key_id
        self._socket = end
        self._paired = paired
        self._driver: Address | None = None
        self._greeter: Address | None = None
        self._hello: Address | None = None  # where a hello came from that is not answered yet
        self._answered = self._sent = -math.inf
        self._state = ReceiverState.DISARMED

    def set_driver(self, address: Address) -> None:
        """Set which address sent the last valid command."""
        self._driver = address

    def answer_hello(self, datagram: bytes, address: Address, t: float) -> None:
        """Answer a hello at the next `send`; ignore every other datagram."""
        if t - self._answered >= ANSWER_PAUSE and is_hello(datagram, self._key_id):
            self._hello = self._greeter = address

    def send(
        self,
        t: float,
        inputs: Inputs,
        stop_pressed: bool,
        readings: ChairReadings = NO_READINGS,
        *,
        now: bool = False,
    ) -> None:
        """Send the telemetry that is due at `t` (s); with `now`, whether it is due or not.

        The board's own input says the charge of the battery, or else the chair.
        """
        state = self._receiver.state
        due = now or t - self._sent >= PERIOD or state is not self._state
        if not due and self._hello is None:
            return
        if not math.isnan(battery := inputs.battery):
            readings = readings._replace(battery=battery)
        datagram = self._receiver.telemetry(t, readings, stop_pressed=stop_pressed)
        if self._hello is not None:
            self._put(datagram, self._hello)
            self._hello, self._answered = None, t
        if due:
            self._sent, self._state = t, state
            at_rest = state in (ReceiverState.DISARMED, ReceiverState.FAULT)
            others = (self._paired or self._greeter,) if at_rest else ()
            for address in {self._driver, *others} - {None}:
                self._put(datagram, address)

    def _put(self, datagram: bytes, address: Address) -> None:
        with suppress(OSError):  # nobody listens, or no room: the next telemetry is newer
            self._socket.sendto(datagram, address)
