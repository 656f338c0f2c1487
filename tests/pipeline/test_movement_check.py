"""What is no movement is not believed; what a person makes is (docs/decisions/0039)."""

import numpy as np
import pytest

from app.pipeline.decoder import Decoder
from app.pipeline.movement_check import HalfWaves, MovementCheck
from bench.artefacts import DISPLACEMENT, LASTS, Artefact, Subject, outcome, passed, sine, square
from building import make_parameters, make_signals

RATE = 100.0
PARAMETERS = make_parameters()


def looked_at(parameters, frames, rate=RATE):
    """Return, frame by frame, whether the check doubts and whether it disbelieves."""
    decoder, check = Decoder(parameters, rate), MovementCheck(parameters, rate)
    seen = []
    for frame in frames:
        decoder.step(frame, 1.0)
        check.look(frame, decoder.bad, decoder.estimated, decoder.rate, decoder.is_active, 1.0)
        seen.append((check.doubts, check.disbelieves))
    return np.array(seen)


def behind_filter(course, seconds):
    """Return a course (n,) as it leaves a low-pass filter of first order."""
    return passed(lambda *_: course, seconds)(np.arange(len(course)) / RATE, np.random.default_rng())


def shifted(parameters, course, joints=("right_elbow",), along=True):
    """Return frames of a rest in which these joints are moved by a course (n,), FS."""
    frames = make_signals(parameters, len(course), strokes=False).astype(np.float64)
    for joint in parameters.profile.joints:
        if joint.name in joints:
            direction = np.array(joint.direction) if along else np.abs(joint.direction)
            frames[:, list(joint.channels)] += np.outer(course, direction) * joint.span
    return frames.astype(np.float32)


def at(*seconds, size, n=1200):
    """Return a course that changes between 0 and `size` at these times."""
    t = np.arange(n) / RATE
    return size * (sum((t >= one).astype(int) for one in seconds) % 2)


def stroke(t, begin, rise, size):
    """Return a smooth stroke and its slower way back."""
    up, back = np.clip((t - begin) / rise, 0, 1), np.clip((t - begin - rise) / (1.4 * rise), 0, 1)
    return size * sum(sign * x**3 * (10 - 15 * x + 6 * x * x) for sign, x in ((1, up), (-1, back)))


def test_strokes_are_believed_also_quick_ones_one_after_another():
    t = np.arange(1200) / RATE
    strokes = [(1.0, 0.3, 0.8), (1.9, 0.35, 0.9), (2.8, 0.28, 0.7), (4.2, 0.3, 0.85), (6.0, 0.6, 1.0), (9.0, 0.25, 1.0)]
    course = sum(stroke(t, *one) for one in strokes)
    assert not looked_at(PARAMETERS, shifted(PARAMETERS, course)).any()
    assert not looked_at(PARAMETERS, make_signals(PARAMETERS, 3000)).any()


def test_a_first_small_step_is_doubted_and_a_second_one_is_not_believed():
    once = looked_at(PARAMETERS, shifted(PARAMETERS, at(3.0, size=0.07)))
    assert not once[:, 1].any()
    assert np.flatnonzero(once[:, 0])[0] / RATE == pytest.approx(3.08, abs=0.03)
    assert once[:, 0].sum() / RATE == pytest.approx(2.1, abs=0.15)
    twice = looked_at(PARAMETERS, shifted(PARAMETERS, at(3.0, 6.0, size=0.07)))
    assert np.flatnonzero(twice[:, 1])[0] / RATE == pytest.approx(6.08, abs=0.03)
    apart = looked_at(PARAMETERS, shifted(PARAMETERS, at(3.0, 9.0, size=0.07)))
    assert not apart[:, 1].any()


def test_a_large_step_is_not_believed_the_first_time():
    seen = looked_at(PARAMETERS, shifted(PARAMETERS, at(3.0, size=0.2)))
    assert np.flatnonzero(seen[:, 1])[0] / RATE == pytest.approx(3.08, abs=0.03)


@pytest.mark.parametrize(("seconds", "until"), [(0.003, 3.2), (0.01, 4.3), (0.02, 5.6)])
def test_steps_behind_a_filter_are_steps_too(seconds, until):
    seen = looked_at(PARAMETERS, shifted(PARAMETERS, behind_filter(at(3.0, 4.1, 5.3, size=0.2), seconds)))
    assert np.flatnonzero(seen[:, 1])[0] / RATE < until


def test_one_jerk_is_doubted_and_believed():
    seen = looked_at(PARAMETERS, shifted(PARAMETERS, behind_filter(at(3.0, size=0.2), 0.02)))
    assert seen[:, 0].any()
    assert not seen[:, 1].any()


def test_steps_behind_a_slow_filter_are_found_by_their_equal_heights():
    course = behind_filter(at(3.0, 4.7, 5.5, 7.6, 8.3, 9.9, size=0.2), 0.05)
    seen = looked_at(PARAMETERS, shifted(PARAMETERS, course))[:, 1]
    assert seen.any()
    assert np.flatnonzero(seen)[0] / RATE < 9.0


def test_what_the_calibration_saw_is_no_step():
    both = {"step": 0.3, "filtered_step": 0.3}
    joints = tuple(joint.model_copy(update=both) for joint in PARAMETERS.profile.joints)
    profile = PARAMETERS.profile.model_copy(update={"joints": joints})
    used_to_it = PARAMETERS.model_copy(update={"profile": profile})
    assert not looked_at(used_to_it, shifted(PARAMETERS, at(3.0, 5.0, 7.0, size=0.25))).any()


def test_spikes_of_one_frame_count_as_steps_do():
    course = np.zeros(1000)
    course[[400, 600]] = 0.2
    seen = looked_at(PARAMETERS, shifted(PARAMETERS, course))
    assert np.flatnonzero(seen[:, 1])[0] / RATE == pytest.approx(6.1, abs=0.05)


def test_the_step_of_a_channel_that_breaks_or_comes_back_is_none():
    frames = make_signals(PARAMETERS, 1000, strokes=False)
    channel = PARAMETERS.profile.joints[0].channels[0]
    frames[300:600, channel] = np.nan
    frames[700:720, channel] = np.inf
    assert not looked_at(PARAMETERS, frames).any()


def test_a_bad_channel_of_one_joint_hides_no_step_of_another():
    frames = shifted(PARAMETERS, at(3.0, size=0.2))
    frames[:, PARAMETERS.profile.joints[2].channels[0]] = np.nan
    assert looked_at(PARAMETERS, frames)[:, 1].any()


@pytest.mark.parametrize("along", [True, False])
def test_all_joints_alike_are_no_movement_and_two_are_one(along):
    parameters = rested().parameters
    profile = parameters.profile
    t = np.arange(400) / RATE
    names = [joint.name for joint in profile.joints]
    both = looked_at(parameters, shifted(parameters, stroke(t, 1.0, 0.6, 0.8), names[:2]))
    assert not both.any()
    size = (np.array(profile.high) - np.array(profile.low)) / 2.0
    if along:
        for joint in profile.joints:
            size[list(joint.channels)] *= np.sign(joint.direction)
    sway = np.outer(stroke(t, 1.0, 0.6, 0.8), size)
    frames = make_signals(parameters, 400, strokes=False) + sway.astype(np.float32)
    seen = looked_at(parameters, frames)[:, 1]
    assert seen.any()
    assert np.flatnonzero(seen)[0] / RATE < 1.3


@pytest.mark.parametrize(
    ("feature", "size", "frequency"),
    [({}, 0.15, f) for f in (0.3, 0.5, 1.0, 2.0, 3.0, 5.0)] + [(DISPLACEMENT, 0.3, f) for f in (0.3, 0.5, 1.0)],
)
def test_an_even_oscillation_is_not_believed_after_five_half_waves(feature, size, frequency):
    parameters = make_parameters(dead_zone=0.15, full=2.5)
    gestures = tuple(gesture.model_copy(update=feature) for gesture in parameters.gestures)
    parameters = parameters.model_copy(update={"gestures": gestures})
    t = np.arange(2000) / RATE
    seen = looked_at(parameters, shifted(parameters, size * np.sin(2 * np.pi * frequency * t)))[:, 1]
    assert seen.any()
    assert np.flatnonzero(seen)[0] / RATE < 3.0 / frequency + 0.2


def test_an_oscillation_that_ended_is_believed_again_after_the_doubt():
    course = behind_filter(at(2.0, 3.0, 4.0, 5.0, 6.0, 7.0, size=0.2), 0.05)
    doubts = looked_at(PARAMETERS, shifted(PARAMETERS, course))[:, 0]
    assert doubts[750]
    assert not doubts[1000:].any()


def test_half_waves_that_differ_are_not_counted():
    waves = HalfWaves(0.15, 0.01, 0.01)
    counts = []
    for size, half in ((1.0, 0.5), (0.8, 0.7), (1.0, 0.5), (0.7, 0.6), (1.1, 0.45), (0.9, 0.65)):
        for i in range(round(half * 100)):
            waves.step((-1.0) ** len(counts) * size * np.sin(np.pi * i / (half * 100)))
        counts.append(waves.count)
    assert max(counts) <= 1


def test_a_pause_without_frames_forgets_and_losses_do_not():
    frames = shifted(PARAMETERS, at(3.0, size=0.2))
    decoder, check = Decoder(PARAMETERS, RATE), MovementCheck(PARAMETERS, RATE)
    for i, frame in enumerate(frames):
        periods = 50.0 if i == 300 else 1.0
        decoder.step(frame, periods)
        check.look(frame, decoder.bad, decoder.estimated, decoder.rate, decoder.is_active, periods)
        assert not check.disbelieves
    kept = [frame for i, frame in enumerate(frames) if i % 20]
    assert looked_at(PARAMETERS, kept)[:, 1].any()


def rested(rate=RATE):
    """Return a subject of the tests' made-up profile, with a range that fits its spans."""
    parameters = make_parameters(sample_rate=rate, dead_zone=0.15, full=2.5)
    profile = parameters.profile
    low = [0.0] * len(profile.low)
    for joint in profile.joints:
        for channel, mean, weight in zip(joint.channels, joint.mean, joint.direction, strict=True):
            low[channel] = mean - max(0.1, abs(weight) * joint.span)
    high = [0.0] * len(low)
    for joint in profile.joints:
        for channel, mean in zip(joint.channels, joint.mean, strict=True):
            high[channel] = 2 * mean - low[channel]
    profile = profile.model_copy(update={"low": tuple(low), "high": tuple(high)})
    parameters = parameters.model_copy(update={"profile": profile})
    return Subject("made up", parameters, rate, make_signals(parameters, round((LASTS + 4.0) * rate), strokes=False))


@pytest.mark.parametrize("armed_before", [True, False])
@pytest.mark.parametrize(
    "artefact",
    [
        Artefact("connector", square(0.3, 0.5)),
        Artefact("connector behind a filter", passed(square(0.3, 0.5), 0.01)),
        Artefact("connector behind a slower filter", passed(square(0.15, 1.0), 0.02)),
        Artefact("small connector", square(0.08, 1.0)),
        Artefact("sway", sine(0.2, 1.0), all_joints=True),
        Artefact("slow sway", sine(0.2, 0.5), all_joints=True),
        Artefact("hum", sine(0.3, 100.4), all_joints=True),
    ],
    ids=lambda one: one.words,
)
def test_an_artefact_hardly_moves_the_chair_and_arms_none(artefact, armed_before):
    found = outcome(rested(), artefact, armed_before=armed_before)
    assert found.speed <= 0.1
    assert found.way <= 0.5
    assert armed_before or not found.armed or found.way == 0.0
