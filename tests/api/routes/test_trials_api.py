"""Trials over the API: start, live picture, end; Stop from anywhere."""

import time
from concurrent.futures import ThreadPoolExecutor, wait
from typing import Any

import anyio
import anyio.to_thread
import pytest
from api.fake_clinic import WORD

from app.session.trial import TrialFlow


@pytest.fixture
def ready(calibrated: Any) -> Any:
    plan = calibrated.good("GET", "/floorplans/apartment")
    calibrated.where = {"floorplan": plan["name"], "path": plan["paths"][0]["name"], "screen": WORD}
    calibrated.document = calibrated.good("GET", f"/floorplans/{plan['name']}")
    return calibrated


def trial_of(clinic: Any, trial_id: int) -> Any:
    return clinic.until(f"/trials/{trial_id}", lambda t: t["status"] == "done")


def test_floor_plans_are_listed_with_their_paths(ready: Any) -> None:
    plans = ready.good("GET", "/floorplans")
    buildings = [plan for plan in plans if plan["scene"] is None]
    assert [plan["name"] for plan in buildings] == ["apartment", "clinic", "corridors"]
    assert all(plan["width"] > 5 and plan["height"] > 5 and plan["paths"][0]["length"] > 5 for plan in buildings)
    desert = [plan for plan in plans if plan["scene"] and plan["scene"]["name"] == "desert"]
    assert [plan["level"]["name"] for plan in desert] == ["easy", "medium", "hard"]
    assert ready.good("GET", "/floorplans/desert.hard")["ground"]["kind"] == "sand"
    assert ready("GET", "/floorplans/nowhere").status_code == 404


def test_a_trial_ends_at_the_goal_and_is_measured(ready: Any) -> None:
    trial = ready.good("POST", "/trials", json=ready.where)
    assert (trial["status"], trial["number"], trial["measures"]) == ("running", 1, None)
    assert [do for do, _ in ready.process.calls[-3:]] == ["world", "run", "arm"]
    arm = ready.process.calls[-1][1]
    assert arm["hash"] == ready.good("GET", "/controls")["hash"]
    assert ready("POST", "/trials", json=ready.where).status_code == 409
    assert ready("PUT", "/equipment/unused", json={"channels": []}).status_code == 409

    trials = ready.parts[TrialFlow]
    line, s = trials.current.path.line, 0.0
    while (trial_now := trials.current) is not None:
        # The chair goes on once the watch has seen where it is.
        ready.process.pose = (*line.point_at(s), 0.0)
        if abs(trial_now.place.done - s) < 0.01:
            s = min(s + 1.0, line.length)
        time.sleep(0.001)
    done = trial_of(ready, trial["id"])
    assert (done["end"], done["measures"]["dist"], done["path_name"]) == ("goal", 12.0, trial["path"])
    assert done["trajectory"]["x"][0] == 0.0
    assert len(done["path"]) >= 2
    assert [t["number"] for t in ready.good("GET", f"/trials?patient={ready.patient['id']}")] == [1]


def test_by_hand_discard_keep_and_the_learning_page(ready: Any) -> None:
    for number in (1, 2):
        trial = ready.good("POST", "/trials", json=ready.where)
        ended = ready.good("POST", "/trials/current/end", json={"reason": "by hand"})
        assert (ended["id"], ended["end"], ended["number"]) == (trial["id"], "by hand", number)
        assert ready.process.run == 0
    assert ready("POST", "/trials/current/end", json={"reason": "by hand"}).status_code == 409
    task = f"floorplan={ready.where['floorplan']}&path={ready.where['path']}"
    page = f"/patients/{ready.patient['id']}/learning?{task}"
    learning = ready.good("GET", page)
    assert [row["number"] for row in learning["trials"]] == [1, 2]
    assert learning["curves"]["dist"]["fit"] is None
    drawn = ready.good("GET", f"/patients/{ready.patient['id']}/trajectories?{task}")
    assert [line["number"] for line in drawn["trajectories"]] == [1, 2]
    assert len(drawn["path"]) >= 2
    assert ready("POST", f"/trials/{trial['id']}/discard", json={"reason": ""}).status_code == 422
    assert ready.good("POST", f"/trials/{trial['id']}/discard", json={"reason": "tired"})["kept"] is False
    assert [row["number"] for row in ready.good("GET", page)["trials"]] == [1]
    assert ready.good("POST", f"/trials/{trial['id']}/keep")["discard_reason"] is None
    assert ready("GET", "/trials/999").status_code == 404
    assert ready("GET", "/trials?patient=999").status_code == 404


def test_an_arming_that_is_refused_leaves_no_trial(ready: Any) -> None:
    ready.process.refuse["arm"] = "The parameters are other ones than those loaded: load them again."
    answer = ready("POST", "/trials", json=ready.where)
    assert (answer.status_code, answer.json()["detail"]) == (409, ready.process.refuse["arm"])
    assert ready.good("GET", f"/trials?patient={ready.patient['id']}") == []
    assert ready.process.run == 0


def test_the_death_of_the_control_process_ends_the_trial_as_a_fault(ready: Any) -> None:
    trial = ready.good("POST", "/trials", json=ready.where)
    ready.process.die()
    assert trial_of(ready, trial["id"])["end"] == "fault"


def test_stop_is_for_anyone_and_twice_and_clear_is_not(ready: Any) -> None:
    ready.good("POST", "/trials", json=ready.where)
    token = ready.client.cookies["bodydrive_sign_in"]
    ready.client.cookies.clear()
    for _ in range(2):
        assert ready.good("POST", "/control/stop") == {"state": "fault", "fault": "stop_tablet"}
    assert ready.client.post("/api/v1/control/stop").status_code == 200
    foreign = ready.client.post("/api/v1/control/stop", headers={"Origin": "http://evil.example"})
    assert foreign.status_code == 403
    assert ready("POST", "/control/clear", json={"stops": 3}).status_code == 401
    ready.client.cookies["bodydrive_sign_in"] = token
    seen_before = ready("POST", "/control/clear", json={"stops": 2})
    assert seen_before.status_code == 409
    assert ready.good("POST", "/control/clear", json={"stops": 3}) == {"state": "armed", "fault": None}
    assert [do for do, _ in ready.process.calls].count("stop") == 3


def test_a_stop_says_whether_it_was_made_by_a_key_and_whatever_the_address_says_it_stops(ready: Any) -> None:
    for by, fault in (("key", "stop_key"), ("tablet", "stop_tablet"), ("picture", "stop_tablet"), ("", "stop_tablet")):
        assert ready.good("POST", f"/control/stop?by={by}") == {"state": "fault", "fault": fault}
    stops = [fields["by"] for do, fields in ready.process.calls if do == "stop"]
    assert stops == ["key", "tablet", "tablet", "tablet"]


def test_the_end_of_a_halted_trial_ends_the_stop_that_was_seen_and_no_other(ready: Any) -> None:
    ready.good("POST", "/trials", json=ready.where)
    ready.good("POST", "/control/stop")
    ready.good("POST", "/trials/current/end", json={"reason": "by hand", "stops": 1})
    assert ready.process.state.name == "DISARMED"
    assert [do for do, _ in ready.process.calls[-2:]] == ["end_run", "clear"]  # within the run it would move the chair
    ready.good("POST", "/trials", json=ready.where)  # with one tap

    ready.good("POST", "/control/stop")
    ready.good("POST", "/control/stop")  # nobody has seen it when End is tapped
    ready.good("POST", "/trials/current/end", json={"reason": "by hand", "stops": 2})
    assert ready.process.state.name == "FAULT"
    held = ready("POST", "/trials", json=ready.where)
    assert (held.status_code, "Take the stop back" in held.json()["detail"]) == (409, True)
    ready.good("POST", "/control/clear", json={"stops": 3})
    ready.good("POST", "/trials", json=ready.where)
    ready.good("POST", "/trials/current/end", json={"reason": "by hand", "stops": 3})  # nothing halted it
    assert ready("POST", "/trials/current/end", json={"reason": "by hand", "stops": -1}).status_code == 422


def test_stop_waits_for_no_thread(ready: Any) -> None:
    """Stop must not wait for a thread: all may hang in a slow file or a locked database."""
    ready.good("POST", "/trials", json=ready.where)
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

    ready.client.portal.call(take_all_threads)
    with ThreadPoolExecutor(1) as another:
        stopping = another.submit(ready, "POST", "/control/stop")
        done, _ = wait([stopping], timeout=5.0)
        ready.client.portal.call(give_them_back)
        assert done, "Stop waited for a thread"
        assert stopping.result().status_code == 200


def test_stop_answers_even_when_nothing_is_left_to_stop(ready: Any) -> None:
    ready.process.die()
    assert ready.good("POST", "/control/stop") == {"state": "fault", "fault": "control_lost"}


def test_a_path_that_does_not_exist_starts_nothing(ready: Any) -> None:
    assert ready("POST", "/trials", json={**ready.where, "path": "nowhere"}).status_code == 404
    assert ready("POST", "/trials", json={**ready.where, "floorplan": "nowhere"}).status_code == 404
    assert ready("POST", "/trials", json={**ready.where, "floorplan": "../../x"}).status_code == 422
    assert "run" not in [do for do, _ in ready.process.calls[-2:]]


def test_the_next_task_is_the_first_one_and_then_the_last_one(ready: Any) -> None:
    next_task = f"/patients/{ready.patient['id']}/next-task"
    assert ready.good("GET", next_task) == {"floorplan": "clinic", "path": "main", "reason": "first"}
    ready.good("POST", "/trials", json=ready.where)
    ready.good("POST", "/trials/current/end", json={"reason": "by hand"})
    again = {"floorplan": ready.where["floorplan"], "path": ready.where["path"], "reason": "again"}
    assert ready.good("GET", next_task) == again
    assert ready("GET", "/patients/99/next-task").status_code == 404
