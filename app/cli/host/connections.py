"""Limits of the connections to the pages, so that the descriptors of this process are never used up.

Without them a thousand silent connections leave no descriptor for a new one, and nobody who is not connected already
can stop the chair. A connection that does nothing gives way to a new one; Stop is always such a new one.
"""

import asyncio
import os
import resource
import socket
from collections import deque
from collections.abc import Callable
from contextlib import suppress
from typing import Any, Protocol

from h11 import Request
from uvicorn.config import Config
from uvicorn.protocols.http.h11_impl import H11Protocol
from uvicorn.protocols.websockets.websockets_sansio_impl import WebSocketsSansIOProtocol

from app.api.sockets import CUT_OFF

RESERVE = 200  # descriptors that are no connection of a page: database, recordings, other processes, uploads
EACH = 2  # descriptors for each connection: a websocket of the 3D view needs further ones
MOST = 4096  # connections in all, however many descriptors there are
SHARE = 0.75  # of all connections: the most of one address
HANDSHAKES = 0.25  # of all connections: the most that may be in their TLS handshake
REQUEST = 10.0  # s in which a connection has to send a request, from its beginning or from the request's first byte
SEND_BUFFER = 131_072  # bytes that wait in the kernel for a websocket: of a page that reads too slowly it is full soon
ACCEPTED_AT_ONCE = 16  # new connections in one turn of the event loop, before the limits see them
WAITING = 1024  # new connections that wait in the kernel for their turn
NEXT_WEBSOCKET = 0.01  # s from the opening of one websocket to that of the next, which takes about 3 ms of work


class Connection(Protocol):
    """An open connection of a browser."""

    transport: asyncio.Transport

    @property
    def is_idle(self) -> bool:
        """Whether no request is under way and no websocket is open."""
        ...

    @property
    def is_awaited(self) -> bool:
        """Whether the rest of a request is awaited."""
        ...


def most_connections() -> int:
    """Return how many connections the descriptors of this process allow."""
    soft, _ = resource.getrlimit(resource.RLIMIT_NOFILE)
    return MOST if soft == resource.RLIM_INFINITY else max(EACH, min(MOST, (soft - RESERVE) // EACH))


class Connections:
    """All open connections, in the order in which they were opened or last did something.

    Parameters
    ----------
    most : int
        Connections in all.
    is_shared : function
        Whether an address stands for many people, as that of a reverse proxy: only the limit of all holds for it.
    """

    def __init__(self, most: int, is_shared: Callable[[str], bool] = lambda _address: False) -> None:
        self._most = most
        self._most_of_one = max(1, int(SHARE * most))
        self._is_shared = is_shared
        self._open: dict[str, dict[Connection, None]] = {}  # address: its connections, the least recent first
        self._count = 0
        self._handshakes: dict[int, socket.socket] = {}  # descriptor: a connection that is not encrypted yet

    def __len__(self) -> int:
        return self._count

    def add(self, connection: Connection, address: str) -> bool:
        """Add a new connection, and close another where there are too many; False when none can be closed."""
        connections = self._open.get(address, {})
        if len(connections) >= self._most_of_one and not self._is_shared(address) and not self._make_room_of(address):
            return False
        if self._count >= self._most and not self._make_room():
            return False
        self._open.setdefault(address, {})[connection] = None
        self._count += 1
        return True

    def acted(self, connection: Connection, address: str) -> None:
        """Note that something came over a connection."""
        connections = self._open.get(address, {})
        if connection in connections:
            connections[connection] = connections.pop(connection)

    def remove(self, connection: Connection, address: str) -> None:
        """Forget a connection that is closed; one that was removed already does no harm."""
        connections = self._open.get(address, {})
        if connection in connections:
            del connections[connection]
            self._count -= 1
            if not connections:
                del self._open[address]

    def begin_handshake(self, accepted: socket.socket) -> None:
        """Note a connection that is not encrypted yet; end the oldest one where there are too many."""
        self._handshakes = {
            number: connection for number, connection in self._handshakes.items() if connection.fileno() == number
        }
        self._handshakes[accepted.fileno()] = accepted
        if len(self._handshakes) > max(1, int(HANDSHAKES * self._most)):
            oldest = next(iter(self._handshakes))
            with suppress(OSError):  # it has ended by itself
                self._handshakes.pop(oldest).shutdown(socket.SHUT_RDWR)

    def end_handshake(self, number: int) -> None:
        """Note that the connection with this descriptor is encrypted now, or needs no encryption."""
        self._handshakes.pop(number, None)

    def _make_room(self) -> bool:
        """Close a connection of the address that has most; of the next address when none of these can be closed."""
        by_number = sorted(self._open, key=lambda address: len(self._open[address]), reverse=True)
        return any(self._make_room_of(address) for address in by_number)

    def _make_room_of(self, address: str) -> bool:
        """Close the connection of an address that did nothing for longest; False when all of them are in use."""
        connections = self._open.get(address, {})
        yielding = next((connection for connection in connections if connection.is_idle), None) or next(
            (connection for connection in connections if connection.is_awaited), None
        )
        if yielding is None:
            return False
        self.remove(yielding, address)
        yielding.transport.abort()
        return True


class InTurn:
    """Calls functions one after another, at most one every NEXT_WEBSOCKET seconds.

    Two hundred websockets that are opened at once would take the event loop for longer than a Stop may wait.
    """

    def __init__(self) -> None:
        self._waiting: deque[Callable[[], None]] = deque()
        self._is_resting = False

    def call(self, function: Callable[[], None]) -> None:
        """Call a function: at once when none was called shortly before."""
        self._waiting.append(function)
        if not self._is_resting:
            self._next()

    def _next(self) -> None:
        self._is_resting = bool(self._waiting)
        if self._is_resting:
            asyncio.get_running_loop().call_later(NEXT_WEBSOCKET, self._next)
            self._waiting.popleft()()


class LimitedWebSocket(WebSocketsSansIOProtocol):
    """A websocket whose connection the application may end at once (`app.api.sockets.cut_off`)."""

    def connection_made(self, transport: asyncio.Transport) -> None:  # type: ignore[override]
        """Begin a websocket on an open connection."""
        super().connection_made(transport)
        transport.get_extra_info("socket").setsockopt(socket.SOL_SOCKET, socket.SO_SNDBUF, SEND_BUFFER)
        self.app_state = {**self.app_state, CUT_OFF: transport.abort}


class EncryptedListener(socket.socket):
    """Accepts connections over https; the limits see them before their handshake, which may take 10 s."""

    def __init__(self, opened: socket.socket, connections: Connections) -> None:
        super().__init__(fileno=os.dup(opened.fileno()))
        self._connections = connections

    def accept(self) -> tuple[socket.socket, Any]:
        """Accept a connection."""
        accepted, address = super().accept()
        self._connections.begin_handshake(accepted)
        return accepted, address


def limited(connections: Connections) -> type[H11Protocol]:
    """Return uvicorn's class for connections, with the limits."""
    websockets = InTurn()

    class LimitedConnection(H11Protocol):
        """A connection, closed when it sends no request, or when it has none and another one needs its place."""

        def __init__(self, config: Config, *arguments: Any, **options: Any) -> None:
            super().__init__(config, *arguments, **options)
            self._silence: asyncio.TimerHandle | None = None
            self._is_websocket = False

        @property
        def is_idle(self) -> bool:
            if self._is_websocket:
                return self.transport.is_closing()  # what it was sent is awaited by nobody any more
            return self.cycle is None or self.cycle.response_complete

        @property
        def is_awaited(self) -> bool:
            return not self._is_websocket and not self.is_idle and self.cycle.more_body

        def connection_made(self, transport: asyncio.Transport) -> None:  # type: ignore[override]
            super().connection_made(transport)
            connections.end_handshake(transport.get_extra_info("socket").fileno())
            if connections.add(self, self._address):
                self._await_request()
            else:
                transport.abort()

        def data_received(self, data: bytes) -> None:
            connections.acted(self, self._address)
            super().data_received(data)
            self._await_request()

        def handle_websocket_upgrade(self, event: Request) -> None:
            self._is_websocket = True
            self.transport.pause_reading()  # what follows the request is for the websocket
            websockets.call(lambda: self._become_websocket(event))

        def _become_websocket(self, event: Request) -> None:
            if self.transport.is_closing():
                return
            super().handle_websocket_upgrade(event)
            websocket = self.transport.get_protocol()
            lost = websocket.connection_lost

            def connection_lost(exc: Exception | None) -> None:
                self._end()
                lost(exc)

            websocket.connection_lost = connection_lost  # type: ignore[method-assign]
            self.transport.resume_reading()

        def connection_lost(self, exc: Exception | None) -> None:
            self._end()
            super().connection_lost(exc)

        @property
        def _address(self) -> str:
            return "" if self.client is None else self.client[0]

        def _await_request(self) -> None:
            """Give the other side REQUEST seconds for a whole request, however many pieces it sends of it."""
            if self._silence is None and self.is_idle:
                self._silence = self.loop.call_later(REQUEST, self._close_silent)
            elif self._silence is not None and not self.is_idle:
                self._silence.cancel()
                self._silence = None

        def _end(self) -> None:
            connections.remove(self, self._address)
            if self._silence is not None:
                self._silence.cancel()

        def _close_silent(self) -> None:
            if self.is_idle:
                self.transport.abort()

    return LimitedConnection
