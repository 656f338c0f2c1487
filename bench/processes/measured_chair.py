"""A chair's real receiver on a socket; it notes when each command came. Nothing moves."""

import math
import socket
import threading
from collections.abc import Callable

from app.clock import monotonic
from app.hardware.chair.inputs import Inputs
from app.hardware.chair.key import Key
from app.hardware.chair.packet import FRAME_BYTES, ChairCommand, decode_command
from app.hardware.chair.receiver import Receiver
from app.hardware.chair.telemetry_sender import TelemetrySender

STEP = 0.01  # s between two steps of the receiver, as in its own loop
WAIT = 0.01  # s for a datagram before the next step

Address = tuple[str, int]
Note = Callable[[float, ChairCommand, Address], None]


def run_chair(key: Key, opened: socket.socket, note: Note, goes_on: Callable[[], bool]) -> None:
    """Run a receiver on the bound socket `opened` while `goes_on`.

    `note` gets each command that the receiver accepts: when it came (monotonic s), the command, its sender's address.
    """
    receiver = Receiver(key)
    telemetry = TelemetrySender(receiver, key.id, opened, None)
    inputs = Inputs(None, None)
    stepped = -math.inf
    opened.settimeout(WAIT)
    while goes_on():
        try:
            datagram, address = opened.recvfrom(FRAME_BYTES + 1)
        except TimeoutError:
            datagram, address = b"", ("", 0)
        t = monotonic()
        nonce = receiver.nonce  # of this command: a command to stop makes a new one
        accepted = receiver.accept(datagram, t)
        if accepted:
            telemetry.set_driver(address)
            command = decode_command(datagram, key, nonce)
            if command is not None:
                note(t, command, address)
        else:
            telemetry.answer_hello(datagram, address, t)
        if accepted or t - stepped >= STEP:
            stepped = t
            receiver.step(t)
            telemetry.send(t, inputs, stop_pressed=False)


class MeasuredChair:
    """A chair in a thread of this process.

    Attributes
    ----------
    commands : list of (float, Command)
        The commands that were accepted, each with the time at which it came (monotonic s).
    port : int
        Where the chair listens on this machine.
    """

    def __init__(self, key: Key) -> None:
        self.commands: list[tuple[float, ChairCommand]] = []
        self._key = key
        self._socket = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        self._socket.bind(("127.0.0.1", 0))
        self.port: int = self._socket.getsockname()[1]
        self._ending = threading.Event()
        self._thread = threading.Thread(target=self._run, daemon=True)

    def __enter__(self) -> "MeasuredChair":
        self._thread.start()
        return self

    def __exit__(self, *_: object) -> None:
        self._ending.set()
        self._thread.join()
        self._socket.close()

    def _run(self) -> None:
        run_chair(self._key, self._socket, self._note, lambda: not self._ending.is_set())

    def _note(self, t: float, command: ChairCommand, _address: Address) -> None:
        self.commands.append((t, command))
