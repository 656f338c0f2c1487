"""A clinic's real web application in a thread of this process, its control link answering without a process."""

import atexit
import threading
import time
from collections.abc import Callable

import uvicorn
from api.fake_process import FakeProcess

from app.api.app import create_app
from app.cli.port import bind
from app.cli.server import LAST_ANSWERS
from app.computing_process import ComputingProcess
from app.settings import Settings


class SharedComputing(ComputingProcess):
    """A computing process that the end of one application leaves to the next: to load its libraries takes seconds."""

    def close(self) -> None:
        """Leave it running."""

    def end(self) -> None:
        """End it, with the process of the tests."""
        super().close()


COMPUTING = SharedComputing()
atexit.register(COMPUTING.end)


class ServedClinic:
    """Serves from `start` to `stop`; `process` is the newest one that stands for the control process."""

    def __init__(self, settings: Settings, port: int = 0, stand_in: Callable[[], FakeProcess] = FakeProcess) -> None:
        self._processes: list[FakeProcess] = []

        async def start_process() -> FakeProcess:
            self._processes.append(stand_in())
            return self._processes[-1]

        self._socket = bind("127.0.0.1", port)
        self.app = create_app(settings, start_process, COMPUTING)
        config = uvicorn.Config(
            self.app, log_level="error", ws_per_message_deflate=False, timeout_graceful_shutdown=LAST_ANSWERS
        )
        self._server = uvicorn.Server(config)
        self._thread = threading.Thread(target=self._server.run, args=([self._socket],), daemon=True)
        self.address = f"http://127.0.0.1:{self._socket.getsockname()[1]}"

    @property
    def process(self) -> FakeProcess:
        """Return what answers as the control process."""
        return self._processes[-1]

    def start(self) -> None:
        """Return when it serves."""
        self._thread.start()
        while not self._server.started:
            assert self._thread.is_alive()
            time.sleep(0.02)

    def stop(self) -> None:
        """End it and wait for that."""
        self._server.should_exit = True
        self._thread.join(20)
        assert not self._thread.is_alive()
