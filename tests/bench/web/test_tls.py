from bench.circle import ROUND
from bench.web.tls import measure_tls


def test_the_same_figures_are_measured_over_http_and_over_https() -> None:
    rows = measure_tls(turns=1, seconds=0.5)
    assert [row.what.count("https") for row in rows] == [0, 0, 0, 1, 1, 1]
    assert [row.unit for row in rows] == ["% of one core", "ms", "ms"] * 2
    assert all(0 < row.figure < 1000 * ROUND for row in rows)
