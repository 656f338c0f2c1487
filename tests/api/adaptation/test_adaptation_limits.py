"""When a map is not adapted: a large change, another patient, a real chair, a moving chair, a reviewer."""

import threading
from collections.abc import Callable
from typing import Any

import pytest
from api.adaptation.adapting import apply, change, choose, proposed, settled, versions
from api.fake_clinic import WORD, sentence_of

from app.calibration.adaptation.proposal_document import Proposal
from app.calibration.vocabulary import DriveParameters
from app.faults import Fault, State
from app.session.adaptation import AdaptationFlow
from app.session.adaptation_reading import AdaptationResult


def test_a_large_change_waits_for_a_person(ready: Any) -> None:
    ready.readings["adapt"] = lambda parameters, *_: change(parameters, felt=0.07)
    choose(ready, "auto")
    ready.drive_trial()
    view = settled(ready)
    assert ("waits until somebody" in view["proposal"]["message"], view["version"]) == (True, 1)
    assert apply(ready, view).json()["version"] == 2


def test_nothing_is_applied_where_nothing_would_change(ready: Any) -> None:
    nothing = {"trials": 1, "joints": (), "felt_change": 0.0, "warns": False, "parameters": None, "difference": {}}
    ready.readings["adapt"] = lambda *_: AdaptationResult(Proposal(**nothing, reason="The map fits."), None)
    choose(ready, "auto")
    ready.drive_trial()
    view = settled(ready)
    assert (view["version"], view["proposal"]["changes"], view["why"]) == (1, False, "The map fits.")
    assert apply(ready, view).status_code == 409


def test_a_proposal_that_something_overtook_is_refused(ready: Any) -> None:
    ready.drive_trial()
    view = proposed(ready)
    ready.good("POST", "/controls/suggest")
    ready.set_controls(cutoff=2.0)
    assert "changed since" in sentence_of(apply(ready, view), 409)
    assert "changed since" in ready.good("GET", "/adaptation")["why"]
    assert versions(ready) == [(1, "calibration", None)]


def test_of_another_patient_nothing_is_shown_or_applied(ready: Any) -> None:
    ready.drive_trial()
    view = proposed(ready)
    ready.open_session(ready.add_patient("P-2"))
    stands = ready.good("GET", "/adaptation")
    assert (stands["proposal"], stands["version"], stands["mode"]) == (None, None, "off")
    assert apply(ready, view).status_code == 404


def test_nothing_is_adapted_with_a_real_chair_chosen(ready: Any) -> None:
    choose(ready, "suggest")
    ready.drive_trial()
    view = settled(ready)
    ready.choose_chair()
    for answer in (apply(ready, view), ready("POST", "/adaptation/propose")):
        assert sentence_of(answer, 409).startswith("A real chair is chosen")
    assert ready.good("GET", "/adaptation")["refusal"].startswith("A real chair is chosen")
    assert versions(ready) == [(1, "calibration", None)]


def test_nothing_is_adapted_while_the_real_chair_is_armed(ready: Any) -> None:
    ready.set_controls(mode_u1="velocity")
    ready.drive_trial()
    view = proposed(ready)
    choose(ready, "auto")
    ready.choose_chair()
    with ready.screen():
        digest = ready.good("GET", "/drives/summary")["parameters"]["hash"]
        ready.good("POST", "/drives", json={"hash": digest, "screen": WORD})
        loaded = ready.process.parameters
        for path in ("apply", "propose", "back"):
            answer = ready("POST", f"/adaptation/{path}", json={"proposal": view["proposal"]["id"]})
            assert answer.status_code == 409, path
        # Even if a trial's end were told only now.
        ready.process.loop.call_soon_threadsafe(ready.parts[AdaptationFlow].trial_over, 1)
        settled(ready)
        assert ready.process.parameters is loaded
        assert versions(ready) == [(1, "calibration", None)]
        ready.good("POST", "/drives/current/end")
    assert ready.good("GET", "/drives/summary")["parameters"]["hash"] == digest


def test_an_adapted_set_is_practised_before_a_real_chair_arms_it(ready: Any) -> None:
    ready.drive_trial()
    apply(ready, proposed(ready))
    summary = ready.good("GET", "/drives/summary")
    assert any("never practised" in refusal for refusal in summary["refusals"])
    ready.drive_trial()
    summary = ready.good("GET", "/drives/summary")
    assert summary["practised"]["trials"] == 1
    assert not any("never practised" in refusal for refusal in summary["refusals"])


@pytest.mark.parametrize("meanwhile", ["trial", "chair", "off"])
def test_by_itself_it_applies_only_between_trials(ready: Any, meanwhile: str) -> None:
    """Making a proposal takes a while: a trial begun meanwhile is not disturbed, and the mode chosen then holds."""
    go_on, looks, left_off = threading.Event(), threading.Event(), []

    def adapt(parameters: DriveParameters, *given: Any) -> AdaptationResult:
        looks.set()
        assert go_on.wait(20)
        leave_off: Callable[[], bool] = given[-1]
        left_off.append(leave_off())
        return change(parameters)

    ready.readings["adapt"] = adapt
    choose(ready, "auto")
    ready.drive_trial()
    assert looks.wait(20)
    assert ready.good("GET", "/adaptation")["looking"] is True
    {"trial": ready.start_trial, "chair": ready.choose_chair, "off": lambda: choose(ready, "off")}[meanwhile]()
    loaded = ready.process.parameters
    go_on.set()
    view = settled(ready)
    assert left_off == [meanwhile == "trial"]
    assert (view["version"], view["proposal"]["applied"]) == (1, None)
    assert view["proposal"]["message"] != ""
    assert ready.process.parameters is loaded
    if meanwhile == "trial":
        ready.end_trial()
        assert settled(ready)["version"] == 2


def test_it_is_applied_at_a_disarmed_standstill_only(ready: Any) -> None:
    ready.drive_trial()
    view = proposed(ready)
    for says, words in (
        ({"v": 0.3}, "armed or moves"),
        ({"driven_omega": -0.3}, "armed or moves"),
        ({"state": State.ARMED}, "armed or moves"),
        ({"state": State.CHECKING}, "armed or moves"),
        ({"state": State.FAULT, "fault": Fault.STOP_TABLET}, "take it back first"),
        ({"chair_kind": 1}, "A real chair"),
    ):
        ready.process.says = says
        assert words in sentence_of(apply(ready, view), 409)
    ready.process.says = {}
    assert apply(ready, view).status_code == 200


def test_a_reviewer_looks_and_changes_nothing(ready: Any) -> None:
    ready.drive_trial()
    view = proposed(ready)
    ready.client.cookies.update(ready.cookies_of("Rita", "reviewer"))
    assert ready.good("GET", "/adaptation")["proposal"]["id"] == view["proposal"]["id"]
    assert ready.good("GET", f"/patients/{ready.patient['id']}/maps")[0]["version"] == 1
    assert apply(ready, view).status_code == 403
    assert ready("PUT", "/adaptation", json={"mode": "auto"}).status_code == 403
    assert ready("POST", "/adaptation/back").status_code == 403
