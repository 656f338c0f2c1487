"""A real clinic's program that ends and begins again at the same address, with a session that is open."""

import signal
from pathlib import Path
from typing import Self

from processes.served_demo import OWNER, SessionClient, bodydrive, free_port, printed_link


class RestartedClinic:
    """A program; it runs from `begin` to `end`."""

    def __init__(self, state: Path) -> None:
        self._words = ("serve", "--port", str(free_port()), "--state", str(state))
        self.base, self._code = self.begin().split("/#setup=")

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        if self._process.returncode is None:
            self.end()

    def begin(self) -> str:
        """Start the program; return the link that it prints."""
        self._process = bodydrive(*self._words)
        return printed_link(self._process)

    def end(self) -> None:
        """End the program, as somebody does who shuts the machine down."""
        self._process.send_signal(signal.SIGTERM)
        self._process.communicate(timeout=60)

    def link_of_a_screen(self) -> str:
        """Set the clinic up and open a patient's session; return the link that pairs a screen with it."""
        with SessionClient(self.base) as client:
            client.post("/auth/setup", json={"code": self._code, **OWNER})
            patient_id = client.post("/patients", json={"code": "P-1", "pseudonym": "Heron"}).json()["id"]
            assert client.post("/session", json={"patient_id": patient_id}).is_success
            return str(client.post("/patient-screen/pairing").json()["url"])
