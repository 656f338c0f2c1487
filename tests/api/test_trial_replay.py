"""One trial's time line, as a page asks for it."""

from typing import Any

import pytest
from fake_clinic import WORD
from recorded_trial import record_trial

from building import make_parameters


@pytest.fixture
def driven(signed_in: Any) -> Any:
    """A clinic with one trial that is over, and its recording."""
    signed_in.visit()
    signed_in.calibrate()
    plan = signed_in.good("GET", "/floorplans/apartment")
    where = {"floorplan": plan["name"], "path": plan["paths"][0]["name"], "screen": WORD}
    with signed_in.screen():
        signed_in.trial = signed_in.good("POST", "/trials", json=where)
        run = signed_in.flows.drive.trial.run
        assert signed_in("GET", f"/trials/{signed_in.trial['id']}/timeline").status_code == 409
        signed_in.good("POST", "/trials/current/end", json={"reason": "by hand"})
    signed_in.folder = run.folder
    return signed_in


def test_a_time_line_is_answered_kept_and_logged(driven: Any) -> None:
    record_trial(driven.folder, make_parameters(n_channels=8))
    address = f"/trials/{driven.trial['id']}/timeline"
    line = driven.good("GET", address)
    assert len(line["t"]) == len(line["x"]) == len(line["gestures"][0]["activation"]) == 1200
    assert [event["kind"] for event in line["events"]][:2] == ["checking", "armed"]
    plain = driven("GET", address, headers={"Accept-Encoding": "identity"})
    assert "content-encoding" not in plain.headers
    assert plain.json() == line
    assert len([row for row in driven.log() if row.what == "trial viewed"]) == 3
    driven.client.cookies.clear()
    assert driven("GET", address).status_code == 401


def test_a_trial_without_a_recording_says_so(driven: Any) -> None:
    answer = driven("GET", f"/trials/{driven.trial['id']}/timeline")
    assert (answer.status_code, answer.json()["detail"]) == (
        404,
        "The recording of this trial cannot be read: restore it from a backup.",
    )
    assert driven("GET", "/trials/999/timeline").status_code == 404
