import numpy as np
import pytest

from app.cues import Cue
from app.hardware.body.person import CuedBody
from app.hardware.shirt.simulated_fabric import FULL_SCALE, PEAKY, STEPS, Fabric, FabricProperties
from app.hardware.shirt.standard import standard_layout

DT = 0.01  # s
FREE = Cue(start=0.0, end=10.0, kind="free")
PURE = {"noise": 0.0, "drift_per_minute": 0.0}


def quiet(**changes):
    """Return properties without noise and drift, and with the given changes."""
    return FabricProperties(**{**PURE, **changes})


@pytest.fixture(scope="module")
def layout():
    return standard_layout()


def feel(fabric, posture_of_time, seconds, joint="right_elbow"):
    """Return the channels (n, 52) while one joint follows a function of time."""
    posture = np.zeros(len(fabric.joints))
    column = fabric.joints.index(joint)
    out = []
    for i in range(round(seconds / DT)):
        posture[column] = posture_of_time(i * DT)
        out.append(fabric.step(posture, DT))
    return np.array(out, dtype=np.float64)


def strongest(fabric, joint="right_elbow"):
    """Return the channel with the largest response to a joint, and its linear response (V) to a full movement."""
    column = fabric.joints.index(joint)
    channel = int(np.abs(fabric.gains[:, column]).argmax())
    return channel, float(fabric.gains[channel, column]) * 0.45


def explained(values, channels):
    centred = values[:, channels] - values[:, channels].mean(axis=0)
    spread = np.linalg.svd(centred, compute_uv=False) ** 2
    return spread[0] / spread.sum()


def test_free_movement_has_the_papers_explained_variance(layout):
    shoulders, others = [], []
    for seed in range(6):
        fabric = Fabric(layout, seed)
        body = CuedBody(fabric.joints, seed + 100)
        values = np.array([fabric.step(body.follow(DT, FREE), DT) for _ in range(1000)], dtype=np.float64)
        for joint, channels in layout.channels_of_joint.items():
            (shoulders if "shoulder" in joint else others).append(explained(values, channels))
    assert 0.80 <= np.median(shoulders) <= 0.90
    assert min(shoulders) >= 0.70
    assert max(shoulders) < 0.97
    assert min(others) > 0.95


def test_the_same_seed_is_the_same_shirt_and_another_seed_another(layout):
    def wave(seed):
        return feel(Fabric(layout, seed), np.sin, 0.5)

    np.testing.assert_array_equal(wave(3), wave(3))
    assert np.abs(wave(3) - wave(4)).max() > 0.05


def test_values_are_new_each_time_and_steps_of_the_converter(layout):
    fabric = Fabric(layout, 1)
    posture = np.zeros(len(fabric.joints))
    first = fabric.step(posture, DT)
    kept = first.copy()
    second = fabric.step(posture, DT)
    np.testing.assert_array_equal(first, kept)
    assert first.dtype == np.float32
    assert first.shape == (52,)
    steps = second.astype(np.float64) * STEPS / FULL_SCALE
    np.testing.assert_allclose(steps, np.rint(steps), atol=1e-3)
    assert not np.array_equal(first, second)


def test_noise_at_rest_is_what_was_said(layout):
    fabric = Fabric(layout, 2, properties=FabricProperties(drift_per_minute=0.0))
    rest = feel(fabric, lambda _t: 0.0, 10.0)
    strength = np.abs(fabric.gains).max(axis=1) * 0.45
    assert np.median(rest.std(axis=0) / strength) == pytest.approx(0.006, rel=0.1)


def test_drift_is_about_three_percent_a_minute(layout):
    fabric = Fabric(layout, 2, properties=FabricProperties(noise=0.0))
    rest = feel(fabric, lambda _t: 0.0, 60.0)
    share = np.abs(rest[-1] - rest[0]) / (np.abs(fabric.gains).max(axis=1) * 0.45)
    assert 0.01 < np.median(share) < 0.06
    assert np.percentile(share, 90) < 0.3


def test_a_held_posture_creeps_on_and_creeps_back(layout):
    fabric = Fabric(layout, 5, properties=quiet(loop=0.0))
    channel, _ = strongest(fabric)
    values = feel(fabric, lambda t: 1.0 if 1.0 <= t < 201.0 else 0.0, 205.0)[:, channel]
    at_once = values[101] - values[50]
    crept = values[20050] - values[101]
    assert 0.2 < crept / at_once < 0.55  # 30 % slowly and 10 % fast, each up to 40 % more or less
    assert np.sign(values[20150] - values[50]) == np.sign(at_once)


def test_up_and_down_are_a_loop_of_a_tenth_of_the_span_however_fast(layout):
    properties = quiet(creep_fast=0.0, creep_slow=0.0, quadratic=0.0)
    heights = []
    for seconds in (1.0, 4.0):
        fabric = Fabric(layout, 6, properties=properties)
        channel, span = strongest(fabric)
        values = feel(fabric, lambda t, s=seconds: 0.5 - 0.5 * np.cos(np.pi * t / s), 4 * seconds)[:, channel]
        quarter, turn = round(0.5 * seconds / DT), round(seconds / DT)
        heights.append(abs(values[2 * turn + quarter] - values[3 * turn + quarter]) / abs(span))
    assert heights == pytest.approx([heights[0]] * 2, abs=0.01)
    assert 0.06 <= heights[0] <= 0.14


def test_the_peak_answers_to_speed_and_only_when_switched_on(layout):
    def still_and_moving(properties):
        fabric = Fabric(layout, 7, properties=properties)
        channel, span = strongest(fabric)
        values = feel(fabric, lambda t: min(1.0, 2 * t), 1.0)[:, channel]
        return (values[49] - values[51]) / span

    peaky = FabricProperties(**{**PURE, "peak": PEAKY.peak})
    assert still_and_moving(peaky) > still_and_moving(quiet()) + 0.03


def test_dead_channels_never_change_and_unknown_ones_are_refused(layout):
    dead = (layout.channel_names[0], layout.channel_names[20])
    values = feel(Fabric(layout, 8, dead), np.sin, 1.0)
    still = np.ptp(values, axis=0) == 0
    assert list(np.flatnonzero(still)) == [0, 20]
    with pytest.raises(ValueError, match="no channel 'sleeve' that could be dead"):
        Fabric(layout, 8, ("sleeve",))


def test_put_on_again_gains_offsets_and_directions_are_others(layout):
    fabric = Fabric(layout, 9, properties=quiet())
    before_gains = fabric.gains
    before_rest = feel(fabric, lambda _t: 0.0, 0.1)[-1]
    fabric.don_again()
    moved = np.abs(feel(fabric, lambda _t: 0.0, 0.1)[-1] - before_rest)
    assert 0.02 < moved.max() <= 0.6 * 0.45 + 0.01
    for joint, channels in layout.channels_of_joint.items():
        column = fabric.joints.index(joint)
        one, other = before_gains[channels, column], fabric.gains[channels, column]
        angle = np.degrees(np.arccos(one @ other / np.linalg.norm(one) / np.linalg.norm(other)))
        assert 8.0 - 1e-6 <= angle <= 17.0 + 1e-6
        assert 0.8 <= np.linalg.norm(other) / np.linalg.norm(one) <= 1.2


def test_nothing_reaches_the_ends_of_the_converter(layout):
    for seed in range(4):
        fabric = Fabric(layout, seed)
        body = CuedBody(fabric.joints, seed)
        values = np.array([fabric.step(body.follow(DT, FREE), DT) for _ in range(1000)])
        assert values.min() > 0.1 * FULL_SCALE
        assert values.max() < 0.9 * FULL_SCALE


def test_the_papers_shirt_has_its_channels_apart_and_on_the_right_side(layout):
    assert len(layout.channels) == 52
    assert {joint: len(channels) for joint, channels in layout.channels_of_joint.items()} == {
        f"{side}_{part}": count
        for part, count in (("shoulder", 12), ("elbow", 8), ("wrist", 6))
        for side in ("right", "left")
    }
    for view in ("front", "back"):
        shown = [channel for channel in layout.channels if channel.side == view]
        assert len(shown) == 26
        places = np.array([channel.position for channel in shown]) * (300, 420)
        distances = np.linalg.norm(places[:, np.newaxis] - places, axis=2) + 1e9 * np.eye(len(places))
        assert distances.min() >= 14
        for channel in shown:
            on_viewers_left = channel.position[0] < 0.5
            assert on_viewers_left == (channel.joint.startswith("right") == (view == "front"))
