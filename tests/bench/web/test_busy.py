import pytest

from bench.web.busy import measure_first_pages, measure_flood, measure_records

pytestmark = pytest.mark.long  # it times answers of a loaded web process


def test_stops_are_timed_without_and_with_sign_ins_under_way() -> None:
    (row,) = measure_flood(runs=1, rounds=1, stops=3, sign_ins=10)
    assert row.figure > 0
    assert row.details.startswith("1 runs of 3 stops each; p99 ")
    assert '"503": ' in row.details  # two of the ten found no place


def test_stops_are_timed_while_pages_are_opened_for_the_first_time() -> None:
    (row,) = measure_first_pages(runs=1, rounds=1, stops=20)
    assert row.figure > 0
    assert '{"200": ' in row.details


def test_stops_are_timed_while_records_are_made() -> None:
    (row,) = measure_records(runs=1, rounds=1, stops=40)
    assert row.figure > 0
    assert '{"200": ' in row.details
    assert row.details.count(": ") == 2  # all answers had that status
