import math

import pytest

from app.clock import FakeClock
from app.hardware.base import HardwareError
from app.hardware.configs import TabletHeadConfig
from app.messages import Tick
from app.pipeline.head_pose import NOBODY, Looking


@pytest.fixture
def looking():
    return Looking(FakeClock(10.0))


def use(looking):
    change = looking.change(TabletHeadConfig(kind="tablet"))
    change.take(change.open())


def noted(looking, t=10.0):
    tick = Tick(head_yaw=9.0, head_pitch=9.0, head_roll=9.0, head_age=9.0)
    looking.note(tick, t)
    return tick.head_yaw, tick.head_pitch, tick.head_roll, tick.head_age


def test_without_a_tracker_nothing_is_known(looking):
    assert all(map(math.isnan, noted(looking)))
    assert looking.words == NOBODY
    assert not looking.look(0.0, 0.0, 0.0)
    assert not looking.set_ahead()


def test_a_pose_is_in_every_tick_and_grows_older(looking):
    use(looking)
    assert all(map(math.isnan, noted(looking)))
    assert looking.look(0.5, -0.25, 0.125)
    assert noted(looking) == (0.5, -0.25, 0.125, 0.0)
    assert noted(looking, 12.5) == (0.5, -0.25, 0.125, 2.5)
    assert looking.kind == "tablet"


def test_straight_ahead_is_where_one_says(looking):
    use(looking)
    looking.look(3.0, 0.2, 0.1)
    assert looking.set_ahead()
    assert noted(looking)[:3] == (0.0, 0.0, 0.0)
    looking.look(-3.0, 0.2, 0.1)
    assert noted(looking)[0] == pytest.approx(math.tau - 6.0), "the short way round"
    use(looking)
    looking.look(1.0, 0.0, 0.0)
    assert noted(looking)[0] == 1.0, "another tracker begins anew"


class Broken:
    """A tracker whose device breaks."""

    closed = False

    def open(self):
        """It can be had."""

    def newest(self):
        raise RuntimeError("no more")

    def words(self):
        return "It is fine."

    def close(self):
        self.closed = True


def test_a_tracker_that_fails_is_let_go_and_said(looking, monkeypatch):
    broken = Broken()
    monkeypatch.setattr("app.pipeline.head_pose.make_head", lambda _config, _clock: broken)
    use(looking)
    assert all(map(math.isnan, noted(looking)))
    assert broken.closed
    assert looking.words == "The head tracker failed (no more): choose it again."
    assert all(map(math.isnan, noted(looking)))
    looking.close()
    assert looking.words == NOBODY


def test_a_tracker_that_cannot_be_had_leaves_none(looking, monkeypatch):
    use(looking)

    def refuse(_config, _clock):
        raise HardwareError("it is not there")

    monkeypatch.setattr("app.pipeline.head_pose.make_head", refuse)
    with pytest.raises(HardwareError):
        use(looking)
    assert looking.words == NOBODY


def test_a_tracker_that_fails_even_to_close_is_let_go(looking, monkeypatch):
    class Stuck(Broken):
        def close(self):
            raise RuntimeError("not even that")

    monkeypatch.setattr("app.pipeline.head_pose.make_head", lambda _config, _clock: Stuck())
    use(looking)
    assert all(map(math.isnan, noted(looking)))
    assert "no more" in looking.words
