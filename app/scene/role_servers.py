"""The 3D servers of a session, one for each role, reachable from this machine only."""

import asyncio
import threading
from asyncio import AbstractEventLoop
from types import TracebackType
from typing import Final, Literal, Self, get_args

import rich
import viser
from viser import _messages as wire
from viser.infra import _infra
from viser.infra._async_message_buffer import AsyncMessageBuffer

from app.scene.bridge_secret import guard_viser, require_guarded

Role = Literal["clinician", "patient"]
ROLES: Final[tuple[Role, ...]] = get_args(Role)


class LoopEvent(asyncio.Event):
    """An event that is set in the thread that made it, which runs the event loop; elsewhere it stays as it is.

    viser asks the loop to set it after each message and at the end of each atomic block, so that nobody waits longer.
    """

    def __init__(self) -> None:
        super().__init__()
        self._loop_thread = threading.get_ident()

    def set(self) -> None:
        """Wake who waits, when called in the thread of the event loop."""
        if threading.get_ident() == self._loop_thread:
            super().set()


class LoopBuffer(AsyncMessageBuffer):
    """A buffer of messages to pages, which any thread may fill while pages come and go.

    viser 1.1.1 wakes whoever waits for a message in the thread that draws, while the server's own thread may change the
    list of those who wait. Then the drawing thread ended ("deque mutated during iteration"), and the picture stood
    still. Here the event loop of the server alone wakes them.
    """

    def __init__(self, event_loop: AbstractEventLoop, persistent_messages: bool) -> None:
        super().__init__(event_loop, persistent_messages, message_event=LoopEvent())


def use_loop_buffers() -> None:
    """Give these buffers to every server that viser opens from now on, and to its pages."""
    # viser has no hook for them, but makes them by this name.
    _infra.AsyncMessageBuffer = LoopBuffer  # type: ignore[assignment, attr-defined]


class RoleServers:
    """The 3D servers of one session, made anew for each session: a server keeps every message that it ever sent.

    Raises
    ------
    OSError
        When this machine has no port left for them.
    """

    def __init__(self) -> None:
        self._servers: dict[Role, viser.ViserServer] = {}
        try:
            for role in ROLES:
                self._servers[role] = quiet_server()
        except BaseException:
            self.stop()
            raise

    def __getitem__(self, role: Role) -> viser.ViserServer:
        """Return the server of a role."""
        return self._servers[role]

    def port(self, role: Role) -> int:
        """Return the port (on 127.0.0.1) that the server of a role listens on."""
        return self._servers[role].get_port()

    def stop(self) -> None:
        """End the servers and their threads; a second call does nothing."""
        while self._servers:
            _, server = self._servers.popitem()
            server.stop()

    def __enter__(self) -> Self:
        return self

    def __exit__(self, kind: type[BaseException] | None, error: BaseException | None, at: TracebackType | None) -> None:
        self.stop()


def quiet_server() -> viser.ViserServer:
    """Return a 3D server for the bridge on this machine, which prints nothing; the caller stops it.

    Raises
    ------
    OSError
        When there is no port left.
    """
    # viser prints a banner and a farewell even with verbose=False; standard output belongs to the caller.
    rich.get_console().quiet = True
    guard_viser()
    use_loop_buffers()
    server = viser.ViserServer(host="127.0.0.1", port=0, verbose=False)
    require_guarded(server)
    # These two messages would open a public tunnel without a sign-in.
    for message in (wire.ShareUrlRequest, wire.ShareUrlDisconnect):
        server._websock_server.unregister_handler(message)  # noqa: SLF001
    server.gui.configure_theme(show_logo=False, show_share_button=False)
    server.scene.configure_default_lights(enabled=False)
    server.scene.configure_environment_map(None)
    return server
