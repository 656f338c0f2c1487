"""The task that is proposed: the first one, the last one again, or its next level."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from app.scoring.next_task import FIRST, TRIALS, NextTask, PastTrial, next_task, went_well
from app.world.scene import bundled_places
from app.world.task_groups import group_of

PLACES = bundled_places()
TASKS = [(name, path.name) for name, place in PLACES.items() for path in place.plan.paths]


def trial(task, *, well=True, counts=True, group="worn"):
    return PastTrial(*task, group, counts, well)


def test_a_new_patient_begins_in_the_corridors_of_the_study():
    assert next_task([], "worn", PLACES) == NextTask("clinic", "main", "first")
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
    assert next_task(trials, "worn", PLACES) == expected


SOME_TRIAL = st.builds(trial, st.sampled_from([*TASKS, ("gone", "main")]), well=st.booleans(), counts=st.booleans())


@given(st.lists(SOME_TRIAL))
def test_what_is_proposed_is_always_offered(trials):
    found = next_task(trials, "worn", PLACES)
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
