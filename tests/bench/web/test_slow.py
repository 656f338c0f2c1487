import pytest

from bench.web.slow import measure_slow_pages

pytestmark = pytest.mark.long  # it times answers of a loaded web process


def test_stops_are_timed_without_and_beside_pages_that_hardly_read() -> None:
    ratio, p99, turn, share = measure_slow_pages(rounds=1, stops=10, reading=2, slow=5)
    assert ratio.figure > 0
    assert p99.figure > 0
    assert '"slow pages opened": 5' in ratio.details
    assert 0 < turn.figure < 1000
    assert 0 < share.figure < 100
