"""Choosing which map decodes a joint, on the result of a calibration."""

from typing import Any

import pytest
from api import running_app
from api.fake_clinic import sentence_of
from api.fake_process import profile_for

from app.calibration.linear_map import LinearMap, MapCheck

WORSE = MapCheck(in_phase=0.86, hit_rate=0.88, false_per_minute=11.4, false_count=2)
BETTER = MapCheck(in_phase=0.95, hit_rate=0.88, false_per_minute=0.0, false_count=0)


def guided(pca: MapCheck, own: MapCheck) -> LinearMap:
    return LinearMap(rates=((0.5, 0.1),), dead_zone=0.4, full=1.5, lag=0.3, repetitions=3, pca_check=pca, check=own)


@pytest.fixture
def fitted(signed_in: Any, monkeypatch: pytest.MonkeyPatch) -> Any:
    """A clinic whose calibration has guided maps: a better one for the first joint, a worse one for the second."""
    plain = profile_for

    def with_guided(layout: Any) -> Any:
        profile = plain(layout)
        right, left, *others = profile.joints
        right = right.model_copy(update={"guided": guided(WORSE, BETTER)})
        left = left.model_copy(update={"guided": guided(BETTER, WORSE)})
        return profile.model_copy(update={"joints": (right, left, *others)})

    monkeypatch.setattr(running_app, "profile_for", with_guided)
    signed_in.begin_session()
    signed_in.calibrate()
    return signed_in


def choose(clinic: Any, joint: str, kind: str) -> Any:
    return clinic("POST", "/calibration/map", json={"joint": joint, "map": kind})


def test_both_figures_are_shown_and_the_study_s_map_is_chosen(fitted: Any) -> None:
    right, left, shoulder, _ = fitted.good("GET", "/calibration")["result"]["joints"]
    assert (right["map"], left["map"], shoulder["map"]) == ("pca", "pca", "pca")
    assert (right["guided"]["offered"], left["guided"]["offered"], shoulder["guided"]) == (True, False, None)
    assert [right["guided"][check]["in_phase"] for check in ("pca_check", "check")] == [0.86, 0.95]
    assert right["dead_zone"] == 0.2


def test_the_chosen_map_drives_once_the_result_is_accepted(fitted: Any) -> None:
    answer = choose(fitted, "right_elbow", "guided")
    assert answer.status_code == 200, answer.text
    result = answer.json()["result"]
    assert [result["joints"][0][name] for name in ("map", "dead_zone", "full")] == ["guided", 0.4, 1.5]
    assert result["accepted"] is False
    assert fitted.process.parameters["profile"]["joints"][0]["map"] == "pca"  # what is loaded is what was accepted
    fitted.good("POST", "/calibration/accept")
    loaded = fitted.process.parameters
    assert loaded["profile"]["joints"][0]["map"] == "guided"
    assert (loaded["gestures"][0]["dead_zone"], loaded["gestures"][0]["full"]) == (0.4, 1.5)
    choose(fitted, "right_elbow", "pca")
    fitted.good("POST", "/calibration/accept")
    assert fitted.process.parameters["profile"]["joints"][0]["map"] == "pca"
    assert fitted.process.parameters["gestures"][0]["dead_zone"] == 0.2


def test_choosing_what_is_chosen_changes_nothing(fitted: Any) -> None:
    assert choose(fitted, "right_elbow", "pca").json()["result"]["accepted"] is True


def test_what_is_not_offered_is_refused(fitted: Any) -> None:
    for joint, kind, status, words in (
        ("left_elbow", "guided", 409, "not better"),
        ("left_shoulder", "guided", 409, "not better"),
        ("tail", "guided", 404, "no calibration for 'tail'"),
        ("right_elbow", "best", 422, "map"),
    ):
        assert words in sentence_of(choose(fitted, joint, kind), status, f"{joint}, {kind}: ")
    assert fitted.good("GET", "/calibration")["result"]["accepted"] is True


def test_before_there_is_a_result_there_is_nothing_to_choose(signed_in: Any) -> None:
    signed_in.begin_session()
    assert "do every step" in sentence_of(choose(signed_in, "right_elbow", "guided"), 409)


def test_while_a_step_is_recorded_nothing_is_chosen(fitted: Any) -> None:
    fitted.good("POST", "/calibration/steps/rest/start")
    assert choose(fitted, "right_elbow", "guided").status_code == 409
