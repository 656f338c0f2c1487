"""The stand-in chair on a socket: hears commands, answers telemetry, notes when what came."""

import socket
import threading
from collections.abc import Callable

from app.clock import monotonic
from app.hardware.chair.key import Key
from app.hardware.chair.packet import FRAME_BYTES, Command
from bench.processes.stand_in_chair import StandInChair

WAIT = 0.02  # s for a datagram, then telemetry is looked after

Address = tuple[str, int]
Told = Callable[[Command, float, Address], None]


def listen(chair: StandInChair, opened: socket.socket, told: Told, goes_on: Callable[[], bool]) -> None:
    """Be the chair on `opened` while `goes_on`; `told` gets each valid command, when it came (monotonic s), from whom.

    The one that said hello or sent the last valid command gets the telemetry.
    """
    opened.settimeout(WAIT)
    sender: Address | None = None
    while goes_on():
        try:
            datagram, address = opened.recvfrom(FRAME_BYTES + 1)
        except TimeoutError:
            datagram = b""
        now = monotonic()
        if datagram:
            command = chair.take(datagram, now)
            if command is not None:
                told(command, now, address)
            if command is not None or chair.was_greeted:
                sender = address
        telemetry = chair.answer(now)
        if telemetry is not None and sender is not None:
            opened.sendto(telemetry, sender)


class ListeningChair:
    """A stand-in chair in a thread of this process, which keeps the newest of what it was told."""

    def __init__(self, key: Key) -> None:
        self.heard: list[tuple[float, Command]] = []  # when (monotonic s), what
        self._socket = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        self._socket.bind(("127.0.0.1", 0))
        self.port: int = self._socket.getsockname()[1]
        self._ending = threading.Event()
        self._thread = threading.Thread(target=self._run, args=(StandInChair(key),), daemon=True)

    def __enter__(self) -> "ListeningChair":
        self._thread.start()
        return self

    def __exit__(self, *_: object) -> None:
        self._ending.set()
        self._thread.join()
        self._socket.close()

    def _run(self, chair: StandInChair) -> None:
        listen(chair, self._socket, self._note, lambda: not self._ending.is_set())

    def _note(self, command: Command, now: float, _sender: Address) -> None:
        self.heard.append((now, command))
