"""The short calibration of a camera: a minute in a demonstration, and a choice anywhere else."""

import pytest
from api.fake_clinic import Clinic

from app.api.calibration_view import view_of
from app.calibration.script import short_script
from app.layout import Channel, Joint, ShirtLayout
from app.session.calibration.calibration_progress import Progress
from building import make_profile

CHANNELS = {"trunk": 2, "head": 2, "right_shoulder": 1, "left_shoulder": 1, "right_wrist": 2}
SEEN = ShirtLayout(
    name="What a camera sees",
    channels=tuple(
        Channel(name=f"{joint}_{i}", joint=joint) for joint, count in CHANNELS.items() for i in range(count)
    ),
    joints=tuple(Joint(name=joint, label=joint.replace("_", " ").capitalize()) for joint in CHANNELS),
)
PROMPTED = ["trunk", "head", "right_shoulder", "left_shoulder"]


def use_camera(clinic: Clinic) -> None:
    clinic.process.layout = SEEN
    clinic.good("PUT", "/equipment/shirt", json={"kind": "camera"})


@pytest.fixture
def before_camera(signed_in: Clinic) -> Clinic:
    """Return a demonstration whose shirt is a camera, which records who has consented."""
    patient = signed_in.begin_session()["id"]
    with signed_in.rows() as rows:
        rows.consent(patient, "recording")
    use_camera(signed_in)
    return signed_in


def test_a_demonstration_begins_with_the_short_one_and_drives_by_its_joints(before_camera: Clinic) -> None:
    wizard = before_camera.good("GET", "/calibration")
    assert wizard["short"] is True
    assert [step["joint"] for step in wizard["steps"]] == [None, None, *PROMPTED, None]
    wizard = before_camera.calibrate()
    assert (wizard["short"], wizard["current"]) == (True, "result")
    assert {(step["status"], step["message"]) for step in wizard["steps"]} == {("done", "")}
    bindings = before_camera.good("GET", "/controls")["parameters"]["bindings"]
    assert {binding["control"]: binding["gestures"] for binding in bindings} == {
        "u1+": ["trunk"],
        "u1-": ["head"],
        "u2+": ["right_shoulder"],
        "u2-": ["left_shoulder"],
    }


def test_the_length_is_chosen_and_kept_until_another_one_is_chosen(before_camera: Clinic) -> None:
    whole = before_camera.good("POST", "/calibration/restart", json={"short": False})
    assert (whole["short"], len(whole["steps"])) == (False, len(CHANNELS) + 3)
    assert before_camera.good("GET", "/calibration") == whole
    before_camera.record("rest")
    assert before_camera.good("POST", "/calibration/restart") == whole
    short = before_camera.good("POST", "/calibration/restart", json={"short": True})
    assert (short["short"], len(short["steps"])) == (True, len(PROMPTED) + 3)
    assert before_camera.record("rest")["short"] is True


def test_another_shirt_has_none(in_session: Clinic) -> None:
    assert in_session.good("GET", "/calibration")["short"] is None
    assert "begin the whole one" in in_session.refused(409, "POST", "/calibration/restart", json={"short": True})


def test_a_clinic_begins_with_the_whole_one(owned: Clinic) -> None:
    owned.begin_session()
    use_camera(owned)
    assert owned.good("GET", "/calibration")["short"] is False
    assert owned.good("POST", "/calibration/restart", json={"short": True})["short"] is True


def test_a_joint_without_a_step_is_not_asked_for_again() -> None:
    profile = make_profile(joints=("right_wrist", *PROMPTED))
    still = {"grade": "repeat", "prompted": False}
    joints = [joint.model_copy(update=still if joint.name == "right_wrist" else {}) for joint in profile.joints]
    progress = Progress(
        layout=profile.layout,
        steps=short_script(profile.layout),
        current="result",
        status={},
        running=None,
        started_run=None,
        profile=profile.model_copy(update={"joints": tuple(joints)}),
        accepted=False,
        others=0,
        earlier=None,
        short=True,
    )
    shown = view_of(progress).result
    assert shown is not None
    wrist = next(joint for joint in shown["joints"] if joint["name"] == "right_wrist")
    assert (wrist["step"], wrist["has_to_be_repeated"], wrist["advice"]) == (None, False, None)
