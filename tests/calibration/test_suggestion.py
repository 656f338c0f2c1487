from calibration.simulated_person import JOINTS, SimulatedPerson, calibrate, layout_of

from app.calibration.gestures.discovery import discovery_from_profile
from app.calibration.vocabulary import PAPER_VOCABULARY, standard_parameters
from app.texts import Text


def calibrated(joints, along=None):
    person = SimulatedPerson(layout_of(joints))
    repetitions = [
        person.repetition(joint, along=(along or {}).get(joint))
        for joint in person.layout.joint_names
        for _ in range(3)
    ]
    return calibrate(person, repetitions=repetitions)


def suggested(profile):
    """Return the suggestion from the profile's numbers, as when its recordings are gone."""
    return discovery_from_profile(profile, Text("calibration-recordings-gone")).suggestion


def bound(suggestion):
    return {binding.control: binding.gestures for binding in suggestion.bindings}


def test_the_papers_four_joints_give_the_papers_vocabulary():
    suggestion = suggested(calibrated(JOINTS))
    expected = {control: (name,) for name, control in PAPER_VOCABULARY.items()}
    assert bound(suggestion) == {**expected, "stop": ("right_elbow", "left_elbow")}
    assert "has a strong signal" in str(suggestion.reason)
    assert "%" in str(suggestion.reason)


def test_joints_that_answer_together_are_not_chosen():
    joints = (*JOINTS, "right_wrist", "left_wrist")
    along = {
        "right_wrist": {"right_elbow": 0.9},
        "left_wrist": {"left_elbow": 0.9},
        "right_elbow": {"right_wrist": 0.9},
    }
    chosen = bound(suggested(calibrated(joints, along)))
    names = {name for control, gestures in chosen.items() for name in gestures if control != "stop"}
    assert names in ({*JOINTS}, {"right_wrist", "left_wrist", "right_shoulder", "left_shoulder"})


def test_no_two_gestures_of_which_one_comes_with_the_other_are_bound():
    for share in (0.5, 0.9):
        suggestion = suggested(calibrated(("jaw", "neck"), {"jaw": {"neck": share}}))
        assert [(binding.control, len(binding.gestures)) for binding in suggestion.bindings] == [("u1+", 1)]
        assert "is left out because of" in str(suggestion.reason)
        assert "nothing was prompted" not in str(suggestion.reason)
    three = suggested(calibrated(("jaw", "neck", "brow"), {"jaw": {"neck": 0.9}}))
    names = {name for binding in three.bindings for name in binding.gestures}
    assert names in ({"jaw", "brow"}, {"neck", "brow"})
    assert [binding.control for binding in three.bindings] == ["u1+", "u1-", "stop"]


def test_a_pair_of_sides_that_come_together_is_no_pair():
    joints = ("right_elbow", "left_elbow", "right_shoulder", "left_shoulder", "jaw", "neck", "brow")
    along = {"right_elbow": {"left_elbow": 0.9}, "right_shoulder": {"left_shoulder": 0.9}}
    for chosen in (suggested(calibrated(joints, along)), suggested(calibrated(joints[:5], along))):
        names = {name for binding in chosen.bindings for name in binding.gestures}
        assert not {"right_elbow", "left_elbow"} <= names
        assert not {"right_shoulder", "left_shoulder"} <= names


def test_any_four_joints_do_when_the_body_has_no_pairs():
    chosen = bound(suggested(calibrated(("tongue", "brow", "jaw", "neck"))))
    assert sorted(name for control, gestures in chosen.items() for name in gestures if control != "stop") == [
        "brow",
        "jaw",
        "neck",
        "tongue",
    ]


def test_fewer_joints_give_fewer_bindings_that_are_still_valid():
    for joints in (("jaw",), ("jaw", "neck"), ("jaw", "neck", "brow")):
        profile = calibrated(joints)
        suggestion = suggested(profile)
        standard = standard_parameters(profile).model_dump()
        type(standard_parameters(profile)).model_validate({**standard, "bindings": suggestion.bindings})
        assert [binding.control for binding in suggestion.bindings][: len(joints)] == ["u1+", "u1-", "u2+"][
            : len(joints)
        ]


def test_without_prompts_nothing_is_claimed_about_cross_talk():
    suggestion = suggested(calibrate(SimulatedPerson(layout_of()), repetitions=()))
    assert len(suggestion.bindings) == 5
    assert "not known" in str(suggestion.reason)


def test_a_joint_that_was_not_prompted_while_others_were_is_left_to_the_clinician():
    person = SimulatedPerson(layout_of())
    repetitions = [person.repetition(joint) for joint in ("right_elbow", "left_elbow") for _ in range(3)]
    assert bound(suggested(calibrate(person, repetitions=repetitions))) == {
        "u1+": ("right_elbow",),
        "u1-": ("left_elbow",),
        "stop": ("right_elbow", "left_elbow"),
    }
