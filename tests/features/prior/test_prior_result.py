"""The result of a calibration with other people's help: where each map comes from, its forecasts and its checks."""

from typing import Any

from api.fake_process import profile_for

from app.calibration.linear_map import Forecast
from building import AGREES, taught_by_others

HITS, FALSE = Forecast(value=71.0, uncertainty=11.0), Forecast(value=1.8, uncertainty=1.2)


def test_the_result_says_what_is_expected_of_each_joint_and_how_the_choice_was_made(in_session: Any) -> None:
    found = {"hits": HITS, "false_per_minute": FALSE, "check": AGREES, "pca_check": AGREES}
    in_session.readings["profile"] = lambda layout: taught_by_others(profile_for(layout), repetitions=3, **found)
    in_session.calibrate()
    for joint in in_session.good("GET", "/calibration")["result"]["joints"]:
        assert joint["map"] == "prior"
        prior = joint["prior"]
        assert (prior["people"], prior["repetitions"], prior["offered"]) == (8, 3, True)
        assert (prior["hits"], prior["false_per_minute"]) == (HITS.model_dump(), FALSE.model_dump())
        assert prior["hits_with_prompts"] is None
        assert prior["check"] == prior["pca_check"] == AGREES.model_dump()


def test_what_is_not_known_without_own_repetitions_is_null(in_session: Any) -> None:
    in_session.readings["profile"] = lambda layout: taught_by_others(profile_for(layout), hits=HITS)
    in_session.calibrate()
    prior = in_session.good("GET", "/calibration")["result"]["joints"][0]["prior"]
    assert (prior["hits"]["value"], prior["false_per_minute"], prior["check"]) == (71.0, None, None)
    assert prior["hits_with_prompts"] == {"value": 71.0, "uncertainty": 2.2}  # what three repetitions would bring


def test_a_joint_has_an_advice_only_where_there_is_something_to_heed(in_session: Any) -> None:
    findings = {"right_elbow": ("repeat", "Repeat it larger."), "left_elbow": ("usable", "Keep to one movement of it.")}

    def profile(layout: Any) -> Any:
        found = profile_for(layout)
        changes = {name: {"grade": grade, "reason": (reason,)} for name, (grade, reason) in findings.items()}
        joints = tuple(joint.model_copy(update=changes.get(joint.name, {})) for joint in found.joints)
        return found.model_copy(update={"joints": joints})

    in_session.readings["profile"] = profile
    in_session.calibrate()
    said = {
        joint["name"]: (joint["has_to_be_repeated"], joint["advice"])
        for joint in in_session.good("GET", "/calibration")["result"]["joints"]
    }
    assert said["right_elbow"] == (True, "Repeat it larger.")
    assert said["left_elbow"] == (False, "Keep to one movement of it.")
    assert said["right_shoulder"] == (False, None)
