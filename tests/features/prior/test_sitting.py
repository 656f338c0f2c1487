"""Whoever is sure that a shirt sits right says so: a ring of sensors that looks turned is then left as worn."""

from typing import Any

import pytest
from features.prior.calibrated_others import profile_with_ring

from app.calibration.linear_map import Arrangement

TURNED = {"cuff": Arrangement(shift=3)}


@pytest.fixture
def turned(in_session: Any) -> Any:
    """A calibrated patient whose shirt looks turned at the right elbow until somebody says otherwise."""
    answers = in_session.readings

    def profile(layout: Any) -> Any:
        return profile_with_ring(layout, **{"as_worn" if answers["as_worn"] else "arrangement": TURNED})

    answers["profile"] = profile
    in_session.calibrate()
    return in_session


def sits(clinic: Any) -> tuple[Any, Any]:
    joints = clinic.good("GET", "/calibration")["result"]["joints"]
    prior = next(joint["prior"] for joint in joints if joint["name"] == "right_elbow")
    return prior["arrangement"], prior["as_worn"]


SHOWN = {"cuff": {"shift": 3, "mirrored": False, "sensors": 5, "front": None, "outside": None}}


def test_a_ring_is_left_as_worn_and_taken_as_turned_again(turned: Any) -> None:
    assert sits(turned) == (SHOWN, {})
    turned.good("POST", "/calibration/sitting", json={"joint": "right_elbow", "is_right": True})
    assert turned.readings["as_worn"] == ("cuff",)
    assert sits(turned) == ({}, SHOWN)
    assert turned.good("GET", "/calibration")["result"]["accepted"] is False
    row = next(row for row in turned.log() if row.what == "shirt sits right")
    assert (row.details["joint"], row.details["right"]) == ("right_elbow", True)
    turned.good("POST", "/calibration/sitting", json={"joint": "right_elbow", "is_right": False})
    assert sits(turned) == (SHOWN, {})


def test_a_free_movement_that_is_recorded_again_forgets_it(turned: Any) -> None:
    turned.good("POST", "/calibration/sitting", json={"joint": "right_elbow", "is_right": True})
    turned.record("prompt-left_elbow")
    assert sits(turned) == ({}, SHOWN)
    turned.record("free")
    assert sits(turned) == (SHOWN, {})


@pytest.mark.parametrize(("joint", "status"), [("left_elbow", 409), ("knee", 404)])
def test_where_nothing_looks_turned_there_is_nothing_to_say(turned: Any, joint: str, status: int) -> None:
    assert turned("POST", "/calibration/sitting", json={"joint": joint, "is_right": True}).status_code == status


def test_before_there_is_a_result_it_is_refused(in_session: Any) -> None:
    in_session.good("GET", "/calibration")
    refused = in_session.refused(409, "POST", "/calibration/sitting", json={"joint": "right_elbow", "is_right": True})
    assert refused == "There is no result yet: do every step first."
