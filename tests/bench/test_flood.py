from bench.flood import measure_flood


def test_stops_are_timed_without_and_with_sign_ins_under_way():
    (row,) = measure_flood(runs=1, rounds=1, stops=3, sign_ins=10)
    assert row.figure > 0
    assert row.details.startswith("1 runs of 3 stops each; p99 ")
    assert '"503": ' in row.details  # two of the ten found no place
