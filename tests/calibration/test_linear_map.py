"""The document of a linear map holds the parts that it reads, and gives all of them back."""

import numpy as np
import pytest

from app.calibration.linear_map import KINDS, LinearMap, map_parts


@pytest.mark.parametrize("read", [[0], [0, 5, 6], [0, 6], [2, 5], range(KINDS)])
def test_parts_that_are_zero_are_left_out_and_come_back(read):
    weights = np.zeros((KINDS, 3))
    weights[list(read)] = np.arange(1.0, 4.0)
    linear = LinearMap(**map_parts(weights.tolist()), dead_zone=0.2, full=1.0)
    np.testing.assert_array_equal(linear.parts, weights)
    assert len(linear.rates) == max([0, *(kind for kind in read if kind < 5)]) + 1
    assert ("short" in linear.model_dump(), "long" in linear.model_dump()) == (5 in read, 6 in read)
    assert LinearMap.model_validate_json(linear.model_dump_json()) == linear


@pytest.mark.parametrize(
    ("people", "repetitions", "words"),
    [
        (0, 0, "standard"),
        (0, 3, "from own prompts"),
        (8, 0, "from other people"),
        (8, 3, "from other people and own movement"),
    ],
)
def test_the_counts_say_what_it_is_learnt_from(people, repetitions, words):
    linear = LinearMap(rates=((1.0,),), dead_zone=0.2, full=1.0, people=people, repetitions=repetitions)
    assert str(linear.source) == words
