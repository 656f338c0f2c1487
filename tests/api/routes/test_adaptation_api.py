"""Adapting the map as a clinic meets it: off, suggested, by itself; never with a real chair, always one tap back."""

import threading
import time
from collections.abc import Callable
from typing import Any

import pytest
from fake_clinic import WORD, Clinic

from app.api.routes import drives
from app.calibration.adaptation.proposal import JointChange, Proposal
from app.calibration.vocabulary import DriveParameters
from app.faults import Fault, State
from app.scoring.trial_forecast import Effect
from app.session.readings import Adapted
from app.speeds import Speeds
from app.store.people import add_person, sign_in, the_clinic

UP = 0.01
EFFECT = Effect(
    seconds=60.0,
    activations_before=40,
    activations_after=42,
    false_before=3,
    false_after=1,
    alike=0.98,
    felt_change=0.02,
)


def change(parameters: DriveParameters, felt: float = 0.03) -> Adapted:
    """Return a proposal that raises every dead-zone a little, and moves what the first joint calls its middle."""
    gestures = tuple(each.model_copy(update={"dead_zone": each.dead_zone + UP}) for each in parameters.gestures)
    first, *others = parameters.profile.joints
    moved = first.model_copy(update={"mean": tuple(value + UP for value in first.mean)})
    profile = parameters.profile.model_copy(update={"joints": (moved, *others)})
    joint = JointChange(
        name=first.name,
        angle_proposed_deg=3.0,
        angle_applied_deg=2.0,
        evr_before=0.81,
        evr_after=0.86,
        felt_change=felt,
        cross_talk_before=0.10,
        cross_talk_after=0.09,
        dead_zone_before=0.2,
        dead_zone_after=0.2 + UP,
        full_before=1.0,
        full_after=1.0,
        status="applied",
        reason="The movement has turned.",
    )
    adapted = parameters.model_copy(update={"gestures": gestures, "profile": profile})
    proposal = Proposal(
        trials=1,
        joints=(joint,),
        felt_change=felt,
        warns=felt >= 0.05,
        parameters=adapted,
        difference={"felt_change": felt, "turned": {first.name: 2.0}},
        reason="The right elbow would change.",
    )
    return Adapted(proposal, EFFECT)


@pytest.fixture(autouse=True)
def _patient_with_this_machine(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(drives, "HEARD_WITHIN", 60.0)


@pytest.fixture
def ready(signed_in: Clinic) -> Any:
    """A calibrated patient, and trials that always propose something."""
    signed_in.patient = signed_in.visit()  # type: ignore[attr-defined]
    signed_in.calibrate()
    plan = signed_in.good("GET", "/floorplans/apartment")
    signed_in.where = {  # type: ignore[attr-defined]
        "floorplan": plan["name"],
        "path": plan["paths"][0]["name"],
        "screen": WORD,
    }
    signed_in.asked = []  # type: ignore[attr-defined]

    def adapt(
        parameters: DriveParameters, _calibrated: Any, folders: list[Any], fresh: int, _leave_off: Callable[[], bool]
    ) -> Adapted:
        signed_in.asked.append((len(folders), fresh))  # type: ignore[attr-defined]
        return change(parameters)

    signed_in.readings["adapt"] = adapt
    return signed_in


def begin(clinic: Any) -> Any:
    return clinic.good("POST", "/trials", json=clinic.where)


def end(clinic: Any) -> Any:
    return clinic.good("POST", "/trials/current/end", json={"reason": "by hand"})


def drive(clinic: Any) -> Any:
    begin(clinic)
    return end(clinic)


def choose(clinic: Any, mode: str) -> Any:
    return clinic.good("PUT", "/adaptation", json={"mode": mode})


def settled(clinic: Any) -> Any:
    """Wait until what a trial has begun is done, and return how it stands."""
    while clinic.web.adaptation._tasks:
        time.sleep(0.005)
    return clinic.good("GET", "/adaptation")


def proposed(clinic: Any) -> Any:
    return clinic.good("POST", "/adaptation/propose")


def apply(clinic: Any, view: Any) -> Any:
    return clinic("POST", "/adaptation/apply", json={"proposal": view["proposal"]["id"]})


def choose_chair(clinic: Any) -> Any:
    chair = {"name": "Blue", "host": "10.0.0.7", "port": 5354, "speeds": Speeds().model_dump()}
    chairs = clinic.good("POST", "/chairs", json=chair)["chairs"]
    return clinic.good("PUT", "/chairs/chosen", json={"id": chairs[-1]["id"], "dynamics": "unicycle"})


def versions(clinic: Any) -> Any:
    maps = clinic.good("GET", f"/patients/{clinic.patient['id']}/maps")
    return [(one["version"], one["origin"], one["parent"]) for one in maps]


def test_it_is_off_until_somebody_chooses_otherwise_and_may_be_looked_at_all_the_same(ready: Any) -> None:
    view = ready.good("GET", "/adaptation")
    assert (view["mode"], view["version"], view["back_to"], view["proposal"]) == ("off", 1, None, None)
    assert "Nothing was driven with this map yet" in proposed(ready)["why"]
    drive(ready)
    view = settled(ready)
    assert (view["proposal"], ready.asked) == (None, [])
    view = proposed(ready)
    assert ready.asked == [(1, 1)]
    [joint] = view["proposal"]["joints"]
    assert (joint["label"], joint["angle_applied_deg"], joint["evr_after"]) == ("Right elbow", 2.0, 0.86)
    assert (view["proposal"]["changes"], view["proposal"]["effect"], view["why"]) == (True, EFFECT.model_dump(), "")
    assert versions(ready) == [(1, "calibration", None)]


def test_what_is_applied_is_the_next_version_loaded_and_logged(ready: Any) -> None:
    trial = drive(ready)
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
    assert "Nothing was driven with this map yet" in proposed(ready)["why"]


def test_a_suggestion_waits_and_by_itself_does_not(ready: Any) -> None:
    choose(ready, "suggest")
    drive(ready)
    view = settled(ready)
    assert (view["version"], view["proposal"]["applied"]) == (1, None)
    choose(ready, "auto")
    drive(ready)
    view = settled(ready)
    assert (view["version"], view["proposal"]["applied"], view["proposal"]["words"]) == (2, 2, "")
    assert next(row for row in ready.log() if row.what == "map adapted").person is None
    assert ready.process.parameters["gestures"][0]["dead_zone"] == pytest.approx(0.2 + UP)
    drive(ready)
    assert settled(ready)["version"] == 3
    assert ready.asked == [(1, 1), (2, 2), (3, 1)]


def test_not_now_takes_a_suggestion_away_until_the_next_trial(ready: Any) -> None:
    choose(ready, "suggest")
    drive(ready)
    view = settled(ready)
    left = ready.good("POST", "/adaptation/dismiss", json={"proposal": view["proposal"]["id"]})
    assert left["proposal"] is None
    assert left["why"].startswith("You left it as it is")
    drive(ready)
    assert settled(ready)["proposal"] is not None


def test_a_large_change_waits_for_a_person(ready: Any) -> None:
    ready.readings["adapt"] = lambda parameters, *_: change(parameters, felt=0.07)
    choose(ready, "auto")
    drive(ready)
    view = settled(ready)
    assert view["version"] == 1
    assert "waits for somebody" in view["proposal"]["words"]
    assert apply(ready, view).json()["version"] == 2


def test_nothing_is_applied_where_nothing_would_change(ready: Any) -> None:
    nothing = {"trials": 1, "joints": (), "felt_change": 0.0, "warns": False, "parameters": None, "difference": {}}
    ready.readings["adapt"] = lambda *_: Adapted(Proposal(**nothing, reason="The map fits."), None)
    choose(ready, "auto")
    drive(ready)
    view = settled(ready)
    assert (view["version"], view["proposal"]["changes"]) == (1, False)
    assert view["why"] == "The map fits."
    assert apply(ready, view).status_code == 409


def test_one_tap_back_is_a_version_too_and_it_does_not_come_again_by_itself(ready: Any) -> None:
    choose(ready, "auto")
    before = ready.good("GET", "/controls")["hash"]
    drive(ready)
    settled(ready)
    view = ready.good("POST", "/adaptation/back")
    assert (view["version"], view["origin"], view["back_to"], view["mode"]) == (3, "back", None, "suggest")
    assert view["practised"] == 1  # the very set that was driven
    assert ready.good("GET", "/controls")["hash"] == before
    assert ready.process.parameters == ready.good("GET", "/controls")["parameters"]
    assert versions(ready) == [(3, "back", 2), (2, "adaptation", 1), (1, "calibration", None)]
    answer = ready("POST", "/adaptation/back")
    assert answer.status_code == 409
    assert "straight from a calibration" in answer.json()["detail"]
    assert next(row for row in ready.log() if row.what == "map taken back").details["back_to"] == 1


def test_a_proposal_that_something_overtook_is_refused(ready: Any) -> None:
    drive(ready)
    view = proposed(ready)
    ready.good("POST", "/controls/suggest")
    now = ready.good("GET", "/controls")["parameters"]
    names = ("gestures", "bindings", "mode_u1", "mode_u2", "speeds", "cruise_time", "title")
    ready.good("PUT", "/controls", json={**{name: now[name] for name in names}, "cutoff": 2.0})
    answer = apply(ready, view)
    assert answer.status_code == 409
    assert "changed since" in answer.json()["detail"]
    assert "changed since" in ready.good("GET", "/adaptation")["why"]
    assert versions(ready) == [(1, "calibration", None)]


def test_a_trial_that_is_discarded_no_longer_speaks_for_a_change(ready: Any) -> None:
    trial = drive(ready)
    view = proposed(ready)
    ready.good("POST", f"/trials/{trial['id']}/discard", json={"reason": "somebody moved the arm"})
    assert apply(ready, view).status_code == 409
    assert "Nothing was driven with this map yet" in proposed(ready)["why"]


def test_of_another_patient_nothing_is_shown_or_applied(ready: Any) -> None:
    drive(ready)
    view = proposed(ready)
    other = ready.good("POST", "/patients", json={"code": "P-2", "pseudonym": "Stork"})
    ready.good("POST", "/visit", json={"patient_id": other["id"]})
    stands = ready.good("GET", "/adaptation")
    assert (stands["proposal"], stands["version"], stands["mode"]) == (None, None, "off")
    assert apply(ready, view).status_code == 404


def test_nothing_is_adapted_with_a_real_chair_chosen(ready: Any) -> None:
    choose(ready, "suggest")
    drive(ready)
    view = settled(ready)
    choose_chair(ready)
    for answer in (apply(ready, view), ready("POST", "/adaptation/propose")):
        assert answer.status_code == 409
        assert answer.json()["detail"].startswith("A real chair is chosen")
    assert ready.good("GET", "/adaptation")["refusal"].startswith("A real chair is chosen")
    assert versions(ready) == [(1, "calibration", None)]


def test_nothing_is_adapted_while_the_real_chair_is_armed(ready: Any) -> None:
    now = ready.good("GET", "/controls")["parameters"]
    names = ("gestures", "bindings", "mode_u2", "cutoff", "speeds", "cruise_time", "title")
    ready.good("PUT", "/controls", json={**{name: now[name] for name in names}, "mode_u1": "velocity"})
    drive(ready)
    view = proposed(ready)
    choose(ready, "auto")
    choose_chair(ready)
    with ready.screen():
        digest = ready.good("GET", "/drives/summary")["parameters"]["hash"]
        ready.good("POST", "/drives", json={"hash": digest, "screen": WORD})
        loaded = ready.process.parameters
        for path in ("apply", "propose", "back"):
            answer = ready("POST", f"/adaptation/{path}", json={"proposal": view["proposal"]["id"]})
            assert answer.status_code == 409, path
        ready.process.loop.call_soon_threadsafe(
            ready.web.adaptation.trial_over, 1
        )  # even if a trial's end were told only now
        settled(ready)
        assert ready.process.parameters is loaded
        assert versions(ready) == [(1, "calibration", None)]
        ready.good("POST", "/drives/current/end")
    assert ready.good("GET", "/drives/summary")["parameters"]["hash"] == digest


def test_an_adapted_set_is_practised_before_a_real_chair_arms_it(ready: Any) -> None:
    drive(ready)
    apply(ready, proposed(ready))
    summary = ready.good("GET", "/drives/summary")
    assert any("never practised" in refusal for refusal in summary["refusals"])
    drive(ready)
    summary = ready.good("GET", "/drives/summary")
    assert summary["practised"]["trials"] == 1
    assert not any("never practised" in refusal for refusal in summary["refusals"])


@pytest.mark.parametrize("meanwhile", ["trial", "chair", "off"])
def test_by_itself_it_applies_only_between_trials(ready: Any, meanwhile: str) -> None:
    """The look at a trial takes a while; what began meanwhile is not disturbed, and what was chosen holds."""
    go_on, looks, left_off = threading.Event(), threading.Event(), []

    def adapt(
        parameters: DriveParameters, _calibrated: Any, _folders: Any, _fresh: int, leave_off: Callable[[], bool]
    ) -> Adapted:
        looks.set()
        assert go_on.wait(20)
        left_off.append(leave_off())
        return change(parameters)

    ready.readings["adapt"] = adapt
    choose(ready, "auto")
    drive(ready)
    assert looks.wait(20)
    assert ready.good("GET", "/adaptation")["looking"] is True
    if meanwhile == "trial":
        begin(ready)
    elif meanwhile == "chair":
        choose_chair(ready)
    else:
        choose(ready, "off")
    loaded = ready.process.parameters
    go_on.set()
    view = settled(ready)
    assert left_off == [meanwhile == "trial"]
    assert (view["version"], view["proposal"]["applied"]) == (1, None)
    assert view["proposal"]["words"] != ""
    assert ready.process.parameters is loaded
    if meanwhile == "trial":
        end(ready)
        assert settled(ready)["version"] == 2


def test_it_is_applied_at_a_disarmed_standstill_only(ready: Any) -> None:
    drive(ready)
    view = proposed(ready)
    for says, words in (
        ({"v": 0.3}, "armed or moves"),
        ({"driven_omega": -0.3}, "armed or moves"),
        ({"state": State.ARMED}, "armed or moves"),
        ({"state": State.CHECKING}, "armed or moves"),
        ({"state": State.FAULT, "fault": Fault.STOP_TABLET}, "tap Continue"),
        ({"chair_kind": 1}, "A real chair"),
    ):
        ready.process.says = says
        answer = apply(ready, view)
        assert answer.status_code == 409
        assert words in answer.json()["detail"]
    ready.process.says = {}
    assert apply(ready, view).status_code == 200


def test_a_reviewer_looks_and_changes_nothing(ready: Any) -> None:
    drive(ready)
    view = proposed(ready)
    database = ready.client.app.state.people.database
    with database.transaction() as db:
        person = add_person(db, the_clinic(db), "Rita", "reviewer", None)
        token = sign_in(db, person, "test")
    ready.client.cookies["bodydrive_session"] = token
    assert ready.good("GET", "/adaptation")["proposal"]["id"] == view["proposal"]["id"]
    assert ready.good("GET", f"/patients/{ready.patient['id']}/maps")[0]["version"] == 1
    assert apply(ready, view).status_code == 403
    assert ready("PUT", "/adaptation", json={"mode": "auto"}).status_code == 403
    assert ready("POST", "/adaptation/back").status_code == 403


def test_bad_wishes_are_refused_in_a_sentence(ready: Any) -> None:
    assert ready("PUT", "/adaptation", json={"mode": "always"}).status_code == 422
    assert ready("POST", "/adaptation/apply", json={"proposal": "../.."}).status_code == 422
    assert ready("POST", "/adaptation/apply", json={"proposal": "0" * 32}).status_code == 404
    assert ready("GET", "/patients/999/maps").status_code == 404
    ready.good("DELETE", "/visit")
    assert ready("GET", "/adaptation").status_code == 409
