"""Simulated trials are marked in each answer, and never in one curve or warning with worn ones."""

import pytest
from api.fake_clinic import WHERE, Clinic
from api.running_app import running

from app.api.live.live_picture import ClinicLive
from app.api.patient_screen.patient_picture import PatientPicture
from app.settings import Settings
from app.store.tables import Run, Trial

SIMULATED = {"kind": "simulator", "seed": 1}
WORN = {"kind": "udp", "port": 0}
CAMERA = {"kind": "camera"}
WORDS = {
    "simulator": "Simulated shirt (simulated person), virtual chair: practice only",
    "udp": "Worn shirt, virtual chair",
}


@pytest.fixture
def patient(owned: Clinic) -> int:
    """Return the id of the patient whose session is open in a real clinic, and who has consented to recordings."""
    number: int = owned.begin_session()["id"]
    with owned.rows() as rows:
        rows.consent(number, "recording")
    return number


def test_a_real_clinic_begins_without_a_shirt_and_keeps_a_chosen_one(owned: Clinic, real_settings: Settings) -> None:
    equipment = owned.good("GET", "/equipment")
    assert (equipment["shirt"], equipment["simulated"], equipment["body"], equipment["layout"]) == (None,) * 4
    assert equipment["status"]["message"] == "No shirt yet: choose one on the Shirt page."
    assert {one["kind"]: one["simulated"] for one in owned.good("GET", "/equipment/shirts")}["simulator"] is True
    assert "shirt" not in [do for do, _ in owned.process.calls]
    assert owned.parts[ClinicLive]._picture().shirt.chosen is False
    owned.begin_session()
    assert owned("POST", "/calibration/steps/rest/start").status_code in {404, 409}
    owned.good("PUT", "/equipment/shirt", json=SIMULATED)
    token = owned.client.cookies["bodydrive_sign_in"]
    for again in running(real_settings):
        again.client.cookies["bodydrive_sign_in"] = token
        assert again.good("GET", "/equipment")["shirt"]["kind"] == "simulator"
        assert [do for do, _ in again.process.calls].count("shirt") == 1


def test_a_demonstration_begins_with_the_simulated_shirt(signed_in: Clinic) -> None:
    equipment = signed_in.good("GET", "/equipment")
    kinds = (equipment["shirt"]["kind"], equipment["body"]["kind"], equipment["simulated"])
    assert kinds == ("simulator", "person", True)


def test_anybody_may_ask_whether_a_page_is_to_be_marked(owned: Clinic) -> None:
    for config, kind in ((None, None), (SIMULATED, "simulator"), (WORN, None)):
        if config is not None:
            owned.good("PUT", "/equipment/shirt", json=config)
        assert owned.good("GET", "/equipment/practice") == {"kind": kind}
        assert owned.parts[ClinicLive]._picture().practice == owned.parts[PatientPicture].picture().practice == kind
    owned.client.cookies.clear()
    assert owned.good("GET", "/equipment/practice") == {"kind": None}


def test_trials_say_their_source_and_worn_and_simulated_ones_are_never_mixed(owned: Clinic, patient: int) -> None:
    made: dict[str, list[int]] = {}
    for config in (WORN, SIMULATED, WORN):
        kind = str(config["kind"])
        owned.good("PUT", "/equipment/shirt", json=config)
        if config is WORN and not made:
            owned.calibrate()
        trial = owned.drive_trial()
        made.setdefault(kind, []).append(trial["id"])
        assert trial["source"]["description"] == WORDS[kind]
        assert trial["source"]["simulated"] is (config is SIMULATED)
        assert owned.good("GET", f"/trials/{trial['id']}")["source"] == trial["source"]
    listed = owned.good("GET", f"/trials?patient={patient}")
    assert [one["source"]["simulated"] for one in listed] == [False, True, False]
    query = "floorplan=apartment&path=main"
    for page in ("learning", "quality"):
        for asked, source in (("", "worn"), ("&source=worn", "worn"), ("&source=simulated", "simulated")):
            found = owned.good("GET", f"/patients/{patient}/{page}?{query}{asked}")
            assert found["source"] == source
            if page == "learning":
                kind = "udp" if source == "worn" else "simulator"
                assert [row["id"] for row in found["trials"]] == made[kind]
                assert {row["source"] for row in found["trials"]} == {WORDS[kind]}
                assert found["others"] == ({"simulated": 1} if source == "worn" else {"worn": 2})
        assert owned.good("GET", f"/patients/{patient}/{page}?{query}&source=unknown")["trials"] == []
        assert owned("GET", f"/patients/{patient}/{page}?{query}&source=nonsense").status_code == 422
    # Practice with this very set: two worn trials, whatever was simulated in between.
    assert owned.good("GET", "/drives/summary")["practised"]["trials"] == 2
    assert owned.good("GET", "/adaptation")["practised"] == 2
    with owned.database.transaction() as db:
        runs = {trial.id: db.get_one(Run, trial.run_id).source.shirt for trial in db.query(Trial)}
    assert runs == {**dict.fromkeys(made["udp"], "udp"), **dict.fromkeys(made["simulator"], "simulator")}


@pytest.mark.usefixtures("patient")
def test_a_simulated_calibration_drives_no_worn_shirt_and_no_calibration_mixes_both(owned: Clinic) -> None:
    owned.good("PUT", "/equipment/shirt", json=SIMULATED)
    owned.calibrate()
    assert owned.process.parameters is not None
    owned.good("PUT", "/equipment/shirt", json=WORN)
    assert "calibration is one of a shirt that nobody wore" in owned.good("GET", "/controls")["obstacle"]["message"]
    assert owned.process.parameters is None
    assert "nobody wore" in owned.refused(409, "POST", "/trials", json=WHERE)
    owned.good("POST", "/calibration/steps/rest/start")  # again, in the worn shirt, the others being simulated
    result = owned.end_step()["steps"][-1]
    assert result["status"] == "failed"
    assert result["message"].startswith("Some steps were recorded in a shirt that nobody wears")


@pytest.mark.usefixtures("patient")
def test_a_calibration_whose_sensors_had_to_tremble_drives_none_that_may_stay_constant(owned: Clinic) -> None:
    """Safety S5: the page says so, as the control process does; such a calibration is from before `liveness`."""
    owned.good("PUT", "/equipment/shirt", json=CAMERA)
    owned.calibrate()
    assert owned.process.parameters is not None
    layout = owned.process.layout
    channels = tuple(channel.model_copy(update={"liveness": "arrival"}) for channel in layout.channels)
    owned.process.layout = layout.model_copy(update={"channels": channels})
    owned.good("PUT", "/equipment/shirt", json=CAMERA)
    assert "calibrated in another shirt" in owned.good("GET", "/controls")["obstacle"]["message"]
    assert owned.process.parameters is None


def test_what_a_camera_saw_is_in_no_curve_and_no_calibration_of_a_worn_shirt(owned: Clinic, patient: int) -> None:
    owned.good("PUT", "/equipment/shirt", json=CAMERA)
    owned.calibrate()
    trial = owned.drive_trial()
    assert (trial["source"]["group"], trial["source"]["description"]) == ("camera", "Camera, virtual chair")
    query = "floorplan=apartment&path=main"
    for asked, source, ids in (("", "camera", [trial["id"]]), ("&source=worn", "worn", [])):
        found = owned.good("GET", f"/patients/{patient}/learning?{query}{asked}")
        assert (found["source"], [row["id"] for row in found["trials"]]) == (source, ids)
    assert found["others"] == {"camera": 1}
    owned.good("PUT", "/equipment/shirt", json=WORN)
    assert "calibrated in another shirt" in owned.good("GET", "/controls")["obstacle"]["message"]
    assert owned.process.parameters is None
    assert owned.good("GET", "/adaptation")["practised"] == 0
    owned.good("POST", "/calibration/steps/rest/start")  # again, in the worn shirt
    result = owned.end_step()["steps"][-1]
    assert result["status"] == "failed"
    assert result["message"].startswith("Some steps were recorded with other sensors")
