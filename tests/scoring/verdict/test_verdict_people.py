"""Simulated people: without a change few are called better or worse, and after twice the MDC nearly all are better.

The seeds are fixed. `make verdicts` prints the tables of docs/learning/verdicts.md, with the rows tested here.
"""

import pytest

from bench.learning.verdicts import learners, outcomes

PEOPLE = 500


@pytest.mark.parametrize("layout", [(3, 2), (5, 5), (5, 5, 5, 5), (10,)], ids=str)
def test_noise_is_not_called_a_change_and_twice_the_mdc_is(layout: tuple[int, ...]) -> None:
    share = outcomes(layout, PEOPLE)
    assert share.false <= 0.05
    assert share.found >= 0.9
    assert share.found_true >= 0.9


def test_an_improving_person_is_called_better_than_at_first_and_never_worse() -> None:
    shares = dict(learners(100, seed=15))
    assert shares["the last session against the first: better"] >= 0.6
    assert max(share for words, share in shares.items() if "worse" in words) <= 0.05
