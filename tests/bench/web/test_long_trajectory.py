from bench.web.long_trajectory import SHORT, measure_trajectory

LONG = 1200  # points


def test_a_longer_trajectory_sends_no_more() -> None:
    sent, used = measure_trajectory(rounds=1, long=LONG)
    # Updates that a busy machine sends together are fewer bytes. Who sent all points anew would send six times as much.
    assert 0.5 < sent.figure < LONG / SHORT / 3
    assert used.figure > 0
