"""Bluetooth sensors as bleak reaches them: they are looked for, connected, and connected again. A thread of its own."""

import asyncio
import math
import threading
from collections import deque
from collections.abc import Awaitable, Callable, Collection, Mapping
from contextlib import AbstractAsyncContextManager, suppress
from functools import partial
from typing import Any, Final, NamedTuple, Protocol, cast

from app.clock import Clock
from app.hardware.base import library_message
from app.hardware.shirt.orientation_sensors.witmotion import (
    ASK_VOLTAGE,
    NAME_BEGINS,
    NOTIFIED,
    WRITTEN,
    set_up_commands,
)

LOOK: Final = 5.0  # s of one look for sensors; less as soon as all that are missing were seen
LOOK_AGAIN: Final = 1.0  # s between two looks, and between two checks of the connections
CONNECT_LIMIT: Final = 10.0  # s for which one connection may take
SILENT: Final = 5.0  # s without a notification after which a connection is made anew
WRITE_LIMIT: Final = 1.0  # s that the question for a battery may take
VOLTAGE_EVERY: Final = 60.0  # s between two questions for the batteries
MOST_WAITING: Final = 8192  # notifications that wait for a loop that is held up: those of ten sensors in eight seconds
END_LIMIT: Final = 4.0  # s that the end of the connections may take


class BluetoothDevice(Protocol):
    """A device that a scanner has seen."""

    address: str
    """Its address, or what the system gives in place of it."""
    name: str | None


class BluetoothClient(Protocol):
    """A connection to a device."""

    @property
    def is_connected(self) -> bool:
        """Whether the connection stands."""
        ...

    def connect(self) -> Awaitable[object]:
        """Connect to the device."""
        ...

    def disconnect(self) -> Awaitable[object]:
        """End the connection."""
        ...

    def start_notify(self, char_specifier: str, callback: Callable[[Any, bytearray], None]) -> Awaitable[None]:
        """Call `callback` with what the device sends by a characteristic, from now on."""
        ...

    def write_gatt_char(self, char_specifier: str, data: bytes, response: bool) -> Awaitable[None]:
        """Write a characteristic."""
        ...


class BleakLibrary(Protocol):
    """The module bleak; what cannot be raises its BleakError, an OSError, or whatever the system's Bluetooth raises."""

    BleakScanner: Callable[..., AbstractAsyncContextManager[object]]
    BleakClient: Callable[..., BluetoothClient]


class SensorNotification(NamedTuple):
    """What a sensor has sent; empty content: it was connected."""

    address: str
    content: bytes
    t: float  # monotonic s, when it came


class SensorLinks(threading.Thread):
    """Keeps the connections to sensors, in a thread whose asyncio loop is bleak's alone.

    Sensors are looked for while one is missing or none is sought, and once more after that, so that others can be
    offered: looking takes time from the connections of the same radio.

    Attributes
    ----------
    notifications : deque of SensorNotification
        What has come, the oldest first; whoever takes it removes it.
    found : list of str
        The addresses of sensors that the newest look has seen and that are not sought.
    connected : set of str
        The addresses of the sensors that are connected and were set up.
    ready : threading.Event
        Set as soon as sensors are looked for, or `failure` says why that cannot be.
    failure : str
        Why Bluetooth cannot be used, empty when it can.
    trouble : str
        What the system's Bluetooth said last, of a look or a connection that failed; empty after one that did not.
    """

    def __init__(self, library: BleakLibrary, sought: Collection[str], sample_rate: float, clock: Clock) -> None:
        """`sought` has the addresses of the sensors to connect, in capital letters; `sample_rate` is in Hz."""
        super().__init__(name="Bluetooth", daemon=True)
        self.notifications: deque[SensorNotification] = deque(maxlen=MOST_WAITING)
        self.found: list[str] = []
        self.connected = set[str]()
        self.ready = threading.Event()
        self.failure = self.trouble = ""
        self._library = library
        self._sought = sorted(sought)
        self._set_up = set_up_commands(sample_rate)
        self._clock = clock
        self._clients: dict[str, BluetoothClient] = {}
        self._heard: dict[str, float] = {}  # s of the asyncio loop, when the newest notification came
        self._has_looked = False  # whether a look lasted its whole time
        self._asked = -math.inf  # s of the asyncio loop, when the batteries were asked for
        self._ended = False
        self._loop: asyncio.AbstractEventLoop | None = None
        self._task: asyncio.Task[Any] | None = None

    def run(self) -> None:
        """Keep the connections until `end`."""
        with asyncio.Runner() as runner, suppress(asyncio.CancelledError):
            runner.run(self._keep())

    def end(self) -> None:
        """Disconnect all sensors, and wait a little for that."""
        self._ended = True
        loop, task = self._loop, self._task
        if loop is not None and task is not None:
            with suppress(RuntimeError):  # the loop is closed already
                loop.call_soon_threadsafe(task.cancel)
        self.join(END_LIMIT)

    async def _keep(self) -> None:
        self._task, self._loop = asyncio.current_task(), asyncio.get_running_loop()
        try:
            while not self._ended:
                try:
                    await self._turn()
                except Exception as error:  # whatever the system's Bluetooth raises, it is tried again
                    self.trouble = library_message(error)
                    if not self.ready.is_set():
                        self.failure = self.trouble
                        self.ready.set()
                        return
                await asyncio.sleep(LOOK_AGAIN)
        finally:
            await self._disconnect(*self._clients)

    async def _turn(self) -> None:
        """Check the connections, and look for what is missing."""
        lost = [
            address
            for address, client in self._clients.items()
            if not client.is_connected or self._now() - self._heard[address] > SILENT
        ]
        await self._disconnect(*lost)
        await self._ask_voltages()
        missing = [address for address in self._sought if address not in self._clients]
        if missing or not self._sought or not self._has_looked:
            seen = await self._look(missing)
            self.trouble = ""
            for address in missing:
                if address in seen:
                    await self._connect(address, seen[address])

    async def _look(self, missing: Collection[str]) -> Mapping[str, BluetoothDevice]:
        """Look for sensors, and return those that announce themselves, by address."""
        seen: dict[str, BluetoothDevice] = {}
        are_all_seen = asyncio.Event()

        def detect(device: BluetoothDevice, advertisement: Any) -> None:
            address, name = device.address.upper(), advertisement.local_name or device.name or ""
            if address in missing or name.startswith(NAME_BEGINS):
                seen[address] = device
            if missing and all(each in seen for each in missing):
                are_all_seen.set()

        async with self._library.BleakScanner(detection_callback=detect):
            self.ready.set()
            try:
                await asyncio.wait_for(are_all_seen.wait(), LOOK)
            except TimeoutError:
                self._has_looked = True
        self.found = sorted(address for address in seen if address not in self._sought)
        return seen

    async def _connect(self, address: str, device: BluetoothDevice) -> None:
        """Connect a sensor, and let it send."""
        client = self._library.BleakClient(device, timeout=CONNECT_LIMIT)

        def take(_characteristic: Any, content: bytearray) -> None:
            self._heard[address] = self._now()
            if content:
                self.notifications.append(SensorNotification(address, bytes(content), self._clock.now()))

        self._clients[address], self._heard[address] = client, self._now()
        try:
            async with asyncio.timeout(CONNECT_LIMIT):
                await client.connect()
                self.notifications.append(SensorNotification(address, b"", self._clock.now()))
                await client.start_notify(NOTIFIED, take)
                for command in self._set_up:
                    await client.write_gatt_char(WRITTEN, command, response=False)
            self.connected.add(address)
        except Exception as error:  # the next turn tries again
            self.trouble = library_message(error)
            await self._disconnect(address)

    async def _disconnect(self, *addresses: str) -> None:
        """End the connections to these sensors, all at once: each may take a while."""
        self.connected.difference_update(addresses)
        clients = [self._clients.pop(address) for address in addresses]
        await asyncio.gather(*(_within(END_LIMIT / 2, client.disconnect) for client in clients))

    async def _ask_voltages(self) -> None:
        if self._clients and self._now() - self._asked > VOLTAGE_EVERY:
            self._asked = self._now()
            questions = [
                partial(client.write_gatt_char, WRITTEN, ASK_VOLTAGE, response=False)
                for client in self._clients.values()
            ]
            await asyncio.gather(*(_within(WRITE_LIMIT, question) for question in questions))

    def _now(self) -> float:
        return asyncio.get_running_loop().time()


async def _within(limit: float, call: Callable[[], Awaitable[object]]) -> None:
    """Await a call to a sensor for at most `limit` (s), whether it succeeds or not: the next turn shows a loss."""
    with suppress(Exception):
        async with asyncio.timeout(limit):
            await call()


def load_bleak() -> BleakLibrary:
    """Load bleak; raise ImportError without it."""
    import bleak  # noqa: PLC0415  # the web process imports this file, too

    return cast(BleakLibrary, bleak)
