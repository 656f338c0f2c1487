import pytest

from bench.web.review import KINDS, measure_review


@pytest.mark.long
def test_each_kind_of_review_has_its_three_rows_and_every_request_is_answered() -> None:
    rows = measure_review(runs=1, rounds=1, stops=40, drives=1, seconds=1.0)
    assert len(rows) == 3 * len(KINDS)
    assert all(row.figure > 0 for row in rows)
    for stops in rows[::3]:
        words = stops.details.partition("by status: ")[2]
        assert words.startswith("{")
        assert not any(f'"{status}"' in words for status in (403, 404, 409, 422, 500))
