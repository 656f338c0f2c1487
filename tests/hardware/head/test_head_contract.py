"""What the loop relies on, for every head tracker."""

import math

import pytest
from hardware.head.heads import HEADS, wait_for

ANGLES = (0.5, -0.25, 0.125)


@pytest.fixture(params=HEADS, ids=lambda made: made.__name__)
def source(request, tmp_path):
    made = request.param(tmp_path)
    yield made
    made.head.close()
    made.end()


def opened_pose(source):
    """Open a head tracker, and return the pose that comes."""
    source.head.open()
    source.let_come(*ANGLES)
    return wait_for(source.head, lambda _: True)


def test_nothing_is_known_before_it_is_open(source):
    assert source.head.newest() is None


def test_a_pose_comes_with_its_time_and_is_finite(source):
    source.head.open()
    before = source.clock.now()
    source.let_come(*ANGLES)
    pose = wait_for(source.head, lambda _: True)
    assert before <= pose.t <= source.clock.now()
    assert all(map(math.isfinite, pose))


@pytest.mark.parametrize("source", [made for made in HEADS if getattr(made, "exact", True)], indirect=True)
def test_angles_are_left_up_and_to_the_right_positive(source):
    assert opened_pose(source)[1:4] == pytest.approx(ANGLES, abs=5e-4)


def test_only_the_newest_is_kept_and_asking_does_not_make_it_newer(source):
    source.head.open()
    source.let_come(0.1, 0.0, 0.0)
    first = wait_for(source.head, lambda _: True)
    for step in range(1, 6):
        source.let_come(0.1 * step, 0.0, 0.0)
    later = wait_for(source.head, lambda pose: pose.t > first.t or pose.yaw != first.yaw)
    if getattr(source, "exact", True):
        assert wait_for(source.head, lambda pose: pose.yaw == pytest.approx(0.5, abs=5e-4)).t >= later.t
        assert source.head.newest() == source.head.newest()


def test_closed_it_knows_nothing_it_can_be_closed_again_and_opened_again(source):
    opened_pose(source)
    source.head.close()
    source.head.close()
    assert source.head.newest() is None
    assert opened_pose(source) is not None


def test_words_are_a_sentence_and_tell_open_from_closed(source):
    closed = str(source.head.description())
    opened_pose(source)
    running = str(source.head.description())
    assert closed != running
    assert closed.endswith(".")
    assert running.endswith(".")
