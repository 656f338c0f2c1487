"""Each fault drill with few runs, on real processes and sockets; `make drills` runs them in full.

Drills that judge how quickly a loaded web process answers need a quiet machine, and those with a rig for each output
take long: only `make drills` runs them.
"""

import asyncio
import random

import pytest
from drills.drills import DRILLS
from drills.schedules import Forbidden, faster

ONLY_IN_FULL = {"sign-ins", "uploads", "second-socket", "large-plan", "outputs-stop"}
NAMES = [pytest.param(name, marks=[pytest.mark.long] if name in ONLY_IN_FULL else []) for name in DRILLS]


@pytest.mark.parametrize("name", NAMES)
def test_drill(name):
    drill, _, runs = DRILLS[name]
    result = asyncio.run(drill(runs, random.Random(7)))
    assert result.runs == runs
    assert not result.violations, result.row()


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
def test_the_judge_of_random_schedules_finds_a_chair_that_becomes_faster(speeds, found):
    assert len(faster(lines(*speeds), HOLD, late=0.0)) == found


def test_a_machine_that_was_late_is_given_as_much_time():
    assert faster(lines(0.3, 0.3, 0.4, 0.3, 0.2), HOLD, late=0.5) == []
