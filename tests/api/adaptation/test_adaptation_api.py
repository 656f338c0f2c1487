"""The adaptation of the map over the API: off, suggested, by itself, one tap back."""

from typing import Any

import pytest
from api.adaptation.adapting import EFFECT, UP, apply, choose, proposed, settled, versions


def test_it_is_off_until_somebody_chooses_otherwise_and_may_be_looked_at_all_the_same(ready: Any) -> None:
    view = ready.good("GET", "/adaptation")
    assert (view["mode"], view["version"], view["back_to"], view["proposal"]) == ("off", 1, None, None)
    assert "Nothing was driven with this calibration yet" in proposed(ready)["why"]
    ready.drive_trial()
    assert (settled(ready)["proposal"], ready.asked) == (None, [])
    view = proposed(ready)
    assert ready.asked == [(1, 1)]
    [joint] = view["proposal"]["joints"]
    assert (joint["label"], joint["angle_applied_deg"], joint["evr_after"]) == ("Right elbow", 2.0, 0.86)
    assert (view["proposal"]["changes"], view["proposal"]["effect"], view["why"]) == (True, EFFECT.model_dump(), "")
    assert versions(ready) == [(1, "calibration", None)]


def test_what_is_applied_is_the_next_version_loaded_and_logged(ready: Any) -> None:
    trial = ready.drive_trial()
    before = ready.good("GET", "/controls")
    answer = apply(ready, proposed(ready))
    assert answer.status_code == 200, answer.text
    view, now = answer.json(), ready.good("GET", "/controls")
    assert (view["version"], view["origin"], view["back_to"]) == (2, "adaptation", 1)
    assert (view["proposal"]["applied"], view["practised"]) == (2, 0)
    assert now["hash"] != before["hash"]
    assert now["parameters"]["bindings"] == before["parameters"]["bindings"]
    assert ready.process.parameters == now["parameters"]
    row = next(row for row in ready.log() if row.what == "map adapted")
    assert (row.person is not None, row.details["version"], row.details["parent"]) == (True, 2, 1)
    assert (row.details["felt_change"], row.details["hash"]) == (0.03, now["hash"])
    [newest, first] = ready.good("GET", f"/patients/{ready.patient['id']}/maps")
    assert (newest["parent"], newest["trials"], first["trials"]) == (1, [], [trial["id"]])
    assert newest["difference"]["turned"] == {"right_elbow": 2.0}
    assert (newest["difference"]["felt_change"], newest["difference"]["by_itself"]) == (0.03, False)
    assert apply(ready, view).status_code == 404  # once
    assert "Nothing was driven with this calibration yet" in proposed(ready)["why"]


def test_a_suggestion_waits_and_by_itself_does_not(ready: Any) -> None:
    choose(ready, "suggest")
    ready.drive_trial()
    view = settled(ready)
    assert (view["version"], view["proposal"]["applied"]) == (1, None)
    choose(ready, "auto")
    ready.drive_trial()
    view = settled(ready)
    assert (view["version"], view["proposal"]["applied"], view["proposal"]["message"]) == (2, 2, "")
    assert next(row for row in ready.log() if row.what == "map adapted").person is None
    assert ready.process.parameters["gestures"][0]["dead_zone"] == pytest.approx(0.2 + UP)
    ready.drive_trial()
    assert settled(ready)["version"] == 3
    assert ready.asked == [(1, 1), (2, 2), (3, 1)]
    assert [len(one.fulls) > 0 for one in ready.past] == [True] * 3  # what is lost is told from all of them


def test_not_now_takes_a_suggestion_away_until_the_next_trial(ready: Any) -> None:
    choose(ready, "suggest")
    ready.drive_trial()
    view = settled(ready)
    left = ready.good("POST", "/adaptation/dismiss", json={"proposal": view["proposal"]["id"]})
    assert (left["proposal"], left["why"].startswith("You left it as it is")) == (None, True)
    ready.drive_trial()
    assert settled(ready)["proposal"] is not None


def test_one_tap_back_is_a_version_too_and_it_does_not_come_again_by_itself(ready: Any) -> None:
    choose(ready, "auto")
    before = ready.good("GET", "/controls")["hash"]
    ready.drive_trial()
    settled(ready)
    view = ready.good("POST", "/adaptation/back")
    assert (view["version"], view["origin"], view["back_to"], view["mode"]) == (3, "back", None, "suggest")
    assert view["practised"] == 1  # the very set that was driven
    assert ready.good("GET", "/controls")["hash"] == before
    assert ready.process.parameters == ready.good("GET", "/controls")["parameters"]
    assert versions(ready) == [(3, "back", 2), (2, "adaptation", 1), (1, "calibration", None)]
    assert "straight from a calibration" in ready.refused(409, "POST", "/adaptation/back")
    assert next(row for row in ready.log() if row.what == "map taken back").details["back_to"] == 1


def test_a_trial_that_is_discarded_no_longer_speaks_for_a_change(ready: Any) -> None:
    trial = ready.drive_trial()
    view = proposed(ready)
    ready.good("POST", f"/trials/{trial['id']}/discard", json={"reason": "somebody moved the arm"})
    assert apply(ready, view).status_code == 409
    assert "Nothing was driven with this calibration yet" in proposed(ready)["why"]


def test_a_worn_shirt_s_map_does_not_follow_what_a_simulated_person_did(ready: Any) -> None:
    """Safety S26: what the proposal is made of follows the shirt in use."""
    ready.drive_trial()
    assert proposed(ready)["proposal"] is not None
    ready.good("PUT", "/equipment/shirt", json={"kind": "udp", "port": 0})
    view = proposed(ready)
    assert (view["proposal"], ready.asked) == (None, [(1, 1)])
    assert "Nothing was driven with this calibration yet" in view["why"]


def test_bad_wishes_are_refused_in_a_sentence(ready: Any) -> None:
    assert ready("PUT", "/adaptation", json={"mode": "always"}).status_code == 422
    assert ready("POST", "/adaptation/apply", json={"proposal": "../.."}).status_code == 422
    assert ready("POST", "/adaptation/apply", json={"proposal": "0" * 32}).status_code == 404
    assert ready("GET", "/patients/999/maps").status_code == 404
    ready.good("DELETE", "/session")
    assert ready("GET", "/adaptation").status_code == 409
