"""A clinic's real web application in a thread of this process, its control link answering without a process."""

import atexit
import socket
import threading
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any, Self

import uvicorn
from api.fake_process import FakeProcess
from fastapi import FastAPI
from processes.served_demo import SessionClient
from sqlalchemy.orm import Session

from app.api.app import create_app
from app.cli.port import bind
from app.cli.server import LAST_ANSWERS
from app.computing_process import ComputingProcess
from app.settings import Settings
from app.store.access.sign_ins import sign_in
from app.store.database import Database
from app.store.people import add_person, find_person, the_clinic


class SharedComputing(ComputingProcess):
    """A computing process that the end of one application leaves to the next: to load its libraries takes seconds."""

    def close(self) -> None:
        """Leave it running."""

    def end(self) -> None:
        """End it, with the process of the tests."""
        super().close()


CODE = "the-set-up-code-of-the-tests"
OWNER = {"code": CODE, "name": "Ada", "password": "correct horse battery"}
COMPUTING = SharedComputing()
atexit.register(COMPUTING.end)


@contextmanager
def stored(settings: Settings) -> Iterator[Session]:
    """Yield a transaction in a clinic's database, which is closed afterwards."""
    database = Database(settings.database)
    with database.transaction() as db:
        yield db
    database.close()


class ServedApp:
    """Serves an application in a thread of this process, from `start` to `stop`."""

    def __init__(self, app: FastAPI, listening: socket.socket, **options: Any) -> None:
        self.app, self._socket = app, listening
        config = uvicorn.Config(
            app, log_level="error", ws_per_message_deflate=False, timeout_graceful_shutdown=LAST_ANSWERS, **options
        )
        self._server = uvicorn.Server(config)
        self._thread = threading.Thread(target=self._server.run, args=([listening],), daemon=True)
        self.address = f"http://127.0.0.1:{listening.getsockname()[1]}"

    def __enter__(self) -> Self:
        self.start()
        return self

    def __exit__(self, *_: object) -> None:
        self.stop()

    def start(self) -> None:
        """Return when it serves."""
        self._thread.start()
        while not self._server.started:
            assert self._thread.is_alive(), "the application did not start: see its message above"
            time.sleep(0.02)

    def stop(self) -> None:
        """End it and wait for that."""
        self._server.should_exit = True
        self._thread.join(20)
        assert not self._thread.is_alive()
        self._socket.close()


class ServedClinic(ServedApp):
    """A clinic's application; `process` is the newest one that stands for the control process."""

    def __init__(self, settings: Settings, port: int = 0, stand_in: Callable[[], FakeProcess] = FakeProcess) -> None:
        self._processes: list[FakeProcess] = []

        async def start_process() -> FakeProcess:
            self._processes.append(stand_in())
            return self._processes[-1]

        super().__init__(create_app(settings, start_process, COMPUTING), bind("127.0.0.1", port))
        self._settings = settings

    @property
    def process(self) -> FakeProcess:
        """Return what answers as the control process."""
        return self._processes[-1]

    def sign_in_as(self, name: str, role: str = "") -> str:
        """Sign somebody in, who is added when a role is given; return what the cookie holds."""
        with self.app.state.parts[Database].transaction() as db:
            clinic = the_clinic(db)
            assert clinic is not None
            person = add_person(db, clinic, name, role, None) if role else find_person(db, name)
            assert person is not None
            return sign_in(db, person, "test")


class OwnedClinic(ServedClinic):
    """A clinic whose owner has set it up, and has a browser (`client`)."""

    def __init__(self, settings: Settings, stand_in: Callable[[], FakeProcess] = FakeProcess) -> None:
        super().__init__(settings, stand_in=stand_in)
        self.client = SessionClient(self.address)

    def start(self) -> None:
        """Return when it serves and its owner is signed in."""
        super().start()
        self.good("POST", "/auth/setup", OWNER)

    def stop(self) -> None:
        """End it and wait for that."""
        self.client.close()
        super().stop()

    def good(self, method: str, path: str, body: Any = None) -> Any:
        """Send a request that must be answered well, from the owner's own browser."""
        answer = self.client.request(method, path, json=body)
        assert answer.is_success, (path, answer.text)
        return answer.json() if answer.content else None

    def be_here(self, patient: int = 1) -> None:
        """Open a patient's session in the owner's own browser."""
        now = self.good("GET", "/session")["session"]
        self.good("POST", "/session", {"patient_id": patient, "ends": now and now["id"]})
