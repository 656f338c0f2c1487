"""Consents at the API: entered, withdrawn, logged; a worn shirt records nothing before the consent to it."""

import pytest
from api.fake_clinic import Clinic

from app.session.equipment.shirt import Equipment


def given(clinic: Clinic, patient: int) -> dict[str, str | None]:
    found = clinic.good("GET", f"/patients/{patient}/consents")["consents"]
    return {one["consent"]: one["given"] for one in found}


def test_a_consent_is_entered_withdrawn_and_logged(calibrated: Clinic) -> None:
    patient = calibrated.patient["id"]
    path = f"/patients/{patient}/consents/sharing"
    assert given(calibrated, patient) == {"recording": None, "clinic_prior": None, "sharing": None}
    for _ in range(2):
        calibrated.good("PUT", path, json={"given": "2026-03-01"})
    assert given(calibrated, patient)["sharing"] == "2026-03-01"
    for _ in range(2):
        calibrated.good("DELETE", path)
    assert given(calibrated, patient)["sharing"] is None
    rows = [(one.what, one.details["consent"]) for one in calibrated.log() if one.what.startswith("consent")]
    assert rows == [("consent given", "sharing"), ("consent withdrawn", "sharing")]
    assert calibrated("PUT", path, json={"given": "2999-01-01"}).status_code == 409
    everything = path.replace("sharing", "everything")
    assert calibrated("PUT", everything, json={"given": "2026-03-01"}).status_code == 422


def test_a_worn_shirt_records_nothing_before_the_consent_and_practice_needs_none(
    in_session: Clinic, monkeypatch: pytest.MonkeyPatch
) -> None:
    patient = in_session.good("GET", "/session")["patient"]["id"]
    step = in_session.good("GET", "/calibration")["steps"][0]["id"]
    start, cancel = (f"/calibration/steps/{step}/{what}" for what in ("start", "cancel"))
    in_session.good("POST", start)  # with the simulated shirt
    in_session.good("POST", cancel)
    monkeypatch.setattr(type(in_session.parts[Equipment]), "simulated", False)
    assert not in_session.good("GET", "/session")["consents_to_recording"]
    runs = sum(do == "run" for do, _ in in_session.process.calls)
    assert "P-1 has not consented to recording" in in_session.refused(409, "POST", start)
    assert sum(do == "run" for do, _ in in_session.process.calls) == runs
    in_session.good("PUT", f"/patients/{patient}/consents/recording", json={"given": "2026-03-01"})
    assert in_session.good("GET", "/session")["consents_to_recording"]
    in_session.good("POST", start)
