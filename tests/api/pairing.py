"""Pairing a patient's screen, and what its browser keeps."""

from typing import Any

from api.fake_clinic import Clinic
from starlette.websockets import WebSocketDisconnect

COOKIES = ("bodydrive_sign_in", "bodydrive_screen")


def only(clinic: Clinic, cookie: str | None) -> None:
    """Delete all cookies of the browser but one."""
    for name in COOKIES:
        if name != cookie and name in clinic.client.cookies:
            clinic.client.cookies.delete(name)


def code_of(clinic: Clinic) -> str:
    return str(clinic.good("POST", "/patient-screen/pairing")["code"])


def pair(clinic: Clinic, code: str) -> Any:
    return clinic("POST", "/patient-screen/pair", json={"code": code})


def closing(socket: Any, most: int = 1000) -> int:
    """Return the code with which a socket is closed, after fewer than so many messages."""
    for _ in range(most):
        try:
            socket.receive_json()
        except WebSocketDisconnect as closed:
            return closed.code
    raise AssertionError("the socket was not closed")
