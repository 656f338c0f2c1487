import math
import threading

import pytest
from fake_clock import FakeClock

from app.hardware.base import HardwareError
from app.hardware.configs import TabletHeadConfig
from app.messages import Tick
from app.pipeline.setup import NO_TRACKER, HeadTracking


@pytest.fixture
def head():
    return HeadTracking(FakeClock(10.0))


def use(head):
    change = head.change(TabletHeadConfig(kind="tablet"))
    change.use(change.open())


def noted(head, t=10.0):
    tick = Tick(head_yaw=9.0, head_pitch=9.0, head_roll=9.0, head_age=9.0)
    head.note(tick, t)
    return tick.head_yaw, tick.head_pitch, tick.head_roll, tick.head_age


def test_without_a_tracker_nothing_is_known(head):
    assert all(map(math.isnan, noted(head)))
    assert head.description == NO_TRACKER
    assert not head.look(0.0, 0.0, 0.0)
    assert not head.set_ahead()


def test_a_pose_is_in_every_tick_and_grows_older(head):
    use(head)
    assert all(map(math.isnan, noted(head)))
    assert head.look(0.5, -0.25, 0.125)
    assert noted(head) == (0.5, -0.25, 0.125, 0.0)
    assert noted(head, 12.5) == (0.5, -0.25, 0.125, 2.5)
    assert head.kind == "tablet"


def test_straight_ahead_is_where_one_says(head):
    use(head)
    head.look(3.0, 0.2, 0.1)
    assert head.set_ahead()
    assert noted(head)[:3] == (0.0, 0.0, 0.0)
    head.look(-3.0, 0.2, 0.1)
    assert noted(head)[0] == pytest.approx(math.tau - 6.0), "the short way round"
    use(head)
    head.look(1.0, 0.0, 0.0)
    assert noted(head)[0] == 1.0, "another tracker begins anew"


class Broken:
    """A tracker whose device breaks."""

    def __init__(self):
        self.closed = threading.Event()

    def open(self):
        """It can be had."""

    def newest(self):
        raise RuntimeError("no more")

    def description(self):
        return "It is fine."

    def close(self):
        self.closed.set()


def test_a_tracker_that_fails_is_let_go_and_said(head, monkeypatch):
    broken = Broken()
    monkeypatch.setattr("app.pipeline.setup.make_head", lambda _config, _clock: broken)
    use(head)
    assert all(map(math.isnan, noted(head)))
    assert broken.closed.wait(10.0), "in a thread of its own"
    assert str(head.description) == "The head tracker failed (no more): choose it again."
    assert all(map(math.isnan, noted(head)))
    head.close()
    assert head.description == NO_TRACKER


def test_a_tracker_that_cannot_be_had_leaves_none(head, monkeypatch):
    use(head)

    def refuse(_config, _clock):
        raise HardwareError("it is not there")

    monkeypatch.setattr("app.pipeline.setup.make_head", refuse)
    with pytest.raises(HardwareError):
        use(head)
    assert head.description == NO_TRACKER


def test_a_tracker_that_fails_even_to_close_is_let_go(head, monkeypatch):
    class Stuck(Broken):
        def close(self):
            raise RuntimeError("not even that")

    monkeypatch.setattr("app.pipeline.setup.make_head", lambda _config, _clock: Stuck())
    use(head)
    assert all(map(math.isnan, noted(head)))
    assert "no more" in str(head.description)
