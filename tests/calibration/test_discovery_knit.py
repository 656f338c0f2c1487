"""Gestures found on a real piezoresistive knit; their prediction is compared to later movements of the same people."""

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
from app.calibration.grades import CROSS_TALK_LIMIT
from app.signals.columns import read_columns
from app.signals.signals import read_signals
from app.signals.smoothing import smooth
from bench.learning.guided_map import FOLDER, JOINTS, LAYOUT, RISING

SEEN = 20.0  # s
LARGE = 0.2  # of the angle's range: smaller rises are no repetitions of the movement

pytestmark = pytest.mark.skipif(not FOLDER.exists(), reason="the recordings of the knit are not on this machine")


def rises(sample_rate):
    """All large rising phases of the measured angles."""
    found = []
    for joint, angle in read_columns(FOLDER / "joint_angles.csv", only=JOINTS).items():
        smoothed = smooth(angle, 3.0, sample_rate)
        rate = np.diff(smoothed, prepend=smoothed[0]) * sample_rate / np.ptp(angle)
        edges = np.flatnonzero(np.diff(np.concatenate(([0], rate > RISING, [0]))))
        for first, last in zip(edges[::2], edges[1::2], strict=True):
            if smoothed[last - 1] - smoothed[first] > LARGE * np.ptp(angle):
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
