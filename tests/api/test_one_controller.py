"""A trial on the virtual chair has one controller too: others look and stop, and do not go on or end it."""

from api.fake_clinic import Clinic

from app.api.one_controller import ANOTHER


def test_only_who_started_a_trial_goes_on_and_ends_it_and_anybody_stops(calibrated: Clinic) -> None:
    calibrated.start_trial()
    with calibrated.as_person(calibrated.cookies_of("Other")):
        assert calibrated.good("POST", "/control/stop")["state"] == "fault"
        for path, body in (
            ("/control/clear", {"stops": 1}),
            ("/control/dial", {"share": 0.5}),
            ("/trials/current/end", {"reason": "by hand"}),
        ):
            assert calibrated.refused(409, "POST", path, json=body) == ANOTHER
    calibrated.good("POST", "/control/clear", json={"stops": 1})
    calibrated.end_trial()
