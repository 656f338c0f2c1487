"""Who asks for reduced motion sees none: nothing is animated, and nothing glides from one state to the next.

`test_axe.py` looks for it on every page in its first state.
"""

import pytest
from browser.eyes.axe import look_as
from browser.eyes.places import PLACES, put_back
from browser.eyes.sweep import moving_parts

pytestmark = [pytest.mark.browser]


def test_nothing_moves_for_who_asks_for_that(page, clinic):
    look_as(page, ("1280x800", "light"))
    moves = {}
    for name, motion in (("calibrate, runs", "reduce"), ("drive, over", "reduce"), ("shirt", "no-preference")):
        page.emulate_media(reduced_motion=motion)
        PLACES[name](page, clinic)
        moves[name] = moving_parts(page)
        put_back(clinic)
    assert moves.pop("shirt") != []  # what moves is found
    assert moves == {"calibrate, runs": [], "drive, over": []}
