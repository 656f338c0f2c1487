"""Real chairs in the clinic that is looked at: paired, chosen, on the page that arms, and gone again."""

from typing import Any

from browser.eyes.eyes_clinic import EyesClinic
from browser.eyes.opening import at, filled, opened, shows, steps, tapped

paired_chair = steps(
    at("settings", "Pair a chair"),
    *(filled("Name", "Ward 3"), filled("Address", "127.0.0.1"), tapped("Make the key"), shows("img.qr")),
)


def one_chair(clinic: EyesClinic) -> int:
    """Return the id of a paired chair."""
    chairs = clinic.good("GET", "/chairs")["chairs"]
    if not chairs:
        clinic.good("POST", "/chairs", {"name": "Ward 3", "host": "127.0.0.1", "port": 5354, "speeds": {}})
        chairs = clinic.good("GET", "/chairs")["chairs"]
    return int(chairs[0]["id"])


def chair_page(page: Any, clinic: EyesClinic) -> None:
    clinic.good("PUT", "/chairs/chosen", {"id": one_chair(clinic), "dynamics": "unicycle"})
    opened("drive/chair")(page, clinic)
    shows(".at-rest:not(:empty)")(page, clinic)  # the first word on the body comes when it has settled


def no_chair(clinic: EyesClinic) -> None:
    """Choose the virtual chair, and unpair the others, so that another one may have the same name."""
    stored = clinic.good("GET", "/chairs")
    if stored["chosen"]:
        clinic.good("PUT", "/chairs/chosen", {"id": None, "dynamics": "unicycle"})
    for chair in stored["chairs"]:
        clinic.good("DELETE", f"/chairs/{chair['id']}")
