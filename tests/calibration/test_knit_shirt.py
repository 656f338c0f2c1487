"""The calibration and the gestures on a real knit: 20 channels on four real people, with measured angles."""

import numpy as np
import pytest

from app.calibration.clean_recording import CleanRecording
from app.calibration.cued_runs import run_of_prompts
from app.calibration.fit.profile_fit import fit_profile
from app.calibration.fit.repetitions import Prompt, repetitions_of_prompts
from app.calibration.gestures.ability import abilities
from app.calibration.gestures.cross_check import hit_level
from app.calibration.gestures.discovery import discover
from app.calibration.gestures.evidence import gather_evidence
from app.calibration.map_grades import CROSS_TALK_LIMIT
from app.signals.columns import read_columns
from app.signals.low_pass import smooth
from app.signals.signals import read_signals
from bench.learning.guided_map import FOLDER, JOINTS, LAYOUT, RISING

RISING_SHARE = {"right_elbow": 0.85, "left_elbow": 0.97, "right_shoulder": 0.86, "left_shoulder": 0.96}
REST_SHARE = 0.002
CUTOFF, DEAD_ZONE = 3.0, 0.2  # Hz, FS/s
CALIBRATION = 10.0  # s
STILL = 0.03  # span/s of the measured angle

pytestmark = pytest.mark.skipif(not FOLDER.exists(), reason="the recordings of the knit are not on this machine")


@pytest.fixture(scope="module")
def signals():
    return read_signals(FOLDER / "signals.csv", LAYOUT)


@pytest.fixture(scope="module")
def angle_rates(signals):
    return {joint: rate for joint, rate, _ in measured_angles(signals.sample_rate)}


def measured_angles(sample_rate):
    """Yield each joint with its rate (n,) in span/s and its place (n,) in spans, smoothed as the signals are."""
    for joint, angle in read_columns(FOLDER / "joint_angles.csv", only=JOINTS).items():
        place = smooth(angle, CUTOFF, sample_rate) / np.ptp(angle)
        yield joint, np.diff(place, prepend=place[0]) * sample_rate, place


def rising_phases(rate):
    """Return the first row of each phase in which an angle rises, and the row after its last."""
    edges = np.flatnonzero(np.diff(np.concatenate(([0], rate > RISING, [0]))))
    return zip(edges[::2], edges[1::2], strict=True)


def prompts(signals, angle_rates, lead=0.0, longer=0.0):
    """Rising phases of the measured angle within the calibration, badly cut by `lead` and `longer` (s)."""
    found = []
    for joint in JOINTS:
        for first, last in rising_phases(angle_rates[joint]):
            start, end = first / signals.sample_rate, last / signals.sample_rate
            if end - start > 0.1 and start < CALIBRATION - 0.5:
                found.append(Prompt(max(0.0, start - lead), min(CALIBRATION, end - lead + longer), joint))
    return found


def calibrated(signals, rows):
    return fit_profile(
        CleanRecording.of(
            LAYOUT,
            signals.sample_rate,
            free=signals.values[signals.between(0.0, CALIBRATION)],
            repetitions=repetitions_of_prompts(signals.t, signals.values, rows, signals.sample_rate),
        )
    )


def test_time_written_with_few_digits_is_100_hz(signals):
    assert signals.sample_rate == 100.0
    assert np.diff(signals.t) == pytest.approx(0.01, abs=1e-9)


@pytest.mark.parametrize(("lead", "longer"), [(0.0, 0.0), (0.3, 0.0), (-0.2, 0.0), (0.0, 0.5), (0.4, 0.8)])
def test_activation_falls_into_the_rising_phase(signals, angle_rates, lead, longer):
    profile = calibrated(signals, prompts(signals, angle_rates, lead, longer))
    assert profile.left_out == {}
    for joint in profile.joints:
        assert joint.evr >= 0.98
        assert joint.prompted
        place = (signals.values[:, joint.channels] - np.array(joint.mean)) @ np.array(joint.direction)
        smoothed = smooth(place / joint.span, CUTOFF, signals.sample_rate)
        drive = np.maximum(0.0, np.diff(smoothed, prepend=smoothed[0]) * signals.sample_rate - DEAD_ZONE)
        rate = angle_rates[joint.name]
        assert drive[rate > RISING].sum() / drive.sum() >= RISING_SHARE[joint.name]
        assert drive[np.abs(rate) < STILL].sum() / drive.sum() <= REST_SHARE


def test_span_is_that_of_the_first_ten_seconds(signals, angle_rates):
    profile = calibrated(signals, prompts(signals, angle_rates))
    for joint in profile.joints:
        place = (signals.values[:1000, joint.channels] - np.array(joint.mean)) @ np.array(joint.direction)
        assert joint.span == pytest.approx(np.subtract(*np.percentile(place, (99, 1))))
        assert joint.pca.dead_zone >= 0.15
        assert joint.pca.full > joint.pca.dead_zone


SEEN = 20.0  # s
LARGE = 0.2  # of the angle's range: smaller rises are no repetitions of the movement


def rises(sample_rate):
    """All large rising phases of the measured angles."""
    found = []
    for joint, rate, place in measured_angles(sample_rate):
        for first, last in rising_phases(rate):
            if place[last - 1] - place[first] > LARGE:
                found.append(Prompt(first / sample_rate, last / sample_rate, joint))
    return found


def test_the_forecast_holds_for_what_is_done_later():
    signals = read_signals(FOLDER / "signals.csv", LAYOUT)
    rows = rises(signals.sample_rate)
    before = [prompt for prompt in rows if prompt.end < SEEN]
    after = [prompt for prompt in rows if prompt.start > SEEN]
    free = signals.between(0.0, SEEN)
    profile = fit_profile(
        CleanRecording.of(
            LAYOUT,
            signals.sample_rate,
            free=signals.values[free],
            repetitions=repetitions_of_prompts(signals.t, signals.values, before, signals.sample_rate),
        )
    )
    found = discover(profile, [run_of_prompts(signals.t, signals.values, before, free)])
    later = gather_evidence(profile, [run_of_prompts(signals.t, signals.values, after, signals.between(SEEN, None))])
    made = {ability.name: ability for ability in abilities(profile, later)}
    assert {(one.joint, one.direction) for one in found.gestures} == {
        (joint, way) for joint in JOINTS for way in (1, -1)
    }
    predicted, counted, movements = 0.0, 0, 0
    for one in found.gestures:
        assert one.prediction.false_per_minute is None  # no rest was recorded, so nothing is claimed
        if one.direction == 1:
            peaks = made[one.name].peaks
            predicted += one.prediction.hit_rate * len(peaks)
            counted += sum(peak >= hit_level(one.dead_zone, one.full) for peak in peaks)
            movements += len(peaks)
    assert movements > 40
    assert predicted / movements == pytest.approx(counted / movements, abs=0.15)
    # These are four people who move at once: two joints answer to each other, and are not both bound.
    bound = [JOINTS.index(name) for binding in found.suggestion.bindings[:-1] for name in binding.gestures]
    together = np.array(profile.cross_talk)[np.ix_(bound, bound)]
    assert len(bound) == 3
    assert (together[~np.eye(3, dtype=bool)] <= CROSS_TALK_LIMIT).all()
