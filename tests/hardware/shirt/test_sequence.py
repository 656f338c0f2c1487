from hypothesis import given
from hypothesis import strategies as st

from app.hardware.shirt.frame_order import RESTART_AFTER, Sequence


@given(st.integers(0, 2**32 - 1), st.lists(st.integers(1, 1000), max_size=50))
def test_gaps_are_counted_and_the_counter_may_wrap(start, steps):
    sequence = Sequence()
    seq = start
    assert sequence.accept(seq)
    for step in steps:
        seq = (seq + step) % 2**32
        assert sequence.accept(seq)
    assert sequence.lost == sum(steps) - len(steps)
    assert sequence.dropped == sequence.restarts == 0


@given(st.integers(0, 2**32 - 1), st.lists(st.integers(0, 500), min_size=1, max_size=30))
def test_late_and_repeated_frames_between_new_ones_are_dropped(start, behind):
    sequence = Sequence()
    seq = start
    sequence.accept(seq)
    for back in behind:
        seq = (seq + 1) % 2**32
        assert sequence.accept(seq)
        assert not sequence.accept((seq - back) % 2**32)
    assert sequence.dropped == len(behind)
    assert sequence.lost == sequence.restarts == 0


@given(st.integers(RESTART_AFTER + 1, 2**32 - 2**20 - 1))
def test_a_device_that_begins_anew_is_heard_again_soon(last):
    sequence = Sequence()
    sequence.accept(last)
    taken = [sequence.accept(seq) for seq in range(RESTART_AFTER + 20)]
    assert all(taken[RESTART_AFTER:])
    assert sequence.lost < RESTART_AFTER
    if last < 2**31:
        assert sequence.restarts == 1


def test_a_device_that_begins_anew_far_ahead_has_lost_nothing():
    sequence = Sequence()
    sequence.accept(5)
    assert sequence.accept(1_900_000_000)
    assert sequence.lost == 0
    assert sequence.restarts == 1
