"""The front and the outer side of a limb, as its ring of sensors has them."""

import pytest

from app.calibration.prior.landmarks import Landmarks, landmarks
from app.hardware.shirt.standard import standard_layout
from app.layout import Channel, Joint, ShirtLayout


def cuff(sides, places) -> ShirtLayout:
    channels = tuple(
        Channel(name=f"c{i}", joint="elbow", ring="cuff", side=side, position=None if x is None else (x, 0.5))
        for i, (side, x) in enumerate(zip(sides, places, strict=True))
    )
    return ShirtLayout(name="cuff", channels=channels, joints=(Joint(name="elbow", label="Elbow"),))


def test_both_elbows_of_the_standard_shirt_have_their_front_a_quarter_before_their_outer_side() -> None:
    for ring in ("right_elbow", "left_elbow"):
        front, outside = landmarks(standard_layout(), ring)
        assert front == 1.5  # between the four sensors at the front, which come first
        assert outside == pytest.approx(3.5, abs=0.2)


@pytest.mark.parametrize("turn", range(6))
def test_a_ring_that_begins_elsewhere_has_them_elsewhere(turn: int) -> None:
    sides = ["front", "front", "front", "back", "back", "back"]
    x = [0.3, 0.2, 0.1, 0.1, 0.2, 0.3]
    found = landmarks(cuff(sides[turn:] + sides[:turn], x[turn:] + x[:turn]), "cuff")
    assert found == Landmarks(front=(1 - turn) % 6, outside=(2.5 - turn) % 6)


def test_what_the_layout_does_not_say_is_not_known() -> None:
    assert landmarks(cuff([None] * 4, [None] * 4), "cuff") == Landmarks(None, None)
    assert landmarks(cuff(["front", None, "back", "back"], [0.1, 0.1, 0.1, 0.1]), "cuff") == Landmarks(None, None)
    assert landmarks(cuff(["front", "back", "front", "back"], [0.1, 0.3, 0.1, 0.3]), "cuff") == Landmarks(None, None)
