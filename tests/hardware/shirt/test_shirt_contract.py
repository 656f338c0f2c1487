"""What the loop relies on, for every shirt."""

from itertools import pairwise

import numpy as np
import pytest
from hardware.shirt.shirts import SHIRTS

LONG_ENOUGH = 2.0  # s; frames that were let come are there long before


@pytest.fixture(params=SHIRTS, ids=lambda made: made.__name__)
def source(request, tmp_path):
    made = request.param(tmp_path)
    yield made
    made.shirt.close()
    made.end()


def test_layout_and_rate_are_known_once_open(source):
    source.shirt.open()
    assert len(source.shirt.layout.channels) >= 3
    assert source.shirt.sample_rate == source.rate
    assert source.shirt.lost == 0


def test_every_frame_comes_once_and_in_order(source):
    source.shirt.open()
    source.let_come(20)
    frames = [source.shirt.read(LONG_ENOUGH) for _ in range(20)]
    assert [frame.seq for frame in frames] == list(range(20))
    np.testing.assert_allclose(np.diff([frame.t_device for frame in frames]), 1 / source.rate, atol=2e-6)
    shape = (len(source.shirt.layout.channels),)
    assert all(frame.values.shape == shape and frame.values.dtype == np.float32 for frame in frames)
    assert all(later.t >= earlier.t for earlier, later in pairwise(frames))
    assert source.shirt.lost == 0


def test_a_frame_keeps_its_values_when_the_next_one_comes(source):
    source.shirt.open()
    source.let_come(2)
    first = source.shirt.read(LONG_ENOUGH)
    kept = first.values.copy()
    source.shirt.read(LONG_ENOUGH)
    np.testing.assert_array_equal(first.values, kept)


def test_pending_tells_whether_a_frame_is_there(source):
    source.shirt.open()
    source.let_come(2)
    source.shirt.read(LONG_ENOUGH)
    assert source.shirt.pending()
    source.shirt.read(LONG_ENOUGH)
    assert not source.shirt.pending()


def test_read_gives_up_after_its_timeout(source):
    source.shirt.open()
    source.let_come(1)
    source.shirt.read(LONG_ENOUGH)
    before = source.clock.now()
    assert source.shirt.read(0.004) is None
    assert 0.003 < source.clock.now() - before < 1.0
    assert source.shirt.read(0.0) is None


def test_a_closed_shirt_gives_nothing_and_can_be_closed_again_and_opened_again(source):
    source.shirt.open()
    source.let_come(3)
    source.shirt.read(LONG_ENOUGH)
    source.shirt.close()
    source.shirt.close()
    before = source.clock.now()
    assert source.shirt.read(0.003) is None
    assert source.clock.now() - before > 0.002, "a loop around it must not spin"
    assert not source.shirt.pending()
    source.shirt.open()
    assert source.shirt.lost == 0
    source.let_come(1)
    assert source.shirt.read(LONG_ENOUGH) is not None


def test_words_are_a_sentence_and_tell_open_from_closed(source):
    closed = str(source.shirt.description())
    source.shirt.open()
    source.let_come(1)
    source.shirt.read(LONG_ENOUGH)
    running = str(source.shirt.description())
    assert closed != running
    assert closed.endswith(".")
    assert running.endswith(".")
    assert f"{len(source.shirt.layout.channels)} sensors" in running
