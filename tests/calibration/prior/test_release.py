"""Releases of a clinic's prior: whatever is added up or subtracted, no sum over fewer than eight people comes out."""

from itertools import combinations

import pytest
from calibration.prior.simulated_wearers import Wearer, prior_of
from hypothesis import given, settings
from hypothesis import strategies as st

from app.calibration.prior.documents import OwnPrior
from app.calibration.prior.entry import person_entry
from app.calibration.prior.map_prior import PriorError, union_of_people
from app.calibration.prior.release import release

JOINT = "right_elbow"


@pytest.fixture(scope="module")
def many():
    return prior_of(range(1, 21))


def part(prior, numbers):
    return prior.model_copy(update={"people": {f"w{i}": prior.people[f"w{i}"] for i in numbers}})


def released(prior):
    """Return the release of a prior, and the prior that knows of it."""
    made = release([prior])
    return made, prior.with_released(made.people)


def test_one_person_more_is_no_second_release(many):
    first, prior = released(part(many, range(1, 9)))
    assert first.document.people == 8
    for count in range(9):
        grown = OwnPrior(
            layout=prior.layout,
            people={f"w{i}": many.people[f"w{i}"] for i in range(1, 9 + count)},
            released=prior.released,
        )
        if count < 8:
            with pytest.raises(PriorError, match="fewer than 8 are in no release yet: use the earlier release"):
                release([grown])
    second = release([grown])
    assert second.people.joints[JOINT] == tuple(f"w{i}" for i in range(9, 17))
    assert release([first.document, second.document]).document.people == 16


def test_a_release_that_is_added_hides_nobody(many):
    everywhere = release([part(many, range(1, 11))]).document
    with pytest.raises(PriorError, match="there is 1 person in all, and only sums"):
        release([part(many, [11]), everywhere])
    assert release([part(many, range(11, 19)), everywhere]).document.people == 18


def test_a_person_who_is_recorded_again_is_not_released_again(many):
    _, prior = released(part(many, range(1, 17)))
    again = prior.with_person("w1", person_entry([Wearer(77).recording()]))
    with pytest.raises(PriorError, match="16 people in all, of whom fewer than 8"):
        release([again])


def test_who_is_taken_out_leaves_no_trace_in_the_prior(many):
    _, prior = released(part(many, range(1, 10)))
    assert "w3" not in prior.without_person("w3").model_dump_json()


def test_people_of_two_own_priors_count_once_and_each_keeps_its_own(many):
    one, other = part(many, range(1, 7)), part(many, range(4, 11))
    made = release([one, other])
    assert made.document.people == 10
    assert one.with_released(made.people).released.joints[JOINT] == tuple(sorted(f"w{i}" for i in range(1, 7)))
    assert union_of_people([one.with_released(made.people), other]).released.joints[JOINT]


@given(order=st.permutations(range(1, 21)), steps=st.lists(st.integers(1, 12), min_size=1, max_size=6))
@settings(max_examples=40, deadline=None)
def test_releases_of_a_growing_prior_share_nobody(many, order, steps):
    prior, sets, count = OwnPrior(layout=many.layout), [], 0
    for step in steps:
        for i in order[count : count + step]:
            prior = prior.with_person(f"w{i}", many.people[f"w{i}"])
        count = min(count + step, len(order))
        try:
            made, prior = released(prior)
        except PriorError:
            continue
        sets.append(set(made.people.joints[JOINT]))
        assert made.document.people == len(sets[-1]) >= 8
    assert all(not one & other for one, other in combinations(sets, 2))
    assert bool(sets) == (count >= 8)
