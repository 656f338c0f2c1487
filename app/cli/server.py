"""The web server: from its start to its end by a signal."""

import asyncio
import logging
import signal
import socket
import sys
from contextlib import AbstractContextManager, nullcontext, suppress
from functools import partial

import typer
import uvicorn

from app.api.app import WebApp, create_app, say_goodbye
from app.api.view.view_keeper import ServedScene
from app.cli.errors import InputError
from app.cli.port import PING_LIMIT
from app.computing_process import ComputingProcess
from app.process.supervisor import ControlProcess
from app.realtime import collect_garbage
from app.settings import Settings

PING_EVERY = 2.0  # s
LAST_ANSWERS = 1  # s for requests under way when the program ends
GOODBYE = 0.5  # s for telling the open pages


class WebServer(uvicorn.Server):
    """uvicorn on a socket that is bound already; ends in order on Ctrl-C and SIGTERM, without output of its own."""

    def __init__(self, app: WebApp, listening: socket.socket, words: str) -> None:
        super().__init__(
            uvicorn.Config(
                app,
                log_config=None,
                access_log=False,
                server_header=False,
                proxy_headers=False,  # the client is the connected address, never one in a header
                lifespan="on",
                ws_per_message_deflate=False,
                ws_ping_interval=PING_EVERY,
                ws_ping_timeout=PING_LIMIT,
                timeout_graceful_shutdown=LAST_ANSWERS,
            )
        )
        self._app = app
        self._listening = listening
        self._words = words

    async def run_until_signal(self) -> bool:
        """Serve until a signal; return whether the server had started."""
        loop = asyncio.get_running_loop()
        leaving: list[asyncio.Task[None]] = []

        def leave() -> None:
            if leaving:
                self.force_exit = True
            else:
                leaving.append(asyncio.create_task(self._leave()))

        for number in (signal.SIGINT, signal.SIGTERM):
            loop.add_signal_handler(number, leave)
        with suppress(SystemExit):  # raised by uvicorn when the application did not start
            await self.serve([self._listening])
        return self.started

    async def startup(self, sockets: list[socket.socket] | None = None) -> None:
        """Start, then print the address."""
        await super().startup(sockets)
        if self.started:
            # Collecting all loaded objects would take 0.2 s, in which no Stop would be handled, so they are frozen.
            collect_garbage()
            typer.echo(self._words)

    def capture_signals(self) -> AbstractContextManager[None]:  # type: ignore[override]
        """Do nothing: this program handles the signals itself."""
        return nullcontext()

    async def _leave(self) -> None:
        try:
            with suppress(TimeoutError):
                await asyncio.wait_for(say_goodbye(self._app), GOODBYE)
        finally:  # whether or not the pages could be told, the program ends
            self.should_exit = True


def run_clinic(settings: Settings, listening: socket.socket, words: str) -> None:
    """Serve until a signal, and print `words` after the start; refuse in one sentence when it cannot start."""
    logging.basicConfig(level=logging.WARNING, format="bodydrive: %(message)s", stream=sys.stderr)
    # These log connections of browsers only; errors of this program go to the logger "bodydrive".
    for name in ("uvicorn", "uvicorn.error", "websockets", "asyncio"):
        logging.getLogger(name).setLevel(logging.CRITICAL)
    settings.runs.mkdir(parents=True, exist_ok=True)
    scene = partial(ServedScene, models=settings.models)
    app = create_app(settings, ControlProcess.start, ComputingProcess(), scene)
    if not asyncio.run(WebServer(app, listening, words).run_until_signal()):
        raise InputError(
            "The control process did not start, so there is nothing to show: look at the messages above and try again."
        )
