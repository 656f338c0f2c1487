"""The reports of screens, and the socket that may send them."""

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from app.api.live.screens import LINK_LIMIT, SILENCE_LIMIT, VIRTUAL_SILENCE_LIMIT, PageSign, Screen, Screens
from app.pipeline.safety_gate import SCREEN_SILENT, WEB_SILENT
from app.session.control_link import ScreenSign

MINE = Screen(1, "one-screen")
times = st.floats(0, 10)


def sign(t, link="link", *, visible=True, silence=0.0):
    return PageSign(t, visible, silence, link)


@given(st.lists(st.tuples(times, st.booleans(), times), max_size=20), times, st.floats(0, 1))
def test_the_last_word_counts_and_hidden_comes_before_slow(said, limit, later):
    screens, t = Screens(), 0.0
    for pause, visible, silence in said:
        t += pause
        assert screens.report(MINE, sign(t, visible=visible, silence=silence))
    found = screens.sign(MINE, t + later, limit)
    if not said:
        assert found == ScreenSign(None)
    else:
        _, visible, silence = said[-1]
        assert found.age == pytest.approx(later, abs=1e-9)
        assert found.view == ("hidden" if not visible else "slow" if silence > limit else "in view")
        assert screens.age(MINE, t + later) == (found.age if visible else None)


def test_screens_of_other_people_and_other_words_are_others():
    screens = Screens()
    screens.report(MINE, sign(1.0))
    assert screens.age(Screen(2, MINE.word), 1.0) is None
    assert screens.age(Screen(1, "another-word"), 1.0) is None
    assert screens.age(MINE, 1.25) == 0.25


@given(st.lists(st.tuples(st.floats(0, 3), st.sampled_from(["first", "second", "third"]), st.booleans()), max_size=40))
def test_one_link_at_a_time_speaks_for_a_screen(steps):
    """Each step: a time, a socket, and whether it sends a report or ends."""
    screens, t, speaker, spoke = Screens(), 0.0, None, 0.0
    for pause, link, says in steps:
        t += pause
        if says:
            is_taken = screens.report(MINE, sign(t, link))
            assert is_taken == (speaker in {None, link} or t - spoke >= LINK_LIMIT)
            if is_taken:
                speaker, spoke = link, t
        else:
            screens.remove(MINE, link)
            speaker = None if speaker == link else speaker
        assert screens.age(MINE, t) == (None if speaker is None else t - spoke)


def test_a_dead_link_gives_way_only_when_the_gate_has_long_stopped_the_chair():
    assert LINK_LIMIT > 2 * (SCREEN_SILENT + WEB_SILENT)
    assert SILENCE_LIMIT < VIRTUAL_SILENCE_LIMIT


def test_a_clock_that_is_read_just_before_the_word_makes_no_negative_age():
    screens = Screens()
    screens.report(MINE, sign(1.0))
    assert screens.age(MINE, math.nextafter(1.0, 0.0)) == 0.0
