"""The task that is proposed: the first one, the last one again, or its next level."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from app.scoring.next_task import FIRST, TRIALS, DrivenTask, NextTask, is_worse_than_noise, next_task, went_well
from app.world.scene import bundled_places
from app.world.task_groups import group_of

PLACES = bundled_places()
TASKS = [(name, path.name) for name, place in PLACES.items() for path in place.plan.paths]


def trial(task, *, well=True, counts=True, group="worn"):
    return DrivenTask(*task, group, counts, well)


def never(_floorplan, _path):
    return False


def test_a_new_patient_begins_in_the_corridors_of_the_study():
    assert next_task([], "worn", PLACES, never) == NextTask("clinic", "main", "first")
    assert FIRST in TASKS


DOOR = ("door.easy", "aside")
GOOD = [trial(DOOR)] * TRIALS


@pytest.mark.parametrize(
    ("trials", "expected"),
    [
        (GOOD, ("door.medium", "aside", "next level")),
        (GOOD[1:], (*DOOR, "again")),
        ([*GOOD, trial(DOOR, well=False)], (*DOOR, "again")),
        ([trial(DOOR, well=False), *GOOD], ("door.medium", "aside", "next level")),
        ([*GOOD, trial(DOOR, well=False, counts=False)], ("door.medium", "aside", "next level")),
        ([trial(DOOR, group="simulated")] * TRIALS, (*DOOR, "again")),
        ([*GOOD, trial(("door.easy", "straight"))], ("door.easy", "straight", "again")),
        ([*GOOD[1:], trial(("desert.hard", "way")), trial(DOOR)], ("door.medium", "aside", "next level")),
        ([trial(("door.hard", "aside"))] * TRIALS, ("door.hard", "aside", "again")),
        ([trial(("apartment", "main"))] * TRIALS, ("apartment", "main", "again")),
        ([trial(DOOR), trial(("gone", "main"))], (*DOOR, "again")),
        ([trial(("door.easy", "gone"))], (*FIRST, "first")),
    ],
)
def test_the_next_level_comes_after_three_good_trials_that_count(trials, expected):
    assert next_task(trials, "worn", PLACES, never) == expected


def test_no_level_is_added_while_the_newest_trials_are_worse_than_noise():
    asked = []
    found = next_task(GOOD, "worn", PLACES, lambda *task: asked.append(task) or True)
    assert (found, asked) == (NextTask(*DOOR, "again"), [DOOR])
    next_task(GOOD[1:], "worn", PLACES, lambda *task: asked.append(task) or True)
    assert asked == [DOOR]  # noise is estimated only where a next level is due


def rows(values, name="e_diff", warming=3):
    """Return rows of one session with these values, the first of them for getting used to the task."""
    return [
        {"id": 100 + i, "number": i + 1, "session": 1, "familiarisation": i < warming, "reached": True, name: value}
        for i, value in enumerate(values)
    ]


EVEN = [3.0, 2.5, 2.2, 2.0, 2.1, 1.9, 2.0, 2.05, 1.95]


@pytest.mark.parametrize(
    ("values", "name", "worse"),
    [
        (EVEN, "e_diff", False),
        ([*EVEN, 9.0], "e_diff", True),
        ([*EVEN, 9.0, 2.0, 2.0], "e_diff", True),  # still one of the last three
        ([*EVEN, 9.0, 2.0, 2.0, 2.0], "e_diff", False),
        ([*EVEN, 0.5], "e_diff", False),  # better is not worse
        ([*EVEN, 9.0], "time", True),  # a task without a path to be off
        ([2.0, 2.0, 9.0], "e_diff", False),  # getting used to it: no verdict
        ([], "e_diff", False),
    ],
)
def test_trials_are_worse_when_one_of_the_last_three_is_worse_than_noise(values, name, worse):
    assert is_worse_than_noise(rows(values, name), {}) is worse


SOME_TRIAL = st.builds(trial, st.sampled_from([*TASKS, ("gone", "main")]), well=st.booleans(), counts=st.booleans())


@given(st.lists(SOME_TRIAL))
def test_what_is_proposed_is_always_offered(trials):
    found = next_task(trials, "worn", PLACES, never)
    assert (found.floorplan, found.path) in TASKS


def test_a_trial_went_well_when_it_reached_its_goal_without_contact():
    good = {"reached": True, "collisions": 0}
    assert went_well("goal", good)
    assert not went_well("by hand", good)
    assert not went_well("goal", None)
    assert not went_well("goal", {**good, "reached": False})
    assert not went_well("goal", {**good, "collisions": 1})
    assert not went_well("goal", {"reached": True})  # an older trial whose contacts were not counted


def test_every_place_that_comes_with_the_software_has_a_group():
    assert {group_of(place) for place in PLACES.values()} == {
        "first",
        "corridors",
        "doors",
        "obstacles",
        "following",
        "outdoors",
    }
