from app.bench.viewers import REACH, measure_viewers


def test_the_viewers_are_served_and_their_cost_is_measured():
    (row,) = measure_viewers(viewers=2, runs=1, seconds=0.5)
    assert row.figure > 0
    assert (row.reach, row.better) == (REACH, "lower")
    messages = float(row.details.split("at least ")[1].split()[0])
    assert messages > 1
