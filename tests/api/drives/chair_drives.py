"""The steps of a clinician for a drive of the real chair."""

from typing import Any

from api.fake_clinic import WORD


def arm(clinic: Any, **headers: str) -> Any:
    digest = clinic.good("GET", "/drives/summary")["parameters"]["hash"]
    return clinic("POST", "/drives", json={"hash": digest, "screen": WORD}, headers=headers)
