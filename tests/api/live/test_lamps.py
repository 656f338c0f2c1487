"""The lamp of each channel."""

import numpy as np

from app.api.live.live_picture import lamps
from building import make_layout


def test_a_channel_that_its_neighbours_stand_in_for_has_a_lamp_of_its_own():
    layout = make_layout(8)
    frames = np.random.default_rng(1).normal(size=(100, 8))
    frames[:, 3] = np.nan
    assert lamps(layout, frames, 100.0, ["c5"])[3] == "nan"
    shown = lamps(layout, frames, 100.0, ["c5"], estimated=1 << 3 | 1 << 5)
    assert [shown[3], shown[5]] == ["estimated", "unused"]
    assert "estimated" not in shown[:3]
