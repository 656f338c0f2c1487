from bench.web.long_trajectory import REACH, measure_trajectory


def test_a_longer_trajectory_sends_no_more():
    sent, used = measure_trajectory(rounds=1, long=1200)
    assert 0.8 < sent.figure <= REACH["bytes"]
    assert used.figure > 0
