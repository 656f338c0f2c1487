"""A simulated bad network between a sender and a chair, with a seed so that it can be repeated."""

import heapq
import itertools
import math
import random
import select
import socket
import threading
from collections import deque
from struct import Struct
from typing import NamedTuple

from app.clock import monotonic
from app.hardware.chair.packet import COMMAND_MAGIC

SENT_NS, SENT_AT = Struct("<Q"), 20  # the sender's time in a command, and its place (docs/protocols.md)


class Weather(NamedTuple):
    """The faults of the network: shares of datagrams, and seconds."""

    drop: float = 0.0
    duplicate: float = 0.0
    corrupt: float = 0.0
    delay: float = 0.0  # s, largest delay of a datagram, so that the order changes
    burst: float = 0.0  # share of datagrams at which a gap begins
    burst_time: float = 0.0  # s, longest gap

    def fate(
        self, datagram: bytes, t: float, dice: random.Random, gap_until: float
    ) -> tuple[list[tuple[float, bytes]], float]:
        """Return the times at which copies of a datagram come out, and the end of a gap."""
        if t < gap_until or dice.random() < self.drop:
            return [], gap_until
        if dice.random() < self.burst:
            return [], t + dice.random() * self.burst_time
        copies = [datagram] * (2 if dice.random() < self.duplicate else 1)
        out = []
        for copy in copies:
            changed = bytearray(copy)
            if dice.random() < self.corrupt:
                changed[dice.randrange(len(changed))] ^= 1 << dice.randrange(8)
            out.append((t + dice.random() * self.delay, bytes(changed)))
        return out, gap_until


FAIR = Weather()


class Relay:
    """The network; the sender uses it as the chair.

    `passed` holds (time, datagram) of what reached the chair, `told` what the chair said.
    """

    def __init__(self, chair_port: int, seed: int = 0) -> None:
        self._dice = random.Random(seed)
        self._near, self._far = (socket.socket(socket.AF_INET, socket.SOCK_DGRAM) for _ in range(2))
        for end in (self._near, self._far):
            end.bind(("127.0.0.1", 0))
            end.setblocking(False)
        self.port = self._near.getsockname()[1]
        self.chair_port = chair_port
        self.weather = FAIR
        self.cut = False
        self.passed: list[tuple[float, bytes]] = []
        self.told: deque[bytes] = deque(maxlen=1000)
        self._sender = None
        self._gap_until = {True: 0.0, False: 0.0}
        self._waiting: list[tuple[float, int, bool, bytes]] = []
        self._order = itertools.count()
        self._ended = threading.Event()
        self._thread = threading.Thread(target=self._pass_on)
        self._thread.start()

    def commands_since(self, t: float) -> list[tuple[float, bytes]]:
        """Return the commands that reached the chair after `t`."""
        return [(at, datagram) for at, datagram in self.passed if at > t and datagram[:4] == COMMAND_MAGIC]

    def longest_gap(self, begin: float, end: float = math.inf) -> float:
        """Return the longest time (s) between two commands that reached the chair between two times.

        It is of the clock of their sender: this thread may itself be late.
        """
        sent = [SENT_NS.unpack_from(datagram, SENT_AT)[0] for at, datagram in self.commands_since(begin) if at <= end]
        return max((1e-9 * (after - before) for before, after in itertools.pairwise(sent)), default=0.0)

    def inject(self, datagram: bytes) -> None:
        """Send a datagram to the chair from the sender's address."""
        self._far.sendto(datagram, ("127.0.0.1", self.chair_port))

    def notify(self, datagram: bytes) -> None:
        """Send a datagram to the sender, of which the relay has heard, from the chair's address."""
        assert self._sender is not None
        self._near.sendto(datagram, self._sender)

    def close(self) -> None:
        self._ended.set()
        self._thread.join()
        self._near.close()
        self._far.close()

    def _pass_on(self) -> None:
        while not self._ended.is_set():
            due = self._waiting[0][0] - monotonic() if self._waiting else 0.02
            for end in select.select([self._near, self._far], [], [], max(0.0, min(due, 0.02)))[0]:
                self._take(end)
            while self._waiting and self._waiting[0][0] <= monotonic():
                _, _, to_chair, datagram = heapq.heappop(self._waiting)
                self._deliver(to_chair, datagram)

    def _take(self, end: socket.socket) -> None:
        to_chair = end is self._near
        try:
            datagram, address = end.recvfrom(2048)
        except OSError:
            return
        if to_chair:
            self._sender = address
        if self.cut:
            return
        fates, self._gap_until[to_chair] = self.weather.fate(
            datagram, monotonic(), self._dice, self._gap_until[to_chair]
        )
        for due, copy in fates:
            heapq.heappush(self._waiting, (due, next(self._order), to_chair, copy))

    def _deliver(self, to_chair: bool, datagram: bytes) -> None:
        if self.cut:
            return
        try:
            if to_chair:
                self._far.sendto(datagram, ("127.0.0.1", self.chair_port))
                self.passed.append((monotonic(), datagram))
            elif self._sender is not None:
                self._near.sendto(datagram, self._sender)
                self.told.append(datagram)
        except OSError:
            pass  # the chair is being restarted
