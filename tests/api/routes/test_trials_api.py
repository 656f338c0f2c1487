"""Trials over the API: start, live picture, end; Stop from anywhere."""

import time
from concurrent.futures import ThreadPoolExecutor, wait
from typing import Any

import anyio
import anyio.to_thread
import pytest
from api.fake_clinic import WHERE, Clinic, next_message
from clinic_rows import plan_at

from app.api.one_controller import ANOTHER
from app.session.trial import TrialFlow


def trial_of(clinic: Any, trial_id: int) -> Any:
    return clinic.until(f"/trials/{trial_id}", lambda t: t["status"] == "done")


def test_floor_plans_are_listed_with_their_paths(calibrated: Any) -> None:
    plans = calibrated.good("GET", "/floorplans")
    buildings = [plan for plan in plans if plan["scene"] is None]
    assert [plan["name"] for plan in buildings] == ["apartment", "clinic", "corridors"]
    assert all(plan["width"] > 5 and plan["height"] > 5 and plan["paths"][0]["length"] > 5 for plan in buildings)
    desert = [plan for plan in plans if plan["scene"] and plan["scene"]["name"] == "desert"]
    assert [plan["level"]["name"] for plan in desert] == ["easy", "medium", "hard"]
    assert calibrated.good("GET", "/floorplans/desert.hard")["ground"]["kind"] == "sand"
    assert calibrated("GET", "/floorplans/nowhere").status_code == 404


def test_bundled_places_are_shown_in_the_language_of_the_reader(calibrated: Any) -> None:
    plans = {plan["name"]: plan for plan in calibrated.good("GET", "/floorplans?language=de")}
    desert = plans["desert.hard"]
    assert (desert["title"], desert["scene"]["title"], desert["level"]["title"]) == ("Wüste, schwer", "Wüste", "Schwer")
    assert plans["apartment"]["paths"][1]["title"] == "Zum Schlafzimmer"
    drawn = calibrated.good("GET", "/floorplans/apartment?language=de")
    assert (drawn["rooms"][0]["label"], drawn["obstacles"][0]["label"]) == ("Wohnzimmer", "sofa")
    trial = calibrated.start_trial()
    assert trial["floorplan_title"] == "Apartment"
    shown = calibrated.good("GET", "/view/clinician/plan?language=es")
    assert shown["floorplan"]["paths"][1]["title"] == "Al dormitorio"
    with calibrated.socket("/live?language=es") as socket:
        moment = next_message(socket, lambda m: m.get("trial"))["trial"]
    assert (moment["title"], moment["instruction"][:15]) == ("Del sofá al cuarto de invitados", "Salga del salón")
    calibrated.end_trial()
    listed = calibrated.good("GET", f"/trials?patient={calibrated.patient['id']}&language=de")
    assert [one["floorplan_title"] for one in listed] == ["Wohnung"]
    assert calibrated.good("GET", f"/trials/{trial['id']}?language=es")["floorplan_title"] == "Vivienda"


def test_a_trial_ends_at_the_goal_and_is_measured(calibrated: Any) -> None:
    trial = calibrated.start_trial()
    assert (trial["status"], trial["number"], trial["measures"]) == ("running", 1, None)
    assert [do for do, _ in calibrated.process.calls[-3:]] == ["world", "run", "arm"]
    arm = calibrated.process.calls[-1][1]
    assert arm["hash"] == calibrated.good("GET", "/controls")["hash"]
    assert calibrated("POST", "/trials", json=WHERE).status_code == 409
    assert calibrated("PUT", "/equipment/unused", json={"channels": []}).status_code == 409

    trials = calibrated.parts[TrialFlow]
    line, s = trials.current.path.line, 0.0
    while (trial_now := trials.current) is not None:
        # The chair goes on once the watch has seen where it is.
        calibrated.process.pose = (*line.point_at(s), 0.0)
        if abs(trial_now.place.done - s) < 0.01:
            s = min(s + 1.0, line.length)
        time.sleep(0.001)
    done = trial_of(calibrated, trial["id"])
    assert (done["end"], done["measures"]["dist"], done["path_name"]) == ("goal", 12.0, trial["path"])
    assert done["trajectory"]["x"][0] == 0.0
    assert len(done["path"]) >= 2
    assert [t["number"] for t in calibrated.good("GET", f"/trials?patient={calibrated.patient['id']}")] == [1]


def test_by_hand_discard_keep_and_the_learning_page(calibrated: Any) -> None:
    for number in (1, 2):
        trial = calibrated.start_trial()
        ended = calibrated.end_trial()
        assert (ended["id"], ended["end"], ended["number"]) == (trial["id"], "by hand", number)
        assert calibrated.process.run == 0
    assert calibrated("POST", "/trials/current/end", json={"reason": "by hand"}).status_code == 409
    task = "floorplan=apartment&path=main"
    page = f"/patients/{calibrated.patient['id']}/learning?{task}"
    learning = calibrated.good("GET", page)
    assert [row["number"] for row in learning["trials"]] == [1, 2]
    assert learning["curves"]["dist"]["fit"] is None
    drawn = calibrated.good("GET", f"/patients/{calibrated.patient['id']}/trajectories?{task}")
    assert [line["number"] for line in drawn["trajectories"]] == [1, 2]
    assert len(drawn["path"]) >= 2
    assert calibrated("POST", f"/trials/{trial['id']}/discard", json={"reason": ""}).status_code == 422
    assert calibrated.good("POST", f"/trials/{trial['id']}/discard", json={"reason": "tired"})["kept"] is False
    assert [row["number"] for row in calibrated.good("GET", page)["trials"]] == [1]
    assert calibrated.good("POST", f"/trials/{trial['id']}/keep")["discard_reason"] is None
    assert calibrated("GET", "/trials/999").status_code == 404
    assert calibrated("GET", "/trials?patient=999").status_code == 404


def test_an_arming_that_is_refused_leaves_no_trial(calibrated: Any) -> None:
    calibrated.process.refuse["arm"] = "The parameters are other ones than those loaded: load them again."
    assert calibrated.refused(409, "POST", "/trials", json=WHERE) == calibrated.process.refuse["arm"]
    assert calibrated.good("GET", f"/trials?patient={calibrated.patient['id']}") == []
    assert calibrated.process.run == 0


def test_the_death_of_the_control_process_ends_the_trial_as_a_fault(calibrated: Any) -> None:
    trial = calibrated.start_trial()
    calibrated.process.die()
    assert trial_of(calibrated, trial["id"])["end"] == "fault"


def test_stop_is_for_anyone_and_twice_and_clear_is_not(calibrated: Any) -> None:
    calibrated.start_trial()
    token = calibrated.client.cookies["bodydrive_sign_in"]
    calibrated.client.cookies.clear()
    for _ in range(2):
        assert calibrated.good("POST", "/control/stop") == {"state": "fault", "fault": "stop_tablet"}
    assert calibrated.client.post("/api/v1/control/stop").status_code == 200
    evil = {"Origin": "http://evil.example"}
    assert calibrated.client.post("/api/v1/control/stop", headers=evil).status_code == 403
    assert calibrated("POST", "/control/clear", json={"stops": 3}).status_code == 401
    calibrated.client.cookies["bodydrive_sign_in"] = token
    assert calibrated("POST", "/control/clear", json={"stops": 2}).status_code == 409  # seen before the third one
    assert calibrated.good("POST", "/control/clear", json={"stops": 3}) == {"state": "armed", "fault": None}
    assert [do for do, _ in calibrated.process.calls].count("stop") == 3


def test_a_stop_says_whether_it_was_made_by_a_key_and_whatever_the_address_says_it_stops(calibrated: Any) -> None:
    for by, fault in (("key", "stop_key"), ("tablet", "stop_tablet"), ("picture", "stop_tablet"), ("", "stop_tablet")):
        assert calibrated.good("POST", f"/control/stop?by={by}") == {"state": "fault", "fault": fault}
    stops = [fields["by"] for do, fields in calibrated.process.calls if do == "stop"]
    assert stops == ["key", "tablet", "tablet", "tablet"]


def test_the_end_of_a_halted_trial_ends_the_stop_that_was_seen_and_no_other(calibrated: Any) -> None:
    calibrated.start_trial()
    calibrated.good("POST", "/control/stop")
    calibrated.good("POST", "/trials/current/end", json={"reason": "by hand", "stops": 1})
    assert calibrated.process.state.name == "DISARMED"
    # Within the run it would move the chair.
    assert [do for do, _ in calibrated.process.calls[-2:]] == ["end_run", "clear"]
    calibrated.start_trial()  # with one tap

    calibrated.good("POST", "/control/stop")
    calibrated.good("POST", "/control/stop")  # nobody has seen it when End is tapped
    calibrated.good("POST", "/trials/current/end", json={"reason": "by hand", "stops": 2})
    assert calibrated.process.state.name == "FAULT"
    assert "Take the stop back" in calibrated.refused(409, "POST", "/trials", json=WHERE)
    calibrated.good("POST", "/control/clear", json={"stops": 3})
    calibrated.start_trial()
    calibrated.good("POST", "/trials/current/end", json={"reason": "by hand", "stops": 3})  # nothing halted it
    assert calibrated("POST", "/trials/current/end", json={"reason": "by hand", "stops": -1}).status_code == 422


def test_stop_waits_for_no_thread(calibrated: Any) -> None:
    """Stop must not wait for a thread: all may hang in a slow file or a locked database."""
    calibrated.start_trial()
    hanging = [object() for _ in range(200)]

    async def take_all_threads() -> None:
        limiter = anyio.to_thread.current_default_thread_limiter()
        for borrower in hanging[: int(limiter.available_tokens)]:
            limiter.acquire_on_behalf_of_nowait(borrower)

    async def give_them_back() -> None:
        limiter = anyio.to_thread.current_default_thread_limiter()
        for borrower in list(limiter.statistics().borrowers):
            if borrower in hanging:
                limiter.release_on_behalf_of(borrower)

    calibrated.client.portal.call(take_all_threads)
    with ThreadPoolExecutor(1) as another:
        stopping = another.submit(calibrated, "POST", "/control/stop")
        done, _ = wait([stopping], timeout=5.0)
        calibrated.client.portal.call(give_them_back)
        assert done, "Stop waited for a thread"
        assert stopping.result().status_code == 200


def test_stop_answers_even_when_nothing_is_left_to_stop(calibrated: Any) -> None:
    calibrated.process.die()
    assert calibrated.good("POST", "/control/stop") == {"state": "fault", "fault": "control_lost"}


def test_a_path_that_does_not_exist_starts_nothing(calibrated: Any) -> None:
    for where, status in (({"path": "nowhere"}, 404), ({"floorplan": "nowhere"}, 404), ({"floorplan": "../../x"}, 422)):
        assert calibrated("POST", "/trials", json={**WHERE, **where}).status_code == status
    assert "run" not in [do for do, _ in calibrated.process.calls[-2:]]


def test_the_next_task_is_the_first_one_and_then_the_last_one(calibrated: Any) -> None:
    next_task = f"/patients/{calibrated.patient['id']}/next-task"
    assert calibrated.good("GET", next_task) == {"floorplan": "clinic", "path": "main", "reason": "first"}
    calibrated.drive_trial()
    assert calibrated.good("GET", next_task) == {"floorplan": "apartment", "path": "main", "reason": "again"}
    assert calibrated("GET", "/patients/99/next-task").status_code == 404


def test_only_who_started_a_trial_goes_on_and_ends_it_and_anybody_stops(calibrated: Clinic) -> None:
    calibrated.start_trial()
    with calibrated.as_person(calibrated.cookies_of("Other")):
        assert calibrated.good("POST", "/control/stop")["state"] == "fault"
        for path, body in (
            ("/control/clear", {"stops": 1}),
            ("/control/dial", {"share": 0.5}),
            ("/trials/current/end", {"reason": "by hand"}),
        ):
            assert calibrated.refused(409, "POST", path, json=body) == str(ANOTHER)
    calibrated.good("POST", "/control/clear", json={"stops": 1})
    calibrated.end_trial()


EVEN = (2.0, 2.1, 1.9, 2.0, 2.05, 1.95, 2.0, 2.1, 1.9, 2.0)  # m2 off the path


@pytest.mark.parametrize(
    ("newest", "expected"), [(2.0, ("door.medium", "next level")), (9.0, ("door.easy", "again"))], ids=["even", "worse"]
)
def test_the_next_level_waits_while_a_trial_is_worse_than_noise(signed_in: Any, newest: float, expected: Any) -> None:
    good = {"time": 60.0, "path_length": 5.0, "reached": True, "collisions": 0}
    with signed_in.rows() as rows:
        patient = rows.patient()
        rows.course(patient, plan_at("door.easy"), [[{**good, "e_diff": area} for area in (*EVEN, newest)]])
    found = signed_in.good("GET", f"/patients/{patient.id}/next-task", params={"source": "simulated"})
    assert (found["floorplan"], found["reason"]) == expected
