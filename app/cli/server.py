"""The web server: its socket, its end by a signal, and the lock of the clinic's folder."""

import asyncio
import errno
import fcntl
import ipaddress
import signal
import socket
from collections.abc import Iterator
from contextlib import AbstractContextManager, contextmanager, nullcontext, suppress
from pathlib import Path

import typer
import uvicorn

from app.api.app import WebApp, say_goodbye
from app.cli.errors import InputError
from app.file_modes import OWNER_FOLDER, keep_new_files_private, restrict
from app.realtime import collect_garbage
from app.settings import IN_USE, Settings

PING_EVERY = 2.0  # s
# A browser that does not answer for so long has gone: a tablet asleep, a cable pulled. Busy browsers need some time;
# the live socket and the 3D view themselves disconnect, within 3 s, a browser that does not read.
PING_LIMIT = 20.0  # s
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


def bind(host: str, port: int) -> socket.socket:
    """Bind the port before anything else is made; refuse a port in use with a sentence."""
    no_address = f"'{host}' is no address of this machine: leave --host out, or give one of its own."
    try:
        if not host.strip():  # would mean every address of this machine
            raise UnicodeError
        family = socket.AF_INET6 if ":" in host else socket.AF_INET
        listening = socket.create_server((host, port), family=family, backlog=128)
    except OSError as error:
        if error.errno == errno.EADDRINUSE:
            raise InputError(
                f"Port {port} of {host} is busy: end the program that uses it, or choose another port with --port "
                f"(with make: PORT={port + 1 if port < 65_535 else 8080})."
            ) from error
        if error.errno == errno.EACCES:
            raise InputError(f"Port {port} is for the system: choose one above 1023 with --port.") from error
        raise InputError(no_address) from error
    except UnicodeError as error:
        raise InputError(no_address) from error
    # Without this, the connection of a machine that has vanished stays open for a quarter of an hour.
    if hasattr(socket, "TCP_USER_TIMEOUT"):
        listening.setsockopt(socket.IPPROTO_TCP, socket.TCP_USER_TIMEOUT, int(1000 * PING_LIMIT))
    return listening


def link_to(host: str, port: int) -> str:
    """Return the address to open in a browser on this machine."""
    with suppress(ValueError):
        if ipaddress.ip_address(host).is_unspecified:
            host = "127.0.0.1"
    return f"http://[{host}]:{port}/" if ":" in host else f"http://{host}:{port}/"


def keep_private(settings: Settings) -> list[str]:
    """Let only their owner read what is written from now on, and what is in the clinic's folder already.

    Return a sentence when others can read something still.
    """
    keep_new_files_private()
    readable = restrict(settings.state_paths)
    if not readable:
        return []
    return [
        f"Other people on this computer can read {len(readable)} files of the clinic, the first is {readable[0]}: "
        f"give them to this account, or move the clinic to a disk that keeps rights."
    ]


@contextmanager
def held(folder: Path) -> Iterator[None]:
    """Lock a clinic's folder, so that no second program writes to its database."""
    try:
        folder.mkdir(mode=OWNER_FOLDER, parents=True, exist_ok=True)
        file = (folder / IN_USE).open("w")
    except OSError as error:
        raise InputError(f"{folder} cannot be written: choose another folder with --state.") from error
    with file:
        try:
            fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except OSError as error:
            raise InputError(
                f"The clinic in {folder} is open already: end the other program, or choose another with --state."
            ) from error
        yield
