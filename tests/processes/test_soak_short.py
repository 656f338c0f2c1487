"""Some seconds of the soak on real processes; `make soak` runs ten minutes and measures the pace."""

from soak.soak import MOST_GROWTH, OTHERS, STOPPED, soak


def test_a_stopped_viewer_harms_nobody_and_comes_back():
    found = soak(seconds=5.0, warm=1.0, every=1.0, compared=False)
    assert found.growth <= MOST_GROWTH / 10
    assert all(any(interval.rates[one] > 0 for interval in found.during) for one in OTHERS)
    assert found.before[-1].rates[STOPPED] > 0
    assert found.returned is not None
