"""Some seconds of the soaks on real processes; `make soak` and `make long-recording` run for long."""

from soak.recording import record_quickly
from soak.soak import MOST_GROWTH, OTHERS, STOPPED, soak


def test_a_stopped_viewer_harms_nobody_and_comes_back():
    found = soak(seconds=5.0, warm=1.0, every=1.0, compared=False)
    assert found.growth <= MOST_GROWTH / 10
    assert all(any(interval.rates[one] > 0 for interval in found.during) for one in OTHERS)
    assert found.before[-1].rates[STOPPED] > 0
    assert found.returned is not None


def test_ten_minutes_of_a_recording_have_no_gap_and_need_little_memory(tmp_path):
    found = record_quickly(tmp_path / "run", seconds=600)
    assert found.is_whole, found
    assert found.rows == 60_000
