"""What people wrote about a patient is nowhere after the erasure, also not in the log; the log stays whole."""

from api.fake_clinic import Clinic
from store.keeping.filled_clinic import mentions

WORD = "Kestrel"
TOTAL = 41.625


def test_no_name_or_total_of_a_scale_and_no_reason_stays_in_the_log(calibrated: Clinic) -> None:
    settings = calibrated.settings
    session, patient = int(calibrated.session), calibrated.patient["id"]
    trial = calibrated.drive_trial()["id"]
    calibrated.good("POST", f"/trials/{trial}/discard", json={"reason": f"{WORD} was tired"})
    scale = {"name": f"{WORD} scale", "total": TOTAL, "day": "2026-01-01"}
    for _ in range(2):
        added = calibrated.good("POST", f"/sessions/{session}/scales", json=scale)["scales"][-1]["id"]
    calibrated.good("DELETE", f"/sessions/{session}/scales/{added}")
    calibrated.good("POST", f"/sessions/{session}/sign-off")
    calibrated.good("POST", f"/sessions/{session}/unlock", json={"reason": f"{WORD}'s wrong scale"})
    calibrated.good("DELETE", f"/patients/{patient}", json={"reason": f"{WORD} moved away"})
    calibrated.good("POST", f"/deleted-patients/{patient}/erasure")
    rows = {row.what: row.details for row in calibrated.log()}
    assert str(TOTAL) not in str(rows)
    assert list(mentions(settings.state, WORD)) == []
    assert rows["scale removed"]["scale"] == rows["scale added"]["scale"] == added
    assert rows["patient deleted"]["reason_given"]
    assert rows["patient erased"]["reason_given"]
    assert calibrated.good("GET", "/log/check")["whole"]
