"""The 3D servers of a session, one for each role, reachable from this machine only."""

from types import TracebackType
from typing import Final, Literal, Self, get_args

import rich
import viser
from viser import _messages as wire

from app.scene.bridge_secret import guard_viser, require_guarded
from app.scene.message_buffers import use_loop_buffers

Role = Literal["clinician", "patient"]
ROLES: Final[tuple[Role, ...]] = get_args(Role)


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
