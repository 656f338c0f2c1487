"""The judge of the drill of random schedules finds a chair that becomes faster where it must slow, and no other."""

import pytest
from drills.schedules import Forbidden, faster

HOLD = [Forbidden(1.0, 2.0, "a hold")]


def lines(*speeds):
    return [{"t": 0.9 + 0.2 * number, "v": v} for number, v in enumerate(speeds)]


@pytest.mark.parametrize(
    ("speeds", "found"),
    [
        ((0.1, 0.3, 0.2, 0.1, 0.0, 0.0), 0),  # faster before the time began
        ((0.3, 0.3, 0.2, 0.2, 0.2, 0.2, 0.5), 0),  # ... and after it had ended
        ((0.367, 0.367, 0.367, 0.371, 0.2, 0.0), 1),
        ((-0.3, -0.3, -0.2, -0.3, 0.0, 0.1), 2),
        ((0.0, 0.0, 0.0, 0.0, 0.0, 0.0), 0),
    ],
)
def test_it_finds_a_chair_that_becomes_faster(speeds, found):
    assert len(faster(lines(*speeds), HOLD, late=0.0)) == found


def test_a_machine_that_was_late_is_given_as_much_time():
    assert faster(lines(0.3, 0.3, 0.4, 0.3, 0.2), HOLD, late=0.5) == []
