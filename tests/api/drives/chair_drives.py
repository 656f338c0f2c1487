"""The steps of a clinician for a drive of the real chair."""

from typing import Any

from api.fake_clinic import WORD

from app.speeds import Speeds

SLOW = {**Speeds().model_dump(), "forward": 0.5}


def velocity(clinic: Any, **changed: Any) -> Any:
    now = clinic.good("GET", "/controls")["parameters"]
    names = ("gestures", "bindings", "mode_u1", "mode_u2", "cutoff", "speeds", "cruise_time", "title")
    wanted = {**{name: now[name] for name in names}, "mode_u1": "velocity", **changed}
    return clinic.good("PUT", "/controls", json=wanted)


def practise(clinic: Any) -> Any:
    clinic.good("POST", "/trials", json=clinic.where)
    return clinic.good("POST", "/trials/current/end", json={"reason": "by hand"})


def choose_chair(clinic: Any) -> Any:
    chair = {"name": "Blue", "host": "10.0.0.7", "port": 5354, "speeds": SLOW}
    chairs = clinic.good("POST", "/chairs", json=chair)["chairs"]
    return clinic.good("PUT", "/chairs/chosen", json={"id": chairs[-1]["id"], "dynamics": "unicycle"})


def arm(clinic: Any, **headers: str) -> Any:
    digest = clinic.good("GET", "/drives/summary")["parameters"]["hash"]
    return clinic("POST", "/drives", json={"hash": digest, "screen": WORD}, headers=headers)
