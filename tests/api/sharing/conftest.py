"""A clinic with a driven trial, and people who read of it elsewhere."""

from typing import Any

import pytest
from fake_clinic import Clinic

from app.clock import utc_now
from app.store.people import add_person, find_person, sign_in, the_clinic


@pytest.fixture
def trial(calibrated: Clinic) -> int:
    """Drive one trial, and return its id."""
    plan = calibrated.good("GET", "/floorplans")[0]
    where = {"floorplan": plan["name"], "path": plan["paths"][0]["name"], "screen": "screen-of-the-test"}
    with calibrated.screen("screen-of-the-test"):
        calibrated.good("POST", "/trials", json=where)
        return int(calibrated.good("POST", "/trials/current/end", json={})["id"])


@pytest.fixture
def cookies_of(calibrated: Clinic) -> Any:
    """Return a function that signs somebody in, and returns the cookies."""
    database = calibrated.client.app.state.people.database  # type: ignore[attr-defined]

    def cookies(name: str, role: str, patients: list[int] | None = None) -> dict[str, str]:
        with database.transaction() as db:
            if find_person(db, name) is None:
                add_person(db, the_clinic(db), name, role, None, patients=patients)
            return {"bodydrive_sign_in": sign_in(db, find_person(db, name), "test")}

    return cookies


@pytest.fixture
def consented(calibrated: Clinic) -> Clinic:
    """A clinic whose patient has consented to sharing today."""
    path = f"/patients/{calibrated.patient['id']}/consents/sharing"
    calibrated.good("PUT", path, json={"given": utc_now().astimezone().date().isoformat()})
    return calibrated
