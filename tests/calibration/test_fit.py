import numpy as np
import pytest
from calibration.simulated_person import JOINTS, SimulatedPerson, calibrate, layout_of
from hypothesis import given, settings
from hypothesis import strategies as st

from app.calibration.clean_recording import CleanRecording
from app.calibration.fit.profile_fit import fit_profile
from app.calibration.fit.repetitions import Repetition
from app.calibration.profile import CalibrationProfile
from app.calibration.vocabulary import standard_parameters
from app.layout import Channel, Joint, ShirtLayout

LAYOUT = layout_of()
SEEDS = st.integers(0, 2**32 - 1)


def scores(joint, values):
    return (values[:, joint.channels] - np.array(joint.mean)) @ np.array(joint.pca.rates[0])


def assert_rises_with(profile, person):
    angles = np.linspace(0, 1, 11)[:, np.newaxis] * np.ones(4)
    for joint in profile.joints:
        assert (np.diff(scores(joint, angles @ person.gains)) > 0).all()


@pytest.fixture
def person():
    return SimulatedPerson(LAYOUT)


def test_a_person_who_follows_the_cues_gets_a_good_profile(person):
    profile = calibrate(person)
    assert [joint.name for joint in profile.joints] == list(JOINTS)
    assert profile.left_out == {}
    for joint in profile.joints:
        assert joint.grade == "good", joint.reason
        assert joint.prompted
        assert joint.evr > 0.8
        assert joint.repeatability < 0.2
        assert joint.angle_deg < 30
        assert joint.pca.dead_zone >= max(0.15, 4 * joint.rest_rate) - 1e-3
        assert joint.pca.full > joint.pca.dead_zone
    assert np.array(profile.cross_talk) == pytest.approx(np.eye(4), abs=0.05)


def test_the_saved_document_is_read_back_the_same(person):
    profile = calibrate(person)
    assert CalibrationProfile.model_validate_json(profile.model_dump_json()) == profile
    standard_parameters(profile)


def test_evr_and_span_are_those_of_the_free_movement(person):
    from sklearn.decomposition import PCA  # here: it takes a second to load

    free = person.free()
    profile = calibrate(person, free=free)
    for joint in profile.joints:
        reference = PCA().fit(free[:, joint.channels])
        assert joint.evr == pytest.approx(reference.explained_variance_ratio_[0])
        place = reference.transform(free[:, joint.channels])[:, 0]
        assert joint.span == pytest.approx(np.subtract(*np.percentile(place, (99, 1))))
        assert np.abs(scores(joint, free)) == pytest.approx(np.abs(place / joint.span), abs=1e-9)


@settings(max_examples=15, deadline=None)
@given(seed=SEEDS, flipped=st.booleans(), shift=st.integers(-20, 30))
def test_the_prompted_movement_is_the_rising_direction(seed, flipped, shift):
    """For either sign of the fabric's response, and labels that lead or trail the movement by some 0.3 s."""
    person = SimulatedPerson(LAYOUT, seed=seed)
    person.gains *= -1 if flipped else 1
    profile = calibrate(person, repetitions=person.repetitions(shift=shift))
    assert_rises_with(profile, person)


@settings(max_examples=10, deadline=None)
@given(seed=SEEDS)
def test_prompts_with_the_way_back_in_them_still_fix_the_sign(seed):
    person = SimulatedPerson(LAYOUT, seed=seed)
    whole = [
        Repetition(one.joint, one.values, slice(one.moving.start, one.moving.stop + 150))
        for one in person.repetitions()
    ]
    profile = calibrate(person, repetitions=whole)
    assert_rises_with(profile, person)


@settings(max_examples=10, deadline=None)
@given(seed=SEEDS)
def test_the_order_of_channels_does_not_matter(seed):
    person = SimulatedPerson(LAYOUT, seed=3)
    free, rest, repetitions = person.free(), person.rest(), person.repetitions()
    order = np.random.default_rng(seed).permutation(len(LAYOUT.channels))
    shuffled = ShirtLayout(name="shuffled", channels=tuple(LAYOUT.channels[i] for i in order), joints=LAYOUT.joints)
    one = calibrate(person, free=free, rest=rest, repetitions=repetitions)
    moved = [Repetition(one.joint, one.values[:, order], one.moving) for one in repetitions]
    other = fit_profile(CleanRecording.of(shuffled, 100.0, free[:, order], rest[:, order], moved))
    for before, after in zip(one.joints, other.joints, strict=True):
        assert scores(after, free[:, order]) == pytest.approx(scores(before, free), abs=1e-6)
        assert after.pca.dead_zone == pytest.approx(before.pca.dead_zone, abs=1e-3)
        assert after.pca.full == pytest.approx(before.pca.full, abs=1e-3)


@settings(max_examples=10, deadline=None)
@given(scale=st.floats(1e-4, 1e5))
def test_the_unit_of_the_signals_does_not_matter(scale):
    person = SimulatedPerson(LAYOUT, seed=4)
    free, rest, repetitions = person.free(), person.rest(), person.repetitions()
    one = calibrate(person, free=free, rest=rest, repetitions=repetitions)
    scaled = [Repetition(one.joint, one.values * scale, one.moving) for one in repetitions]
    other = calibrate(person, free=free * scale, rest=rest * scale, repetitions=scaled)
    for before, after in zip(one.joints, other.joints, strict=True):
        assert after.span == pytest.approx(before.span * scale)
        assert scores(after, free * scale) == pytest.approx(scores(before, free), abs=1e-6)
        assert after.pca.dead_zone == pytest.approx(before.pca.dead_zone, abs=1e-3)
        assert after.grade == before.grade


def test_without_prompts_the_sign_is_arbitrary_reported_and_reproducible(person):
    free, rest = person.free(), person.rest()
    profile = fit_profile(CleanRecording.of(LAYOUT, 100.0, free=free, rest=rest))
    again = fit_profile(CleanRecording.of(LAYOUT, 100.0, free=free, rest=rest))
    assert profile.joints == again.joints
    assert profile.cross_talk is None
    for joint in profile.joints:
        assert joint.grade == "usable"
        assert "which way it counts is not known" in str(joint.description)
        assert not joint.prompted
        heaviest = np.argmax(np.abs(joint.direction))
        assert joint.direction[heaviest] > 0


def test_the_prompted_direction_wins_when_the_free_movement_was_another(person):
    """The free movement is the joint's second way to move; the prompts are the intended one."""
    angles = np.zeros((1000, 4))
    others = np.sin(np.arange(1000) / 20.0)[:, np.newaxis] * np.ones(4) * 8
    profile = calibrate(person, free=person.signals(angles, others))
    for row, joint in enumerate(profile.joints):
        assert joint.angle_deg > 30
        assert "prompted direction is used" in str(joint.description)
        assert joint.grade == "usable"
        gains = person.gains[row, list(joint.channels)]
        assert np.dot(joint.direction, gains) / np.linalg.norm(gains) > 0.95


def test_a_joint_that_was_forgotten_in_the_free_movement_takes_its_span_from_the_prompts(person):
    angles = np.random.default_rng(1).uniform(0, 1) * np.sin(np.arange(1000) / 15.0)[:, np.newaxis] * np.ones(4)
    angles[:, 1] *= 0.05
    profile = calibrate(person, free=person.signals(angles))
    excursion = np.linalg.norm(person.gains[1])
    assert profile.joints[1].span == pytest.approx(excursion, rel=0.15)
    assert "the span is that of the prompts" in str(profile.joints[1].description)


def test_cross_talk_is_measured_and_reported(person):
    repetitions = [
        person.repetition(joint, along={"left_shoulder": 0.9} if joint == "right_shoulder" else None)
        for joint in JOINTS
        for _ in range(3)
    ]
    profile = calibrate(person, repetitions=repetitions)
    matrix = np.array(profile.cross_talk)
    assert matrix[2, 3] > 0.7
    assert matrix[3, 2] < 0.1
    assert profile.joints[2].grade == "usable"
    assert "Left shoulder answers too" in str(profile.joints[2].description)
    assert profile.joints[3].grade == "good"


@pytest.mark.parametrize(
    ("sizes", "reason"), [((1.0, 0.3, 0.15), "differ"), ((1.0, -1.0, 1.0, -0.9), "both ways"), ((0.02,) * 3, "")]
)
def test_uneven_opposite_and_tiny_prompted_movements_are_to_be_repeated(person, sizes, reason):
    joint = calibrate(person, repetitions=[person.repetition("left_elbow", size=size) for size in sizes]).joints[1]
    assert joint.grade == "repeat"
    assert reason in str(joint.description)
    assert reason != "differ" or joint.repeatability == pytest.approx(np.std(sizes) / np.mean(sizes), rel=0.1)


def test_a_joint_that_moves_in_many_ways_has_a_low_evr_which_is_reported():
    person = SimulatedPerson(LAYOUT, second=0.8)
    low = [joint for joint in calibrate(person).joints if joint.evr < 0.8]
    assert len(low) >= 2
    for joint in low:
        assert joint.grade != "good"
        assert "below the usual 80 %" in str(joint.description)


def test_dead_zone_is_four_times_the_noise_at_rest_where_that_is_more():
    restless = SimulatedPerson(LAYOUT, noise=0.2)
    for joint in calibrate(restless).joints:
        assert joint.pca.dead_zone == pytest.approx(4 * joint.rest_rate, abs=1e-4)
        assert joint.pca.dead_zone > 0.15


@pytest.mark.parametrize("sample_rate", [50.0, 100.0, 250.0, 1000.0])
def test_the_map_does_not_depend_on_the_sample_rate(sample_rate):
    profile = calibrate(SimulatedPerson(LAYOUT, sample_rate=sample_rate))
    for joint in profile.joints:
        assert joint.grade == "good", joint.reason
        # A smooth movement of 1 s has its largest rate at 1.875 of its size; the span is a little less than its size.
        assert joint.pca.full == pytest.approx(1.9, abs=0.35)


def test_drift_between_the_recordings_does_no_harm(person):
    drift = np.linspace(0, 0.5, 12)
    repetitions = [
        Repetition(one.joint, one.values + drift[i], one.moving) for i, one in enumerate(person.repetitions())
    ]
    for joint in calibrate(person, repetitions=repetitions).joints:
        assert joint.grade == "good", joint.reason


def test_channels_in_other_units_do_no_harm(person):
    units = np.tile([1.0, 1000.0, 0.01, 50.0, 1e-3], 4)
    free, rest = person.free() * units, person.rest() * units
    repetitions = [Repetition(one.joint, one.values * units, one.moving) for one in person.repetitions()]
    profile = calibrate(person, free=free, rest=rest, repetitions=repetitions)
    assert profile.left_out == {}
    assert {joint.grade for joint in profile.joints} == {"good"}


def test_one_channel_is_enough_for_a_joint():
    layout = ShirtLayout(
        name="one", channels=(Channel(name="a", joint="elbow"),), joints=(Joint(name="elbow", label="Elbow"),)
    )
    joint = calibrate(SimulatedPerson(layout)).joints[0]
    assert joint.evr == 1.0
    assert joint.grade == "good"


@pytest.mark.parametrize(
    ("changes", "words"),
    [
        ({"free": np.zeros((1000, 3))}, "does not have the 20 channels"),
        ({"free": np.ones((100, 20))}, "lasts 1.00 s, which is too short"),
        ({"rest": np.ones((10, 20))}, "the rest lasts 0.10 s"),
        ({"free": np.ones((1000, 20))}, "no joint"),
        ({"free": np.full((1000, 20), np.nan)}, "no joint"),
        ({"unused": {"nothing"}}, "there is no channel 'nothing'"),
        ({"repetitions": [Repetition("knee", np.zeros((100, 20)), slice(10, 90))]}, "there is no joint 'knee'"),
    ],
)
def test_what_cannot_be_fitted_is_refused_in_one_sentence(person, changes, words):
    with pytest.raises(ValueError, match=words) as refusal:
        calibrate(person, **changes)
    assert "\n" not in str(refusal.value)
