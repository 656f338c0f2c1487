"""To whom a receiver says how the chair is, and when. Standard library only."""

import math
import socket
from contextlib import suppress
from typing import Any

from app.hardware.chair.inputs import Inputs
from app.hardware.chair.packet import is_hello
from app.hardware.chair.receiver import Receiver, ReceiverState

EVERY = 0.1  # s
ANSWER_PAUSE = 0.02  # s between two answers to hellos: anybody can say hello

Address = Any  # what a socket calls an address


class Telling:
    """Sends the telemetry: to who drives; at rest to the paired address, or else to who said hello last."""

    def __init__(self, receiver: Receiver, key_id: int, end: socket.socket, paired: Address | None) -> None:
        self._receiver = receiver
        self._key_id = key_id
        self._socket = end
        self._paired = paired
        self._driver: Address | None = None
        self._asking: Address | None = None
        self._hello: Address | None = None  # who is to be answered
        self._answered = self._told = -math.inf
        self._state = ReceiverState.DISARMED

    def commanded_by(self, address: Address) -> None:
        """Know who sent the last valid command."""
        self._driver = address

    def greet(self, datagram: bytes, address: Address, t: float) -> None:
        """Answer a hello at the next step; anything else is left alone."""
        if t - self._answered >= ANSWER_PAUSE and is_hello(datagram, self._key_id):
            self._hello = self._asking = address

    def tell(self, t: float, inputs: Inputs, stop_pressed: bool, now: bool = False) -> None:
        """Send what is due at `t` (s), or `now`."""
        state = self._receiver.state
        due = now or t - self._told >= EVERY or state is not self._state
        if not due and self._hello is None:
            return
        datagram = self._receiver.telemetry(t, inputs.battery, stop_pressed=stop_pressed)
        if self._hello is not None:
            self._send(datagram, self._hello)
            self._hello, self._answered = None, t
        if due:
            self._told, self._state = t, state
            at_rest = state in (ReceiverState.DISARMED, ReceiverState.FAULT)
            others = (self._paired or self._asking,) if at_rest else ()
            for address in {self._driver, *others} - {None}:
                self._send(datagram, address)

    def _send(self, datagram: bytes, address: Address) -> None:
        with suppress(OSError):  # nobody there, or no room: the next one is newer
            self._socket.sendto(datagram, address)
