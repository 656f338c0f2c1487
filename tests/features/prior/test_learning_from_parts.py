"""What a calibration that is not complete, or of a shirt that sits otherwise, adds to the clinic's prior."""

from typing import Any

import pytest
from features.prior.calibrated_others import entry, profile_with_ring

from app.calibration.linear_map import Arrangement
from app.features.prior.tables import PriorEntry


def entry_of(*joints: str, recordings: int = 1) -> dict[str, Any]:
    """Return an entry of these joints."""
    one = entry()["joints"]["right_elbow"]
    return {"recordings": recordings, "joints": dict.fromkeys(joints, one)}


def stored(clinic: Any, patient: int) -> dict[str, Any]:
    """Return the document that the patient adds to the prior, empty without one."""
    with clinic.database.transaction() as db:
        row = db.query(PriorEntry).filter_by(patient_id=patient).one_or_none()
        return {} if row is None else dict(row.document)


@pytest.fixture
def newcomer(with_others: Any) -> tuple[Any, int]:
    """A clinic with four others, and a new patient who has rested and moved freely."""
    patient = with_others.begin_session("P-9")["id"]
    with_others.record("rest", "free")
    return with_others, patient


def test_drive_now_without_a_prompt_adds_nothing(newcomer: Any) -> None:
    """Unprompted movement taught nothing on real recordings, and it has no labels."""
    clinic, patient = newcomer
    clinic.good("POST", "/calibration/drive-now")
    assert stored(clinic, patient) == {}
    assert clinic.good("GET", "/clinic-prior")["people"] == 4


def test_drive_now_after_some_prompts_adds_the_joints_that_were_prompted(newcomer: Any) -> None:
    clinic, patient = newcomer
    clinic.record("prompt-left_elbow")
    clinic.readings["entry"] = entry_of("left_elbow")
    clinic.good("POST", "/calibration/drive-now")
    assert set(stored(clinic, patient)["joints"]) == {"left_elbow"}
    assert clinic.good("GET", "/clinic-prior")["people"] == 5


def test_switched_off_a_partial_calibration_adds_nothing_either(newcomer: Any) -> None:
    clinic, patient = newcomer
    clinic.record("prompt-left_elbow")
    clinic.good("PUT", "/clinic-prior", json={"on": False})
    assert clinic("POST", "/calibration/drive-now").status_code == 409  # nobody stands in for what is missing
    clinic.good("PUT", "/clinic-prior", json={"on": True})
    assert stored(clinic, patient) == {}


def test_a_later_partial_calibration_replaces_its_joints_and_keeps_the_others(newcomer: Any) -> None:
    clinic, patient = newcomer
    clinic.readings["entry"] = entry_of("right_elbow", "left_elbow", recordings=2)
    clinic.calibrate()
    clinic.good("POST", "/calibration/restart")
    clinic.record("rest", "free", "prompt-left_elbow")
    newer = entry_of("left_elbow")
    newer["joints"]["left_elbow"]["strokes"] = 2.0
    clinic.readings["entry"] = newer
    clinic.good("POST", "/calibration/drive-now")
    joints = stored(clinic, patient)["joints"]
    assert {name: joint["strokes"] for name, joint in joints.items()} == {"right_elbow": 3.0, "left_elbow": 2.0}


@pytest.mark.parametrize("known", ["arrangement", "as_worn"])
def test_a_joint_whose_ring_sits_otherwise_adds_nothing(newcomer: Any, known: str) -> None:
    """Its sensors lie elsewhere than those of other people, or look so."""
    clinic, patient = newcomer

    sits = {known: {"cuff": Arrangement(shift=1)}}
    clinic.readings["profile"] = lambda layout: profile_with_ring(layout, **sits)
    clinic.readings["entry"] = entry_of("right_elbow", "left_elbow")
    clinic.calibrate()
    assert set(stored(clinic, patient)["joints"]) == {"left_elbow"}
