import threading

import pytest
from fake_clock import FakeClock

from app.hardware.base import HardwareError
from app.pipeline.opening import MOST_STUCK, OPENING_LIMIT, Change, Openings, open_device

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


class Story:
    def __init__(self):
        self.clock = FakeClock()
        self.openings = Openings(self.clock)
        self.taken, self.ended = [], []

    def begin(self, open_):
        self.openings.begin(Change("shirt", open_, self.taken.append), self.ended.append)

    def finish(self):
        self.openings._attempt.join(WAIT)
        self.openings.poll()


@pytest.fixture
def story():
    return Story()


def test_what_opened_is_put_to_use_on_the_loop(story):
    opened_by = []
    device = Device()

    def open_():
        opened_by.append(threading.current_thread())
        return open_device(device)

    story.begin(open_)
    assert story.openings.busy
    story.finish()
    assert (story.taken, story.ended, story.openings.busy) == ([device], [""], False)
    assert opened_by != [threading.current_thread()]


def test_a_device_that_cannot_be_put_to_use_is_a_sentence(story):
    def fails(_device):
        raise ValueError("nobody foresaw this")

    story.openings.begin(Change("shirt", Device, fails), story.ended.append)
    story.finish()
    assert "report it" in story.ended[0]
    assert not story.openings.busy


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
def test_whatever_a_driver_raises_is_one_sentence(story, trouble, sentence):
    device = Device(trouble)
    story.begin(lambda: open_device(device))
    story.finish()
    assert story.taken == []
    assert sentence in story.ended[0]
    assert story.ended[0].isprintable()
    assert len(story.ended[0]) < 300
    assert device.closed.is_set()


def test_what_hangs_is_given_up_and_closed_when_it_comes_after_all(story):
    release, device = threading.Event(), Device()

    def hang():
        release.wait(WAIT)
        return device

    story.begin(hang)
    story.clock.time += OPENING_LIMIT + 0.1
    story.openings.poll()
    assert "did not open within 8 seconds" in story.ended[0]
    assert not story.openings.busy
    release.set()
    assert device.closed.wait(WAIT)
    assert story.taken == []


def test_no_more_threads_hang_than_memory_bears(story):
    release = threading.Event()
    for _ in range(MOST_STUCK):
        story.begin(lambda: release.wait(WAIT))
        story.clock.time += OPENING_LIMIT + 0.1
        story.openings.poll()
    story.begin(Device)
    assert not story.openings.busy
    assert "still hang: start bodydrive again" in story.ended[-1]
    release.set()
