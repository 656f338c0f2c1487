"""What a screen says of itself, and that the chair hears of it at once."""

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from app.api.screens import Screen, Screens

MINE = Screen(1, "one-screen")


@given(st.lists(st.tuples(st.floats(0, 10), st.booleans()), max_size=20), st.floats(0, 1))
def test_the_age_is_that_of_the_last_word_and_none_after_hidden(said, later):
    screens, t, link = Screens(), 0.0, object()
    for pause, visible in said:
        t += pause
        screens.seen(MINE, visible, t, link)
    age = screens.age(MINE, t + later)
    if not said or not said[-1][1]:
        assert age is None
    else:
        assert age == pytest.approx(later, abs=1e-9)


def test_screens_of_other_people_and_other_words_are_others():
    screens = Screens()
    screens.seen(MINE, True, 1.0, "link")
    assert screens.age(Screen(2, MINE.word), 1.0) is None
    assert screens.age(Screen(1, "another-word"), 1.0) is None
    assert screens.age(MINE, 1.25) == 0.25


def test_only_the_end_of_the_newest_link_counts():
    screens = Screens()
    screens.gone(MINE, "never there")
    screens.seen(MINE, True, 1.0, "old link")
    screens.seen(MINE, True, 2.0, "new link")
    screens.gone(MINE, "old link")
    assert screens.age(MINE, 2.0) == 0.0
    screens.gone(MINE, "new link")
    assert screens.age(MINE, 2.0) is None


def test_a_clock_that_is_read_just_before_the_word_makes_no_negative_age():
    screens = Screens()
    screens.seen(MINE, True, 1.0, "link")
    assert screens.age(MINE, math.nextafter(1.0, 0.0)) == 0.0
