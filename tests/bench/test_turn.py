from bench.turn import PARTS, measure_turn


def test_every_part_of_a_turn_is_measured() -> None:
    rows = measure_turn(runs=1, frames=200, echoes=20)
    assert [row.what.partition(": ")[2] for row in rows] == list(PARTS.values())
    assert all(row.figure >= 0.0 for row in rows)
    assert sum(row.figure > 0.0 for row in rows) >= len(rows) - 1  # a busy machine may have no waking to see
