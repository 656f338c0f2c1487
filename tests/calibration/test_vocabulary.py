import hashlib
import re

import pytest
from hypothesis import given
from hypothesis import strategies as st
from pydantic import ValidationError

from app.calibration.vocabulary import DriveParameters, Gesture, arming_hash, standard_parameters
from building import make_profile


def bound(profile):
    return {(binding.control, binding.gestures) for binding in standard_parameters(profile).bindings}


def test_the_papers_vocabulary_and_a_stop_of_both_elbows():
    assert bound(make_profile()) == {
        ("u1+", ("right_elbow",)),
        ("u1-", ("left_elbow",)),
        ("u2+", ("right_shoulder",)),
        ("u2-", ("left_shoulder",)),
        ("stop", ("right_elbow", "left_elbow")),
    }


def test_a_joint_that_was_not_prompted_is_bound_only_when_none_was():
    profile = make_profile()
    unknown = [joint.model_copy(update={"prompted": False}) for joint in profile.joints]
    one_skipped = profile.model_copy(update={"joints": (unknown[0], *profile.joints[1:])})
    assert bound(one_skipped) == {("u1-", ("left_elbow",)), ("u2+", ("right_shoulder",)), ("u2-", ("left_shoulder",))}
    assert bound(profile.model_copy(update={"joints": tuple(unknown)})) == bound(profile)


@given(st.binary(min_size=32, max_size=32).map(bytes.hex), st.binary(min_size=8, max_size=8).map(bytes.hex))
def test_a_chair_is_armed_with_the_hash_of_the_set_and_its_document(parameters, document):
    assert arming_hash(parameters, "") == parameters
    both = hashlib.sha256(bytes.fromhex(parameters + document)).hexdigest()
    assert arming_hash(parameters, document) == both


def test_without_elbows_trunk_and_head_take_their_controls():
    upright = {
        ("u1+", ("trunk",)),
        ("u1-", ("head",)),
        ("u2+", ("right_shoulder",)),
        ("u2-", ("left_shoulder",)),
    }
    profile = make_profile(joints=("head", "trunk", "left_shoulder", "right_shoulder", "right_elbow"))
    assert ("u1+", ("right_elbow",)) in bound(profile)
    *four, elbow = profile.joints
    unprompted = elbow.model_copy(update={"prompted": False})
    assert bound(profile.model_copy(update={"joints": (*four, unprompted)})) == upright
    by_others = unprompted.model_copy(update={"map": "prior"})
    elbows = [by_others, by_others.model_copy(update={"name": "left_elbow"})]
    assert bound(profile.model_copy(update={"joints": (*four, *elbows)})) == upright
    assert bound(profile.model_copy(update={"joints": tuple(four)})) == upright
    assert bound(profile.model_copy(update={"joints": tuple(four[1:])})) == {
        ("u2+", ("right_shoulder",)),
        ("u2-", ("left_shoulder",)),
    }


def test_the_hash_is_that_of_what_drives():
    parameters = standard_parameters(make_profile())
    again = DriveParameters.model_validate_json(parameters.model_dump_json())
    assert again.hash == parameters.hash
    assert parameters.model_copy(update={"cutoff": 3.1}).hash != parameters.hash


@pytest.mark.parametrize("full", [0.2, 0.1, float("nan"), float("inf"), 1e308, "1", True])
def test_full_is_a_number_above_the_dead_zone(full):
    with pytest.raises(ValidationError):
        Gesture(name="right_elbow", joint="right_elbow", dead_zone=0.2, full=full)


@pytest.mark.parametrize(("dead_zone", "full", "words"), [(0.2, 0.1, "(10 %)"), (0.2, 0.2099, "(20 %)")])
def test_a_full_that_is_too_low_is_told_the_least_one(dead_zone, full, words):
    with pytest.raises(ValidationError, match=re.escape(words) + " must be at least 21 %"):
        Gesture(name="right_elbow", joint="right_elbow", dead_zone=dead_zone, full=full)
