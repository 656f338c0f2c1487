"""The tablet is lost, or its page is loaded again, in the middle of a calibration step: the step goes on."""

from contextlib import ExitStack
from typing import Any

from api.fake_clinic import Clinic

from app.store.tables import Run


def run_of_picture(clinic: Clinic) -> Any:
    with clinic.socket("/live") as socket:
        return socket.receive_json()["run"]


def begin_in_the_middle(clinic: Clinic) -> Any:
    """Do the first step, begin the second one, and stand 3 s into it."""
    clinic.begin_session()
    clinic.record("rest")
    clinic.good("POST", "/calibration/steps/free/start")
    clinic.process.run_t = 3.0
    return clinic.good("GET", "/calibration")


def states(wizard: Any) -> list[str]:
    return [step["status"] for step in wizard["steps"]]


def runs(clinic: Clinic) -> list[tuple[str, str]]:
    with clinic.database.transaction() as db:
        return [(run.id, run.kind) for run in db.query(Run).order_by(Run.started)]


def test_a_page_that_is_loaded_again_in_the_middle_of_a_step_is_in_the_middle_of_it(signed_in: Clinic) -> None:
    before = begin_in_the_middle(signed_in)
    assert (before["running"]["step"], before["current"]) == ("free", "free")
    kept = runs(signed_in)
    with signed_in.socket("/live") as socket:
        assert socket.receive_json()["run"] == {"kind": "free", "t": 3.0, "cue": None}
    signed_in.good("GET", "/start")
    assert signed_in.good("GET", "/calibration") == before
    assert run_of_picture(signed_in) == {"kind": "free", "t": 3.0, "cue": None}
    assert states(signed_in.end_step())[:3] == ["done", "done", "waiting"]
    assert runs(signed_in) == kept  # both recordings, and none was begun again


def test_a_tablet_that_is_lost_in_the_middle_of_a_step_loses_nothing_and_another_one_goes_on(signed_in: Clinic) -> None:
    with ExitStack() as tablet:
        tablet.enter_context(signed_in.screen())
        live = tablet.enter_context(signed_in.socket("/live"))
        before = begin_in_the_middle(signed_in)
        live.receive_json()
    kept = runs(signed_in)
    with signed_in.as_person({}):  # the lost tablet's cookie is gone with it
        assert signed_in("GET", "/calibration").status_code == 401
        signed_in.good("POST", "/auth/demo", json={"code": "the-code-of-the-link"})
        assert signed_in.good("GET", "/calibration") == before
        assert run_of_picture(signed_in)["t"] == 3.0
        wizard = signed_in.end_step()
        assert states(wizard)[:3] == ["done", "done", "waiting"]
        assert wizard["current"] == wizard["steps"][2]["id"]
        assert runs(signed_in) == kept
        signed_in.good("POST", f"/calibration/steps/{wizard['current']}/start")
        assert states(signed_in.end_step())[:3] == ["done"] * 3


def test_a_sign_out_in_the_middle_of_a_step_does_not_end_it(signed_in: Clinic) -> None:
    begin_in_the_middle(signed_in)
    signed_in.good("POST", "/auth/sign-out")
    signed_in.good("POST", "/auth/demo", json={"code": "the-code-of-the-link"})
    assert signed_in.good("GET", "/calibration")["running"]["step"] == "free"
    assert states(signed_in.end_step())[:2] == ["done", "done"]
