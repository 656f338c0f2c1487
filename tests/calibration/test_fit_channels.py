"""Unusable channels are named with the reason and left out of the map."""

import numpy as np
import pytest
from calibration.simulated_person import SimulatedPerson, calibrate, layout_of
from hypothesis import example, given, settings
from hypothesis import strategies as st

from app.calibration.clean_recording import CleanRecording
from app.calibration.fit.profile_fit import fit_profile, joints_without_map

LAYOUT = layout_of()


@pytest.fixture
def person():
    return SimulatedPerson(LAYOUT)


@settings(max_examples=15, deadline=None)
@example(bad={0, 1, 2, 3, 4}, how="some")
@given(bad=st.sets(st.integers(0, 19), max_size=6), how=st.sampled_from(["all", "some", "dead"]))
def test_broken_channels_are_named_and_kept_out(bad, how):
    person = SimulatedPerson(LAYOUT, seed=5)
    free = person.free()
    columns = sorted(bad)
    if how == "dead":
        free[:, columns] = 7.5
    else:
        free[slice(None) if how == "all" else slice(300, 330), columns] = np.nan
    profile = calibrate(person, free=free)
    without_good = {name: set(channels) for name, channels in LAYOUT.channels_of_joint.items() if set(channels) <= bad}
    if how == "some":  # few samples are missing: a joint that has no better channels keeps these
        bad = bad.difference(*without_good.values())
        without_good = {}
    assert sorted(profile.left_out) == sorted(LAYOUT.channels[i].name for i in bad)
    for joint in profile.joints:
        assert not set(joint.channels) & bad
        assert np.isfinite(joint.direction).all()
    assert set(joints_without_map(profile)) == set(without_good)


def test_lost_frames_do_no_harm(person):
    free = person.free()
    whole = calibrate(person, free=free)
    free[400:410] = np.nan
    holed = calibrate(person, free=free)
    assert holed.left_out == {}
    for one, other in zip(whole.joints, holed.joints, strict=True):
        assert other.span == pytest.approx(one.span, rel=0.02)


def test_channels_marked_as_unused_are_left_out(person):
    profile = calibrate(person, unused={"left_elbow_2"})
    assert profile.left_out == {"left_elbow_2": "marked as unused"}
    assert "Sensors left out: 1 of 5" in profile.joints[1].reason


def test_near_railed_channels_stay_only_when_the_joint_has_no_better_one(person):
    free = person.free()
    reach = np.abs(free).max(axis=0)
    free *= np.where(np.arange(20) < 5, 80.0, 20.0) / reach
    free[:, 5] *= 4
    profile = fit_profile(CleanRecording.of(LAYOUT, 100.0, free=free, full_scale=100.0))
    assert list(profile.left_out) == ["left_elbow_0"]
    assert profile.joints[0].channels == (0, 1, 2, 3, 4)
