"""A layout that the clinic has made, for what looks at its editor."""

from browser.eyes.eyes_clinic import LAYOUT, EyesClinic

NAME = "Ward 3"


def own_layout(clinic: EyesClinic) -> int:
    """Make a layout with the sensors of the shirt in use, in place of an earlier one; return its id."""
    for entry in clinic.good("GET", "/layouts")["own"]:
        clinic.good("DELETE", f"/layouts/{entry['id']}")
    document = LAYOUT.model_dump(mode="json") | {"name": NAME}
    (entry,) = clinic.good("POST", "/layouts", document)["own"]
    return int(entry["id"])
