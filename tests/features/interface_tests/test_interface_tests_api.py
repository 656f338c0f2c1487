"""The two-minute test over the API: started, shown, ended, measured from its recording, and asked about."""

import math
from typing import Any

import pytest
from api.fake_clinic import WORD
from stored_interface_test import MEASURES, store_interface_test

from app.api.live.live_picture import ClinicLive
from app.api.patient_screen.patient_picture import PatientPicture
from app.clock import utc_now
from app.faults import State
from app.session.open_session import SessionFlow
from app.store.interface_tests import close_interrupted_tests
from app.store.tables import InterfaceTest

START = {"screen": WORD}


def of_patient(clinic: Any) -> Any:
    return clinic.good("GET", f"/interface-tests?patient={clinic.patient['id']}")


def picture(clinic: Any) -> Any:
    return clinic.parts[ClinicLive]._picture().model_dump()


def add_done(clinic: Any, **done: Any) -> None:
    """Store a test of the open session that was done."""
    with clinic.database.transaction() as db:
        store_interface_test(db, clinic.parts[SessionFlow].session_id, **done)


def test_a_test_is_recorded_without_arming_shown_and_ended_by_hand(calibrated: Any) -> None:
    test = calibrated.good("POST", "/interface-tests", json=START)
    assert (test["status"], test["number"], test["session"], test["measures"]) == ("running", 1, 1, None)
    assert test["source"]["description"].startswith("Simulated shirt")
    calls = [do for do, _ in calibrated.process.calls]
    assert calls[-1] == "run"
    assert "arm" not in calls
    fields = calibrated.process.calls[-1][1]
    assert (fields["kind"], fields["test"]["seed"], fields["cues"]) == ("interface_test", 1, [])
    for path, body in (("/interface-tests", START), ("/calibration/steps/rest/start", None)):
        assert calibrated("POST", path, json=body).status_code == 409
    assert "two-minute test is running" in calibrated("POST", "/interface-tests", json=START).json()["detail"]

    calibrated.process.run_t = 3.1
    calibrated.until("/session", lambda _: picture(calibrated)["test"]["phase"] == "running")
    shown = picture(calibrated)["test"]
    assert sorted(abs(length) for length in shown["target"]) in ([0.0, 0.4], [0.0, 0.8])
    assert (shown["cursor"], shown["radius"], shown["acquired"], shown["missed"]) == ([0.0, 0.0], 0.1, 0, 0)
    calibrated.process.says = {"u1": 1.0}
    calibrated.process.run_t = 3.15
    calibrated.until("/session", lambda _: picture(calibrated)["test"]["cursor"][0] > 0.04)

    ended = calibrated.good("POST", "/interface-tests/current/end")
    assert (ended["status"], ended["end"], ended["measures"]) == ("done", "by hand", None)  # nothing was recorded here
    assert picture(calibrated)["test"] is None
    assert calibrated("POST", "/interface-tests/current/end").status_code == 409
    assert of_patient(calibrated)["course"] == {"counted": [], "curves": {}, "comparisons": []}
    rows = [row.what for row in calibrated.log()]
    assert [row for row in rows if row.startswith("test ")] == ["test started", "test ended"]
    assert "patient viewed" in rows


def test_stop_ends_a_test_and_a_stop_in_force_refuses_one(calibrated: Any) -> None:
    calibrated.good("POST", "/interface-tests", json=START)
    calibrated.good("POST", "/control/stop")
    found = calibrated.until(f"/interface-tests?patient={calibrated.patient['id']}", lambda a: a["tests"][0]["end"])
    assert found["tests"][0]["end"] == "stopped"
    calibrated.process.state = State.FAULT  # a latched stop outlives the run
    assert "take it back first" in calibrated.refused(409, "POST", "/interface-tests", json=START)


def test_a_complete_test_ends_by_itself(calibrated: Any) -> None:
    calibrated.good("POST", "/interface-tests", json=START)
    calibrated.process.run_t = 200.0
    found = calibrated.until(f"/interface-tests?patient={calibrated.patient['id']}", lambda a: a["tests"][0]["end"])
    assert (found["tests"][0]["end"], found["tests"][0]["number"]) == ("complete", 1)
    assert calibrated.process.run == 0


def test_the_course_is_of_complete_tests_of_one_task_and_one_kind_of_source(calibrated: Any) -> None:
    for number in range(9):
        add_done(calibrated, throughput=0.5 * (1.3 - math.exp(-number / 2)), acquisitions_per_minute=10.0 + number % 2)
    add_done(calibrated, end="stopped")
    add_done(calibrated, plan={"width": 0.3}, throughput=9.0)
    add_done(calibrated)
    found = of_patient(calibrated)
    assert [test["number"] for test in found["tests"]] == list(range(1, 13))
    assert found["source"] == "simulated"
    course = found["course"]
    assert course["counted"] == [*range(1, 10), 12]
    (before, first) = course["comparisons"]
    assert (before["earlier"], first["earlier"], before["later"]) == (9, 1, 12)
    assert before["verdicts"]["throughput"]["later"] == MEASURES["throughput"]
    assert before["verdicts"]["acquisitions_per_minute"]["word"] in {"within", "better", "worse"}
    other = calibrated.good("GET", f"/interface-tests?patient={calibrated.patient['id']}&source=worn")
    assert (other["source"], other["course"]["counted"], len(other["tests"])) == ("worn", [], 12)


def test_the_workload_is_six_answers_each_of_which_may_be_left_out(calibrated: Any) -> None:
    add_done(calibrated)
    where = "/interface-tests/1/workload"
    some = calibrated.good("PUT", where, json={"mental": 35, "effort": 60})
    assert (some["workload"]["mental"], some["workload"]["physical"], some["raw_tlx"]) == (35, None, None)
    names = ("mental", "physical", "temporal", "performance", "effort", "frustration")
    full = calibrated.good("PUT", where, json=dict(zip(names, (10, 20, 30, 40, 50, 60), strict=True)))
    assert full["raw_tlx"] == 35.0
    for wrong in (-1, 101, 50.5, True, "50", float("inf")):
        body = f'{{"mental": {wrong if not isinstance(wrong, str | bool) else repr(wrong).lower()}}}'
        answer = calibrated(
            "PUT", where, content=body.replace("inf", "1e999"), headers={"Content-Type": "application/json"}
        )
        assert answer.status_code == 422, wrong
    assert of_patient(calibrated)["tests"][0]["raw_tlx"] == 35.0
    assert calibrated.good("PUT", where, json={})["workload"] is None
    assert calibrated("PUT", "/interface-tests/99/workload", json={}).status_code == 404


def test_a_running_test_is_not_asked_about_and_a_signed_session_stays_as_it_is(calibrated: Any) -> None:
    calibrated.good("POST", "/interface-tests", json=START)
    assert calibrated("PUT", "/interface-tests/1/workload", json={"mental": 1}).status_code == 409
    session = calibrated.parts[SessionFlow].session_id
    assert calibrated("POST", f"/sessions/{session}/sign-off").status_code == 409
    calibrated.good("POST", "/interface-tests/current/end")
    calibrated.good("POST", f"/sessions/{session}/sign-off")
    assert "signed off" in calibrated.refused(409, "PUT", "/interface-tests/1/workload", json={"mental": 1})
    events = [event["kind"] for event in calibrated.good("GET", f"/sessions/{session}/story")["events"]]
    assert events.count("test") == 1
    assert events.count("calibration") == 1


def test_a_test_that_an_ended_program_left_is_closed(calibrated: Any) -> None:
    add_done(calibrated)
    with calibrated.database.transaction() as db:
        db.get_one(InterfaceTest, 1).status = "running"
        db.flush()
        close_interrupted_tests(db)
        left = db.get_one(InterfaceTest, 1)
        assert (left.status, left.end) == ("done", "fault")
        assert left.started < utc_now()


@pytest.mark.parametrize("shown", [True, False])
def test_who_may_not_see_the_patient_sees_no_test(calibrated: Any, shown: bool) -> None:
    calibrated.good("POST", "/interface-tests", json=START)
    now = calibrated.parts[ClinicLive]._picture()
    assert (now if shown else now.without_patient()).test is None or shown
    assert calibrated.parts[PatientPicture].picture().test.id == 1
