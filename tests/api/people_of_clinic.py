"""People of a real clinic for a test: an owner, and others who were invited, each with cookies of their own."""

from typing import Any

from api.fake_clinic import Clinic

OWNER = {"code": "set-up-code", "name": "Ada", "password": "correct horse battery"}
PASSWORD = "a quiet blue heron"


def code_of(link: Any) -> str:
    return str(link["url"].partition("#invite=")[2])


def invited(clinic: Clinic, name: str, role: str, patients: list[int] | None = None) -> Any:
    """Invite somebody; return the link."""
    return clinic.good("POST", "/people", json={"name": name, "role": role, "patients": patients})


def accepted(clinic: Clinic, link: Any, password: str = PASSWORD) -> dict[str, str]:
    """Open a link in a browser of its own and choose a password; return the cookies of that browser."""
    with clinic.as_person({}):
        clinic.good("POST", "/auth/invitation/accept", json={"code": code_of(link), "password": password})
        return dict(clinic.client.cookies)
