"""The web server: from its start to its end by a signal."""

import asyncio
import logging
import signal
import socket
import ssl
import sys
from contextlib import AbstractContextManager, nullcontext, suppress
from functools import partial
from typing import Final, Literal

import typer
import uvicorn

from app.api.app import WebApp, create_app, prepare_routes, say_goodbye
from app.api.assembly import StartProcess
from app.api.failed_start import KeepsFailure
from app.api.nearby import parsed_address
from app.api.request_language import RequestLanguage
from app.api.tablet_page import TabletPage
from app.api.view.view_keeper import ServedScene
from app.cli.errors import InputError
from app.cli.host.connections import (
    ACCEPTED_AT_ONCE,
    WAITING,
    Connections,
    EncryptedListener,
    LimitedWebSocket,
    limited,
    most_connections,
)
from app.cli.host.event_loop import event_loop
from app.cli.host.lan import Lan
from app.cli.port import PING_LIMIT
from app.computing_process import ComputingProcess
from app.process.command_channel import LinkLost
from app.process.supervisor import ControlProcess, Launch
from app.realtime import collect_garbage, share_memory_areas
from app.refusals import Refusal
from app.settings import Settings
from app.texts import Text, text_of

LOG_LEVEL: Final = logging.WARNING  # what the log has from this level on goes to stderr
PING_EVERY = 2.0  # s
LAST_ANSWERS = 1  # s for requests under way when the program ends
GOODBYE = 0.5  # s for telling the open pages
HANDSHAKE = 10.0  # s for the beginning of a connection over https
TLS_END = 1.0  # s for its end, when the other side does not answer
FOLLOW_EVERY = 5.0  # s until a changed address of this machine is noticed


class WebServer(uvicorn.Server):
    """uvicorn on a socket that is bound already; ends in order on Ctrl-C and SIGTERM, without output of its own."""

    def __init__(
        self,
        app: WebApp,
        listening: socket.socket,
        message: str,
        lan: Lan | None = None,
        connections: Connections | None = None,
    ) -> None:
        self._kept = KeepsFailure(app)
        self._connections = connections or Connections(most_connections())  # of all its sockets together
        super().__init__(_config(self._kept, "on", self._connections))
        self._app = app
        self._listening = listening
        self._message = message
        self._lan = lan
        self._following: asyncio.Task[None] | None = None

    @property
    def failure(self) -> Exception | None:
        """Return what ended the start."""
        return self._kept.failure

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
        """Start, open the sockets for other machines, then print the address."""
        await super().startup(sockets)
        if self.started:
            self._listening.listen(WAITING)
            if self._lan is not None:
                await self._open(self.config, self._lan.https, self._lan.certificate.context)
                page = RequestLanguage(TabletPage(self._lan.service))
                await self._open(_config(page, "off", self._connections), self._lan.page, None)
                self._following = asyncio.create_task(self._follow(self._lan))
            typer.echo(self._message)
            prepare_routes(self._app)
            # Collecting all loaded objects would take 0.2 s, in which no Stop would be handled, so they are frozen.
            collect_garbage()

    def capture_signals(self) -> AbstractContextManager[None]:  # type: ignore[override]
        """Do nothing: this program handles the signals itself."""
        return nullcontext()

    async def _open(self, config: uvicorn.Config, sockets: list[socket.socket], tls: ssl.SSLContext | None) -> None:
        """Serve an application on further sockets, over https with `tls`; uvicorn itself opens one kind only."""
        if not config.loaded:
            config.load()
        loop = asyncio.get_running_loop()

        def protocol() -> asyncio.Protocol:
            connection: asyncio.Protocol = config.http_protocol_class(  # type: ignore[call-arg]
                config=config, server_state=self.server_state, app_state=self.lifespan.state, _loop=loop
            )
            return connection

        begin, end = (None, None) if tls is None else (HANDSHAKE, TLS_END)
        for opened in sockets:
            server = await loop.create_server(
                protocol,
                sock=opened if tls is None else EncryptedListener(opened, self._connections),
                ssl=tls,
                backlog=ACCEPTED_AT_ONCE,
                ssl_handshake_timeout=begin,
                ssl_shutdown_timeout=end,
            )
            opened.listen(WAITING)
            self.servers.append(server)

    async def _follow(self, lan: Lan) -> None:
        """Follow the machine's addresses as long as the program runs."""
        while True:
            await asyncio.sleep(FOLLOW_EVERY)
            try:
                lines = await asyncio.to_thread(lan.refresh)
            except Exception:  # the next refresh may succeed, and without one the certificate would end unnoticed
                logging.getLogger("bodydrive").exception("The machine's addresses could not be read.")
                continue
            if lines:
                typer.echo("\n".join(map(str, lines)))

    async def _leave(self) -> None:
        try:
            with suppress(TimeoutError):
                await asyncio.wait_for(say_goodbye(self._app), GOODBYE)
        finally:  # the program ends, also when the pages could not be informed
            self.should_exit = True


def _config(
    app: KeepsFailure | RequestLanguage, lifespan: Literal["on", "off"], connections: Connections
) -> uvicorn.Config:
    return uvicorn.Config(
        app,
        http=limited(connections),
        ws=LimitedWebSocket,
        backlog=ACCEPTED_AT_ONCE,
        interface="asgi3",
        log_config=None,
        access_log=False,
        server_header=False,
        proxy_headers=False,  # the client is the connected address, never one in a header
        lifespan=lifespan,
        ws_per_message_deflate=False,
        ws_ping_interval=PING_EVERY,
        ws_ping_timeout=PING_LIMIT,
        timeout_graceful_shutdown=LAST_ANSWERS,
    )


def run_clinic(
    settings: Settings, launch: Launch, listening: socket.socket, message: str, lan: Lan | None = None
) -> None:
    """Serve until a signal, and print `message` after the start; refuse in one sentence when it cannot start.

    `launch` is the first control process; where one is lost, another is started.
    """
    share_memory_areas()
    logging.basicConfig(level=LOG_LEVEL, format="bodydrive: %(message)s", stream=sys.stderr)
    # These log connections of browsers only; errors of this program go to the logger "bodydrive".
    for name in ("uvicorn", "uvicorn.error", "websockets", "asyncio"):
        logging.getLogger(name).setLevel(logging.CRITICAL)
    settings.runs.mkdir(parents=True, exist_ok=True)
    scene = partial(ServedScene, models=settings.models)
    app = create_app(settings, _starts(launch), ComputingProcess(), scene)
    server = WebServer(app, listening, message, lan, _connections(settings))
    with asyncio.Runner(loop_factory=event_loop) as runner:
        has_started = runner.run(server.run_until_signal())
    if not has_started:
        raise InputError(why_not_started(server.failure))


def _connections(settings: Settings) -> Connections:
    """Return the limits of connections; the address of a proxy stands for everybody behind it."""
    proxy = settings.proxy

    def is_shared(address: str) -> bool:
        sender = parsed_address(address)
        return proxy is not None and sender is not None and sender in proxy

    return Connections(most_connections(), is_shared)


def _starts(launch: Launch) -> StartProcess:
    """Return what starts a control process: the first time it waits for that of `launch`."""
    first = [launch]

    async def start() -> ControlProcess:
        return await (ControlProcess.after(first.pop()) if first else ControlProcess.start())

    return start


def why_not_started(failure: Exception | None) -> Text | str:
    """Return in a sentence why there is nothing to show."""
    if isinstance(failure, Refusal):
        return text_of(failure)
    if failure is None or isinstance(failure, LinkLost):  # the control process has written its own message
        return Text("cli-control-process-ended")
    return Text("cli-not-started", kind=type(failure).__name__, problem=failure)
