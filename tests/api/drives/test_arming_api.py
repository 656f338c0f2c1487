"""Arming a real chair: the summary before it, the refusals, and who may arm."""

from typing import Any

from api.fake_clinic import WHERE, WORD, Clinic, arm, sentence_of

from app.calibration.vocabulary import arming_hash
from app.hardware.chair.reasons import DESCRIPTIONS, Reason
from app.hardware.shirt.kind import NO_KEY
from app.session.equipment.shirt import Equipment
from app.speed_limits import Speeds
from app.store.tables import ParameterSet

ARMED, FAULT = 2, 3  # of a chair's telemetry


def test_before_anybody_is_here_there_is_nothing_to_arm(signed_in: Clinic) -> None:
    summary = signed_in.good("GET", "/drives/summary")
    assert (summary["chair"], summary["parameters"], summary["speeds"]) == (None, None, None)
    assert summary["practised"] == {"trials": 0, "last": None}
    session, chair = (sentence.split(":")[0] for sentence in summary["refusals"])
    assert (session, chair) == ("No session is open", "The virtual chair is chosen")
    signed_in.begin_session()
    assert signed_in.good("GET", "/drives/summary")["refusals"][0].startswith("Nothing is calibrated yet")


def test_the_summary_is_what_would_apply(ready: Any) -> None:
    ready.good("POST", "/control/dial", json={"share": 0.5})
    ready.good("PUT", "/limits", json={**Speeds().model_dump(), "turn": 0.8})
    summary = ready.good("GET", "/drives/summary")
    parameters = summary["parameters"]
    assert (summary["chair"]["name"], parameters["mode_u1"], parameters["cruise_time"]) == ("Blue", "velocity", 10.0)
    assert (summary["speeds"]["forward"], summary["speeds"]["turn"]) == (0.25, 0.4)  # chair, clinic, half of both
    assert (summary["practised"]["trials"], summary["last_practised"]["hash"]) == (1, parameters["hash"])
    assert (summary["differences"], summary["refusals"]) == ([], [])


def test_a_chair_with_a_document_is_armed_with_the_hash_of_both(ready: Any) -> None:
    plain = ready.good("GET", "/drives/summary")
    assert (plain["hash"], plain["document"], plain["crawls"]) == (plain["parameters"]["hash"], "", False)
    ready.process.crawls = True
    assert ready.good("GET", "/drives/summary")["crawls"]
    ready.process.document, ready.process.crawls = "0123456789abcdef", False
    summary = ready.good("GET", "/drives/summary")
    assert summary["hash"] == arming_hash(plain["hash"], "0123456789abcdef") != plain["hash"]
    assert summary["practised"]["trials"] == 1, "practice is of the set"
    with ready.screen():
        assert "changed meanwhile" in ready.refused(
            409, "POST", "/drives", json={"hash": plain["hash"], "screen": WORD}
        )
        assert arm(ready).json()["hash"] == summary["hash"]
    assert ready.process.calls[-1] == ("arm", {"hash": summary["hash"]})
    run = next(fields for do, fields in reversed(ready.process.calls) if do == "run")
    assert run["meta"]["document"] == "0123456789abcdef"


def test_what_was_not_practised_is_not_armed_and_the_differences_are_named(ready: Any) -> None:
    faster = {**Speeds().model_dump(), "forward": 1.0}
    digest = ready.set_controls(speeds=faster, cutoff=4.0)["hash"]
    summary = ready.good("GET", "/drives/summary")
    assert summary["differences"] == [
        {"kind": "field", "name": "cutoff", "before": 3.0, "now": 4.0},
        {"kind": "field", "name": "forward", "before": 0.8, "now": 1.0},
    ]
    assert "never practised" in summary["refusals"][0]
    with ready.screen():
        assert arm(ready).status_code == 409
    assert "arm" not in [do for do, _ in ready.process.calls if do == "arm"][1:]
    ready.good("PUT", "/chairs/chosen", json={"id": None, "dynamics": "unicycle"})
    trial = ready.drive_trial()
    summary = ready.good("GET", "/drives/summary")
    assert (summary["practised"]["trials"], summary["parameters"]["hash"]) == (1, digest)
    ready.good("POST", f"/trials/{trial['id']}/discard", json={"reason": "tired"})
    assert ready.good("GET", "/drives/summary")["practised"]["trials"] == 0


def test_a_hash_that_was_stored_by_an_older_program_counts_as_it_is_reckoned_now(ready: Any) -> None:
    with ready.database.transaction() as db:
        for row in db.query(ParameterSet):
            row.hash = "0" * 64
            row.settings = {name: value for name, value in row.settings.items() if name != "cruise_time"}
    summary = ready.good("GET", "/drives/summary")
    assert summary["practised"]["trials"] == 1
    assert summary["parameters"]["hash"] == ready.good("GET", "/controls")["hash"] != "0" * 64
    with ready.screen():
        assert arm(ready).status_code == 201
    assert ready.process.calls[-1] == ("arm", {"hash": summary["parameters"]["hash"]})


def test_a_chair_that_cannot_drive_is_not_armed(ready: Any) -> None:
    cases: list[tuple[dict[str, Any], str]] = [
        ({"chair_age": 0.5}, "does not answer"),
        ({"chair_age": float("nan")}, "does not answer"),
        ({"chair_age": float("inf")}, "does not answer"),
        ({"stop_input": 1}, "stop switch"),
        ({"chair_state": FAULT, "chair_fault": Reason.OUTPUT}, DESCRIPTIONS[Reason.OUTPUT]),
        ({"chair_state": FAULT, "chair_fault": 99}, "does not know"),
    ]
    with ready.screen():
        for says, words in cases:
            ready.process.says = says
            assert words in ready.good("GET", "/drives/summary")["refusals"][0], says
            assert words in sentence_of(arm(ready), 409, f"{says}: "), says
    assert ready.good("GET", f"/drives?patient={ready.patient['id']}") == []


def test_a_chosen_chair_that_is_not_open_is_not_taken_for_the_virtual_one(ready: Any) -> None:
    ready.process.chair = "virtual"
    assert ready.good("GET", "/drives/summary")["refusals"] == ["Blue is not open: choose it again."]
    assert ready("POST", "/trials", json=WHERE).status_code == 409


def test_acceleration_mode_needs_the_stop_switch(calibrated: Any) -> None:
    calibrated.set_controls(mode_u1="acceleration")
    calibrated.drive_trial()
    calibrated.choose_chair(forward=0.5)
    assert "stop switch" in calibrated.good("GET", "/drives/summary")["refusals"][0]
    calibrated.process.switch_seen = True
    assert calibrated.good("GET", "/drives/summary")["refusals"] == []


def test_a_shirt_that_cannot_be_trusted_arms_no_real_chair_and_the_page_says_why(ready: Any) -> None:
    """Safety S29: in a demonstration, too."""
    ready.parts[Equipment].mistrust = str(NO_KEY)
    assert ready.good("GET", "/drives/summary")["refusals"] == [str(NO_KEY)]
    with ready.screen():
        assert sentence_of(arm(ready), 409) == str(NO_KEY)
    ready.process.mistrust = ""
    ready.good("PUT", "/equipment/shirt", json={"kind": "simulator"})
    assert ready.good("GET", "/drives/summary")["refusals"] == []


def test_nobody_arms_from_outside(ready: Any) -> None:
    headers = ("Forwarded", "X-Forwarded-For", "X-Forwarded-Proto", "Via", "X-Real-IP", "x-forwarded-host")
    with ready.screen():
        for header in headers:
            assert "in the building" in sentence_of(arm(ready, **{header: "127.0.0.1"}), 403, f"{header}: ")
        assert arm(ready).status_code == 201
        ready.good("POST", "/control/stop")
        for stops, header in enumerate(headers, start=1):
            for path, body, value in (("clear", {"stops": stops}, "127.0.0.1"), ("dial", {"share": 0.5}, "1")):
                assert ready("POST", f"/control/{path}", json=body, headers={header: value}).status_code == 403, header
            assert ready("POST", "/control/stop", headers={header: "127.0.0.1"}).status_code == 200, header
        assert ready.good("POST", "/control/clear", json={"stops": 1 + len(headers)})["state"] == "armed"


def test_a_screen_that_was_not_heard_does_not_arm(ready: Any) -> None:
    assert "in view" in sentence_of(arm(ready), 409)
    with ready.screen("another-screen"):
        assert arm(ready).status_code == 409


def test_the_hash_that_was_read_is_the_one_that_is_armed(ready: Any) -> None:
    with ready.screen():
        assert "changed meanwhile" in ready.refused(409, "POST", "/drives", json={"hash": "0" * 64, "screen": WORD})
