import threading

import pytest
from fake_clock import FakeClock

from app.hardware.base import HardwareError
from app.pipeline.opening import MOST_STUCK, OPENING_LIMIT, DeviceChange, Openings, open_device
from app.texts import Text

WAIT = 10.0  # s


class Device:
    def __init__(self, trouble=None):
        self.trouble, self.closed = trouble, threading.Event()

    def open(self):
        if self.trouble is not None:
            raise self.trouble

    def close(self):
        self.closed.set()
        raise RuntimeError("not even that")


class OpeningDevices:
    def __init__(self):
        self.clock = FakeClock()
        self.openings = Openings(self.clock)
        self.taken, self.ended = [], []

    def begin(self, open_):
        self.openings.begin(DeviceChange("shirt", open_, self.taken.append), self.ended.append)

    def finish(self):
        self.openings._attempt.join(WAIT)
        self.openings.poll()


@pytest.fixture
def devices():
    return OpeningDevices()


def test_what_opened_is_put_to_use_on_the_loop(devices):
    opened_by = []
    device = Device()

    def open_():
        opened_by.append(threading.current_thread())
        return open_device(device)

    devices.begin(open_)
    assert devices.openings.busy
    devices.finish()
    assert (devices.taken, devices.ended, devices.openings.busy) == ([device], [None], False)
    assert opened_by != [threading.current_thread()]


def test_a_device_that_cannot_be_put_to_use_is_a_sentence(devices):
    def fails(_device):
        raise ValueError("nobody foresaw this")

    devices.openings.begin(DeviceChange("shirt", Device, fails), devices.ended.append)
    devices.finish()
    assert "report it" in str(devices.ended[0])
    assert not devices.openings.busy


@pytest.mark.parametrize(
    ("trouble", "sentence"),
    [
        (HardwareError("it is not there: plug it in"), "it is not there: plug it in"),
        (UnicodeError("label empty\nor too long"), "(UnicodeError: label empty or too long): check its settings."),
        (OSError(5, "\x00\u202e" + "x" * 5000), "check its settings."),
        (MemoryError(), "The shirt cannot be opened (MemoryError): check its settings."),
        (RecursionError("deep"), "RecursionError: deep"),
        (SystemError("odd"), "SystemError: odd"),
    ],
)
def test_whatever_a_driver_raises_is_one_sentence(devices, trouble, sentence):
    device = Device(trouble)
    devices.begin(lambda: open_device(device))
    devices.finish()
    assert devices.taken == []
    ended = str(devices.ended[0])
    assert sentence in ended
    assert ended.isprintable()
    assert len(ended) < 300
    assert device.closed.is_set()


def test_what_hangs_is_given_up_and_closed_when_it_comes_after_all(devices):
    release, device = threading.Event(), Device()

    def hang():
        release.wait(WAIT)
        return device

    devices.begin(hang)
    devices.clock.time += OPENING_LIMIT + 0.1
    devices.openings.poll()
    assert "did not open within 8 seconds" in str(devices.ended[0])
    assert not devices.openings.busy
    release.set()
    assert device.closed.wait(WAIT)
    assert devices.taken == []


def test_what_opened_at_the_last_moment_is_not_closed_on_the_loop(devices):
    device, closed_by = Device(), []
    device.close = lambda: (closed_by.append(threading.current_thread()), device.closed.set())
    devices.begin(lambda: device)
    attempt = devices.openings._attempt
    attempt.join(WAIT)
    attempt.give_up()
    assert device.closed.wait(WAIT)
    assert closed_by != [threading.current_thread()]


def test_no_more_threads_hang_than_memory_bears(devices):
    release = threading.Event()
    for _ in range(MOST_STUCK):
        devices.begin(lambda: release.wait(WAIT))
        devices.clock.time += OPENING_LIMIT + 0.1
        devices.openings.poll()
    devices.begin(Device)
    assert not devices.openings.busy
    assert devices.ended[-1] == Text("drives-others-hang", device="shirt", count=MOST_STUCK)
    release.set()
