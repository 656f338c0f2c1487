"""A trial on the virtual chair has one controller too: others look and stop, and do not go on or end it."""

from api.fake_clinic import WORD, Clinic
from api.people_of_clinic import as_person
from store.known_people import known_clinic

from app.api.one_controller import ANOTHER
from app.store.access.sign_ins import sign_in
from app.store.people import add_person


def test_only_who_started_a_trial_goes_on_and_ends_it_and_anybody_stops(calibrated: Clinic) -> None:
    with calibrated.database.transaction() as db:
        other = sign_in(db, add_person(db, known_clinic(db), "Other", "clinician", None), "test")
    plan = calibrated.good("GET", "/floorplans/apartment")
    where = {"floorplan": plan["name"], "path": plan["paths"][0]["name"]}
    calibrated.good("POST", "/trials", json={**where, "screen": WORD})
    with as_person(calibrated, {"bodydrive_sign_in": other}):
        assert calibrated.good("POST", "/control/stop")["state"] == "fault"
        for path, body in (
            ("/control/clear", {"stops": 1}),
            ("/control/dial", {"share": 0.5}),
            ("/trials/current/end", {"reason": "by hand"}),
        ):
            answer = calibrated("POST", path, json=body)
            assert (answer.status_code, answer.json().get("detail")) == (409, ANOTHER), path
    calibrated.good("POST", "/control/clear", json={"stops": 1})
    calibrated.good("POST", "/trials/current/end", json={"reason": "by hand"})
