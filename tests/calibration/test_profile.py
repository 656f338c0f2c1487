"""The profile and its maps as documents, and what decides which map decodes."""

import json

import pytest
from pydantic import ValidationError

from app.calibration.linear_map import LinearMap, MapCheck
from app.calibration.map_grades import UNPROMPTED
from app.calibration.profile import CalibrationProfile, JointMap
from app.calibration.vocabulary import standard_parameters
from app.texts import Figure, Text
from building import guided_map, make_profile

PCA = MapCheck(in_phase=0.9, hit_rate=0.8, false_per_minute=1.0, false_count=1)


def guided(count, **changes):
    still = (0.0,) * count
    good = MapCheck(in_phase=0.99, hit_rate=0.8, false_per_minute=1.0, false_count=1)
    known = {"short": still, "long": still, "pca_check": PCA, "check": good}
    return guided_map(((0.1,) * count,), 0.3, 1.5, **known | changes)


def prior(count):
    still, rates = (0.0,) * count, ((0.1,) * count, *((0.05,) * count,) * 4)
    return LinearMap(rates=rates, short=still, long=still, dead_zone=0.25, full=1.2, people=8)


def with_prior():
    profile = make_profile(n_channels=8)
    first = profile.joints[0].model_copy(update={"prior": prior(2), "map": "prior", "prompted": False})
    others = (joint.model_copy(update={"prompted": False}) for joint in profile.joints[1:])
    return profile.model_copy(update={"joints": (first, *others)})


def with_guided(kind="guided", **changes):
    profile = make_profile(n_channels=8)
    first = profile.joints[0].model_copy(update={"guided": guided(2, **changes), "map": kind})
    return profile.model_copy(update={"joints": (first, *profile.joints[1:])})


def test_a_joint_is_written_with_the_maps_that_it_has_and_a_map_with_the_parts_that_it_reads():
    document = make_profile(n_channels=8).joints[0].model_dump(mode="json")
    assert {"guided", "prior"} & document.keys() == set()
    assert document["pca"].keys() == {"rates", "dead_zone", "full"}


def test_a_profile_with_a_prior_survives_being_saved_and_its_map_gives_the_handles():
    profile = with_prior()
    assert CalibrationProfile.model_validate_json(profile.model_dump_json()) == profile
    assert profile.joints[0].thresholds == (0.25, 1.2)
    assert len(profile.joints[0].prior.parts) == 7


def test_without_prompts_only_the_joint_with_a_direction_from_other_people_is_bound():
    bound = {name for binding in standard_parameters(with_prior()).bindings for name in binding.gestures}
    assert bound == {"right_elbow"}


def test_which_map_decodes_changes_the_hash():
    hashes = {
        standard_parameters(profile).hash
        for profile in (make_profile(n_channels=8), with_guided("pca"), with_guided("guided"))
    }
    assert len(hashes) == 3


def test_a_guided_profile_survives_being_saved():
    profile = with_guided()
    document = json.loads(profile.model_dump_json())
    assert document["joints"][0]["map"] == "guided"
    assert CalibrationProfile.model_validate(document) == profile


def test_the_handles_are_those_of_the_map_that_is_chosen():
    assert with_guided("pca").joints[0].thresholds == (0.2, 1.0)
    assert with_guided("guided").joints[0].thresholds == (0.3, 1.5)
    gesture = standard_parameters(with_guided("guided")).gestures[0]
    assert (gesture.dead_zone, gesture.full) == (0.3, 1.5)


@pytest.mark.parametrize(
    ("changes", "words"),
    [
        ({"guided": None}, "has no 'guided': add it"),
        ({"guided": guided(3).model_dump()}, "one number per channel"),
        ({"map": "prior"}, "has no 'prior': add it"),
        ({"prior": prior(3).model_dump()}, "one number per channel"),
        ({"map": "best"}, "'pca', 'guided' or 'prior'"),
    ],
)
def test_a_joint_that_contradicts_itself_is_refused(changes, words):
    document = with_guided().joints[0].model_dump() | changes
    with pytest.raises(ValidationError, match=words):
        JointMap.model_validate(document)


@pytest.mark.parametrize(
    ("in_phase", "hit_rate", "repetitions", "better"),
    [
        (0.95, 0.6, 3, True),
        (0.905, 0.78, 3, True),
        (0.905, 0.6, 3, False),
        (0.86, 0.8, 3, False),
        (0.99, 0.2, 3, False),
        (0.5, 0.2, 2, True),
    ],
)
def test_other_people_s_map_is_offered_unless_own_repetitions_speak_against_it(in_phase, hit_rate, repetitions, better):
    check = MapCheck(in_phase=in_phase, hit_rate=hit_rate, false_per_minute=0.0, false_count=0)
    judged = prior(2).model_copy(update={"repetitions": repetitions, "check": check, "pca_check": PCA})
    assert judged.is_better is better
    joint = make_profile(n_channels=8).joints[0].model_copy(update={"prior": judged})
    assert joint.best_map == ("prior" if better else "pca")


@pytest.mark.parametrize(("in_phase", "better"), [(0.02, False), (0.6, True)])
def test_a_map_that_mostly_acts_outside_of_the_movement_is_not_better_than_one_that_does_not_act(in_phase, better):
    check = MapCheck(in_phase=in_phase, hit_rate=0.5, false_per_minute=20.0, false_count=3)
    silent = MapCheck(in_phase=0.0, hit_rate=0.0, false_per_minute=0.0, false_count=0)
    judged = prior(2).model_copy(update={"repetitions": 3, "check": check, "pca_check": silent})
    assert judged.is_better is better


@pytest.mark.parametrize(
    ("check", "better"),
    [({}, True), ({"in_phase": 0.905}, False), ({"hit_rate": 0.76}, False), ({"false_count": 3}, False)],
)
def test_a_guided_map_is_better_only_when_it_loses_nothing(check, better):
    fields = {"in_phase": 0.95, "hit_rate": 0.78, "false_per_minute": 2.0, "false_count": 2} | check
    assert guided(2, check=MapCheck(**fields)).is_better is better


def with_reason(reason):
    document = make_profile().model_dump(mode="json")
    document["joints"][0]["reason"] = reason
    return document


def test_sentences_are_stored_as_ids_with_values():
    reason = (Text("grade-angle", degrees=Figure(31.4)), UNPROMPTED)
    profile = CalibrationProfile.model_validate(with_reason(reason))
    read = CalibrationProfile.model_validate_json(profile.model_dump_json(), strict=True)
    assert read.joints[0].reason == reason
    assert str(read.joints[0].description).endswith(
        "check it in “Try it”. It was not prompted, so which way it counts is not known: prompt it."
    )


def test_a_profile_of_before_stays_as_it_is():
    document = with_reason("Clear main movement: 92 %.")
    profile = CalibrationProfile.model_validate(document)
    assert str(profile.joints[0].description) == "Clear main movement: 92 %."
    assert profile.model_dump(mode="json") == document


@pytest.mark.parametrize(
    "wrong",
    [
        {"text": 5},
        {"id": "grade-angle"},
        {"text": "grade-angle", "values": {"degrees": {"number": 1.0, "digits": 10**9}}},
    ],
)
def test_a_text_that_no_program_has_stored_is_refused(wrong):
    with pytest.raises(ValidationError):
        CalibrationProfile.model_validate(with_reason([wrong]))
