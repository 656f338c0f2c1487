"""Before a real chair, the person's own movement has to confirm what other people taught."""

from typing import Any

import pytest
from api.fake_clinic import arm, sentence_of
from api.fake_process import profile_for

from building import AGREES, taught_by_others

WRONG_WAY = AGREES.model_copy(update={"in_phase": 0.1})
TOO_SMALL = AGREES.model_copy(update={"hit_rate": 0.2})


def practised(clinic: Any, **taught: Any) -> Any:
    """Return the clinic with a patient whose calibration came from others, practised, and a chosen chair."""
    clinic.readings["profile"] = lambda layout: taught_by_others(profile_for(layout), **taught)
    clinic.good("POST", "/calibration/restart")
    clinic.calibrate()
    clinic.set_controls(mode_u1="velocity")
    clinic.drive_trial()  # the virtual chair drives by other people alone
    clinic.choose_chair(forward=0.5)
    return clinic


DISAGREE = [{"repetitions": 3, "check": check, "pca_check": AGREES} for check in (WRONG_WAY, TOO_SMALL)]


@pytest.mark.parametrize("taught", [{}, {"repetitions": 1}, *DISAGREE])
def test_a_map_that_no_own_movement_confirms_is_practised_and_not_armed(calibrated: Any, taught: Any) -> None:
    clinic = practised(calibrated, **taught)
    (sentence,) = clinic.good("GET", "/drives/summary")["refusals"]
    assert sentence.startswith("Other people taught the movement of ")
    assert sentence.endswith("repeat each once on the Calibrate page, and practise again.")
    with clinic.screen():
        assert sentence_of(arm(clinic), 409) == sentence
    assert [do for do, _ in clinic.process.calls].count("arm") == 1  # that of the virtual chair
    assert clinic.good("GET", f"/drives?patient={clinic.patient['id']}") == []


def test_one_own_repetition_of_each_bound_movement_that_agrees_is_armed(calibrated: Any) -> None:
    clinic = practised(calibrated, repetitions=1, check=AGREES, pca_check=AGREES)
    assert clinic.good("GET", "/drives/summary")["refusals"] == []
    with clinic.screen():
        assert arm(clinic).status_code == 201


def test_only_joints_that_are_not_confirmed_are_named(calibrated: Any) -> None:
    clinic = practised(calibrated, joints=["right_elbow"])
    (sentence,) = clinic.good("GET", "/drives/summary")["refusals"]
    joints = [joint["label"].lower() for joint in clinic.good("GET", "/calibration")["result"]["joints"]]
    assert [joint for joint in joints if joint in sentence] == ["right elbow"]
