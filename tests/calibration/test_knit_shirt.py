"""The calibration on a real piezoresistive knit: 20 channels on four real people, with the measured joint angle."""

import numpy as np
import pytest

from app.calibration.clean_recording import CleanRecording
from app.calibration.fit.profile_fit import fit_profile
from app.calibration.fit.repetitions import Prompt, repetitions_of_prompts
from app.signals.columns import read_columns
from app.signals.signals import read_signals
from app.signals.smoothing import smooth
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
    """The measured angles' rates in span/s, smoothed like the signals so that both lag by the same."""
    rates = {}
    for joint, angle in read_columns(FOLDER / "joint_angles.csv", only=JOINTS).items():
        smoothed = smooth(angle, CUTOFF, signals.sample_rate)
        rates[joint] = np.diff(smoothed, prepend=smoothed[0]) * signals.sample_rate / np.ptp(angle)
    return rates


def prompts(signals, angle_rates, lead=0.0, longer=0.0):
    """Rising phases of the measured angle within the calibration, badly cut by `lead` and `longer` (s)."""
    found = []
    for joint in JOINTS:
        edges = np.flatnonzero(np.diff(np.concatenate(([0], angle_rates[joint] > RISING, [0]))))
        for first, last in zip(edges[::2], edges[1::2], strict=True):
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
