"""The part of bleak that the program uses, without Bluetooth: sensors of WitMotion that send what a test lets them."""

import asyncio
import struct
import threading
from types import SimpleNamespace

from app.clock import monotonic

ANSWER = 20.0  # s that anything between two threads may take
ASK_VOLTAGE = bytes((0xFF, 0xAA, 0x27, 0x64, 0x00))
DEGREE = 32768 / 180  # steps


def wait_for(condition):
    """Wait until something has happened in another thread."""
    end = monotonic() + ANSWER
    pause = threading.Event()
    while not condition():
        assert monotonic() < end
        pause.wait(0.005)


class FakeSensor:
    """A sensor that announces itself while it is on and not connected."""

    def __init__(self, address, name="WT901BLE68"):
        self.address, self.name = address, name
        self.is_on, self.is_connected = True, False
        self.hangs = False  # whether a question for its battery takes for ever
        self.connections = 0
        self.written = []
        self.volts = None  # what it answers when it is asked; None: nothing
        self.angles = (0.0, 0.0, 0.0)  # roll, pitch, yaw in degrees
        self._connected = threading.Event()
        self._callback = self._loop = None
        self._count = 0

    def motion(self):
        """Return the next frame: the acceleration, which is never quite still, and the angles."""
        self._count += 1
        angles = (round(angle * DEGREE) for angle in self.angles)
        return struct.pack("<BB9h", 0x55, 0x61, self._count % 1000, 0, 2048, 0, 0, 0, *angles)

    def send(self, content=None):
        """Notify the program of `content`, or of the next frame, and wait until it has taken that."""
        is_taken = threading.Event()
        self._loop.call_soon_threadsafe(self._notify, self.motion() if content is None else content, is_taken)
        assert is_taken.wait(ANSWER)

    @property
    def is_asked(self):
        """Whether the program is connected and has asked to be notified."""
        return self.is_connected and self._connected.is_set()

    def wait_until_connected(self):
        assert self._connected.wait(ANSWER)

    def switch_off(self):
        self.is_on = self.is_connected = False
        self._connected.clear()

    def switch_on(self):
        self.is_on = True

    def begin(self, callback):
        self._callback, self._loop = callback, asyncio.get_running_loop()
        self.connections += 1
        self._connected.set()

    def end(self):
        self.is_connected = False
        self._connected.clear()

    def answer(self):
        if self.volts is not None:
            content = struct.pack("<BBHH14x", 0x55, 0x71, 0x64, round(100 * self.volts))
            asyncio.get_running_loop().call_soon(self._callback, None, bytearray(content))

    def _notify(self, content, is_taken):
        if self.is_connected:
            self._callback(None, bytearray(content))
        is_taken.set()


class FakeScanner:
    """Calls back for each sensor that announces itself."""

    def __init__(self, bleak, detection_callback):
        self._bleak, self._detect = bleak, detection_callback

    async def __aenter__(self):
        if self._bleak.failure is not None:
            raise self._bleak.failure
        self._bleak.looks += 1
        self._announcing = asyncio.create_task(self._announce())
        return self

    async def __aexit__(self, *_):
        self._announcing.cancel()

    async def _announce(self):
        while True:
            for sensor in self._bleak.sensors:
                if sensor.is_on and not sensor.is_connected:
                    self._detect(sensor, SimpleNamespace(local_name=sensor.name))
            await asyncio.sleep(0.01)


class FakeClient:
    """A connection to a sensor."""

    def __init__(self, bleak, sensor, timeout):
        assert timeout > 0.0
        self._bleak, self._sensor = bleak, sensor

    @property
    def is_connected(self):
        return self._sensor.is_connected

    async def connect(self):
        if self._bleak.refusals:
            raise self._bleak.refusals.pop()
        if not self._sensor.is_on:
            raise OSError("the sensor is off")
        self._sensor.is_connected = True

    async def disconnect(self):
        if self._bleak.ends is not None:
            await self._bleak.ends.wait()
        self._sensor.end()

    async def start_notify(self, characteristic, callback):
        assert characteristic.startswith("0000ffe4")
        self._sensor.begin(callback)

    async def write_gatt_char(self, characteristic, data, response):
        assert characteristic.startswith("0000ffe9")
        assert not response
        self._sensor.written.append(data)
        if data == ASK_VOLTAGE:
            if self._sensor.hangs:
                await asyncio.Event().wait()
            self._sensor.answer()


class FakeBleak:
    """The module bleak, and the sensors near this machine."""

    def __init__(self):
        self.sensors = []
        self.failure = None  # what every look for sensors raises
        self.refusals = []  # what the next connections raise
        self.looks = 0
        self.ends = None  # a barrier that as many disconnections as it has places reach at once; None: each ends alone

    def BleakScanner(self, detection_callback):  # noqa: N802
        return FakeScanner(self, detection_callback)

    def BleakClient(self, sensor, timeout):  # noqa: N802
        return FakeClient(self, sensor, timeout)

    def add_sensor(self, address, **fields):
        self.sensors.append(FakeSensor(address, **fields))
        return self.sensors[-1]
