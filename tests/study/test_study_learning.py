"""The person who learns shows a trend, the one who does not shows none: a small study on a short path.

What 20 people do on the clinic's path takes half an hour of a processor; docs/learning/simulated-person.md says it.
Here two people who learn as fast as the published ranges allow drive 12 m eight times.
"""

import dataclasses

import numpy as np
import pytest

from app.hardware.body.parameter_ranges import RANGES, out_of_range
from app.hardware.body.person_parameters import NOVICE
from app.study.seeds import comparable_table, measure_over_seeds, run_seeds
from app.world.floorplan import FloorPlan

pytestmark = pytest.mark.long

SEEDS = (1, 2)
TRIALS = 8
PRACTISED_QUANTITIES = ("hesitation", "stroke_noise", "wrong_limb", "estimate_error", "heading_tolerance")
QUICK = dataclasses.replace(
    NOVICE,
    correction=RANGES["correction"].high,
    **{name: getattr(NOVICE, name)._replace(strokes=RANGES[f"{name}.strokes"].low) for name in PRACTISED_QUANTITIES},
)
BENDS = {"name": "bends", "title": "Two bends", "points": ((0.0, 0.0), (4.0, 0.0), (4.0, 4.0), (8.0, 4.0))}
LIMIT = 60.0  # s: who is lost by then does not find back, and such a trial does not count
PATH = BENDS | {"instruction": "Go.", "time_limit": LIMIT}
PLAN = FloorPlan(name="open", title="Open floor", walls=(), paths=(PATH,))


@pytest.fixture(scope="module")
def learners():
    return run_seeds(SEEDS, TRIALS, PLAN, "bends", QUICK)


@pytest.fixture(scope="module")
def others():
    return run_seeds(SEEDS, TRIALS, PLAN, "bends", dataclasses.replace(QUICK, learns=False))


def test_the_quick_learner_is_a_plausible_person() -> None:
    assert out_of_range(QUICK) == ()


def test_with_learning_the_distance_falls_in_everybody(learners) -> None:
    over = measure_over_seeds(learners, "dist")
    assert over.falls == len(SEEDS), over
    e_diff = comparable_table(learners, "e_diff")
    assert np.all(np.mean(e_diff[:, -3:], axis=1) < 0.8 * np.mean(e_diff[:, :3], axis=1))


def test_without_learning_nothing_falls(others) -> None:
    for measure in ("dist", "e_diff"):
        over = measure_over_seeds(others, measure)
        assert over.falls == 0, over
        assert over.no_trend == len(SEEDS), over


def test_the_same_people_drive_better_with_learning(learners, others) -> None:
    for measure in ("dist", "e_diff"):
        last = [np.nanmean(comparable_table(results, measure)[:, -3:]) for results in (learners, others)]
        assert last[0] < last[1]
