"""Colours at vertices: what the renderer shows of them."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scene.shown_colours import shown

from app.scene.meshes.bodies import box, rectangle
from app.scene.meshes.paint import joined, light_of, painted
from app.world.scenery import Lights

GREY = st.integers(min_value=0, max_value=220)
HUE = st.integers(min_value=-15, max_value=15)


@given(GREY, HUE, HUE)
def test_a_colour_is_shown_as_it_was_chosen(grey, red, blue):
    colour = tuple(min(max(grey + more, 0), 220) for more in (red, 0, blue))
    light = light_of(colour)
    if light.min() > 0 and light.max() < 1:
        assert shown(light) == pytest.approx(colour, abs=0.6)


def test_white_is_shown_as_white_as_can_be():
    assert (light_of((255, 255, 255)) == 1).all()
    assert shown(np.ones(3)).min() > 220


def test_the_default_lights_show_the_colour_and_dimmer_ones_a_darker_one():
    colour = (150, 155, 160)
    floor = rectangle(0, 0, 1, 1, 0)
    assert shown(painted(floor, colour, Lights()).light) == pytest.approx(np.tile(colour, (4, 1)), abs=0.6)
    dim = painted(floor, colour, Lights(sun=0.1, sky=0.3)).light
    assert (shown(dim) < 120).all()
    assert (painted(floor, colour, Lights(), 0.5).light < painted(floor, colour, Lights()).light).all()


def test_two_walls_of_a_corner_have_different_light():
    sides = painted(box((1, 1, 1)), (200, 200, 200), Lights()).light.mean(axis=1).reshape(6, 4)
    assert (np.ptp(sides, axis=1) < 1e-12).all()
    faces = dict(zip(("top", "bottom", "ahead", "behind", "left", "right"), sides[:, 0], strict=True))
    assert faces["right"] > 1.05 * faces["behind"] > 1.05 * faces["ahead"]


def test_parts_are_joined_in_order():
    one, other = (painted(box((1, 1, 1)), (grey,) * 3, Lights()) for grey in (50, 150))
    both = joined([one, other])
    assert (both.light[: len(one.light)] == one.light).all()
    assert len(both.light) == len(both.mesh.vertices)
    assert len(joined([]).light) == 0
