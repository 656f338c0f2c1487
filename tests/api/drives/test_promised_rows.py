"""Each kind of action that the log promises to hold is done once: its row has person, time and a place in the chain."""

from datetime import timedelta
from typing import Any

import pytest
from api.fake_clinic import arm

from app.clock import utc_now
from app.store import log

PROMISED = ("sign-in", "patient viewed", "report exported", "controls set", "armed", "stop requested")


def test_sign_in_view_export_change_arming_and_stop_are_in_the_log(
    calibrated: Any, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(log, "VIEWED_EVERY", timedelta(0))  # the clinician saw the patient just before
    began = utc_now()
    before = len(calibrated.log())
    me = calibrated.good("POST", "/auth/demo", json={"code": "the-code-of-the-link"})
    patient = calibrated.patient["id"]
    calibrated.good("GET", f"/patients/{patient}/sessions")
    assert calibrated("GET", f"/patients/{patient}/report?form=html&for_patient=true").status_code == 200
    calibrated.set_controls(cutoff=2.0)
    calibrated.drive_trial()
    calibrated.choose_chair(forward=0.5)
    with calibrated.screen():
        assert arm(calibrated).status_code == 201
        calibrated.good("POST", "/control/stop")
        calibrated.good("POST", "/drives/current/end")
    rows = calibrated.log()[before:]
    done = {row.what: row for row in rows}
    assert set(PROMISED) <= set(done)
    for what in PROMISED:
        assert done[what].person == me["name"], what
        assert began <= done[what].at <= utc_now() + timedelta(seconds=1), what
    check = calibrated.good("GET", "/log/check")
    assert check["whole"]
    # The live process writes rows of its own: some may come while the check runs, or after it.
    assert before + len(rows) <= check["rows"] <= len(calibrated.log())
