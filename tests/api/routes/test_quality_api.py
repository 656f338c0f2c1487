"""The control quality over the API."""

from typing import Any

import pytest

FIGURES = {"map_angle_deg": 12.0, "evr": 0.9, "null_space_share": 0.1, "activations": 8}  # of the trial and its joint
ELBOW: dict[str, Any] = {"name": "right_elbow", "label": "Right elbow", "channels": ["right_elbow_1", "right_elbow_2"]}
ELBOW |= {"dead_zone": 0.2, "span": 1.0, "span_share": 1.0, "rest_rate": 0.02, "moved": 9.0}
ELBOW |= {"direction": {"right_elbow_1": 1.0, "right_elbow_2": 0.0}}
QUALITY: dict[str, Any] = FIGURES | {
    "cross_talk": 0.05,
    "activations_per_metre": 0.8,
    "joints": [FIGURES | ELBOW],
    "bad_channels": [{"name": "right_elbow_1", "joint": "right_elbow", "share": 0.6, "silent": True}],
}


@pytest.fixture
def ready(calibrated: Any) -> Any:
    calibrated.page = f"/patients/{calibrated.patient['id']}/quality"
    return calibrated


def test_without_trials_there_is_nothing_to_say(ready: Any) -> None:
    nothing = {"trials": [], "labels": {}, "warnings": [], "note": ""}
    assert ready.good("GET", ready.page) == {"source": "simulated", **nothing}  # a demonstration
    assert ready("GET", "/patients/999/quality").status_code == 404


def test_a_finished_trial_has_its_quality_and_its_warning(ready: Any) -> None:
    ready.readings["quality"] = QUALITY
    trial = ready.drive_trial()
    del ready.readings["quality"]  # from here on only what was kept can be told
    assert ready.good("GET", f"/trials/{trial['id']}")["quality"]["joints"][0]["direction"]["right_elbow_1"] == 1.0
    found = ready.good("GET", f"{ready.page}?floorplan=apartment&path=main")
    (row,) = found["trials"]
    assert (row["id"], row["number"], row["session"], row["map_version"]) == (trial["id"], 1, 1, 1)
    assert (row["quality"]["map_angle_deg"], row["joints"]["right_elbow"]["span_share"]) == (12.0, 1.0)
    assert found["labels"] == {"right_elbow": "Right elbow"}
    assert [warning["kind"] for warning in found["warnings"]] == ["sensor"]
    assert "Few trials" in found["note"]
    assert ready.good("GET", f"{ready.page}?floorplan=nowhere&path=none")["trials"] == []


def test_the_quality_of_an_older_trial_is_made_up_for(ready: Any) -> None:
    trial = ready.drive_trial()
    assert trial["measures"] is not None  # which do not depend on it
    assert ready.good("GET", f"/trials/{trial['id']}")["quality"] is None
    assert ready.good("GET", ready.page)["trials"] == []
    second = ready.drive_trial()
    ready.readings["quality"] = QUALITY
    assert ready.good("GET", f"/trials/{second['id']}")["quality"]["evr"] == 0.9
    del ready.readings["quality"]
    assert [row["id"] for row in ready.good("GET", ready.page)["trials"]] == [second["id"]]


def test_a_discarded_trial_warns_of_nothing(ready: Any) -> None:
    ready.readings["quality"] = QUALITY
    trial = ready.drive_trial()
    ready.good("POST", f"/trials/{trial['id']}/discard", json={"reason": "plug was out"})
    found = ready.good("GET", ready.page)
    assert (found["trials"], found["warnings"]) == ([], [])
