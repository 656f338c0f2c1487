import asyncio
import resource
import socket
from contextlib import suppress
from types import SimpleNamespace

import pytest
from hypothesis import given
from hypothesis import strategies as st
from uvicorn.config import Config
from uvicorn.protocols.utils import ClientDisconnected
from uvicorn.server import ServerState

from app.api.sockets import cut_off
from app.cli.host import connections as module
from app.cli.host.connections import (
    MOST,
    RESERVE,
    SHARE,
    Connections,
    EncryptedListener,
    InTurn,
    LimitedWebSocket,
    limited,
    most_connections,
)
from event_loop import in_event_loop

MANY = 8


class One:
    """A connection that does what it is told."""

    def __init__(self, idle=True, awaited=False):
        self.is_idle, self.is_awaited, self.aborted = idle, awaited, False
        self.transport = SimpleNamespace(abort=self._abort)

    def _abort(self):
        self.aborted = True


@given(st.lists(st.tuples(st.sampled_from("abc"), st.booleans(), st.booleans()), max_size=60))
def test_there_are_never_more_than_the_limits_allow(wanted):
    kept, opened = Connections(MANY), []
    for address, idle, awaited in wanted:
        one = One(idle, awaited)
        before = sum(not other.aborted for _, other in opened)
        gives_way = any(not other.aborted and (other.is_idle or other.is_awaited) for _, other in opened)
        if kept.add(one, address):
            opened.append((address, one))
        else:
            assert not gives_way or before >= SHARE * MANY
        live = [(where, other) for where, other in opened if not other.aborted]
        assert len(kept) == len(live) <= MANY
        assert all(sum(where == name for where, _ in live) <= SHARE * MANY for name in "abc")
        assert all(other.is_idle or other.is_awaited for _, other in opened if other.aborted)


def test_of_those_that_do_nothing_the_one_goes_that_did_nothing_for_longest():
    kept = Connections(4)
    first, second, third = (One() for _ in range(3))
    for one in (first, second, third):
        assert kept.add(one, "a")
    kept.acted(first, "a")
    assert kept.add(One(), "a")
    assert (first.aborted, second.aborted, third.aborted) == (False, True, False)


def test_who_sends_a_body_slowly_gives_way_after_the_silent_and_who_is_served_never():
    kept = Connections(4)
    slow, silent, served = One(idle=False, awaited=True), One(), One(idle=False)
    for one in (slow, silent, served):
        assert kept.add(one, "a")
    assert kept.add(One(idle=False), "a")
    assert (slow.aborted, silent.aborted) == (False, True)
    assert kept.add(One(idle=False), "a")
    assert slow.aborted
    assert not kept.add(One(), "a")
    assert not served.aborted


def test_one_address_cannot_push_out_another_and_takes_no_more_than_its_share():
    kept = Connections(8)
    tablet = One()
    assert kept.add(tablet, "tablet")
    for _ in range(100):
        assert kept.add(One(), "a")
        assert kept.add(One(), "b")
    assert not tablet.aborted
    assert len(kept) == 8


def test_the_address_of_a_proxy_stands_for_many_people():
    kept = Connections(8, is_shared=lambda address: address == "proxy")
    assert all(kept.add(One(idle=False), "proxy") for _ in range(8))
    assert not kept.add(One(), "proxy")


@pytest.mark.parametrize(
    ("soft", "most"), [(1024, (1024 - RESERVE) // 2), (100, 2), (10**6, MOST), (resource.RLIM_INFINITY, MOST)]
)
def test_descriptors_are_left_for_everything_else(monkeypatch, soft, most):
    monkeypatch.setattr(resource, "getrlimit", lambda _what: (soft, soft))
    assert most_connections() == most


def test_handshakes_that_never_end_are_few():
    kept = Connections(8)
    with socket.create_server(("127.0.0.1", 0)) as opened, EncryptedListener(opened, kept) as listener:
        clients = [socket.create_connection(opened.getsockname(), timeout=10) for _ in range(3)]
        accepted = [listener.accept()[0] for _ in range(2)]
        kept.end_handshake(accepted[0].fileno())
        accepted += [listener.accept()[0]]
        clients += [socket.create_connection(opened.getsockname(), timeout=10)]
        accepted += [listener.accept()[0]]
        assert clients[1].recv(1) == b""  # ended: two others are not encrypted yet
        for number in (0, 2, 3):
            accepted[number].sendall(b"x")
            assert clients[number].recv(1) == b"x"
        for one in (*clients, *accepted):
            one.close()


async def answer(_scope, _receive, send):
    await send({"type": "http.response.start", "status": 204, "headers": []})
    await send({"type": "http.response.body", "body": b""})


async def served(exchange, app=answer, connections=None):
    """Serve with the limited classes, and return what `exchange` returns of a connection."""
    http = limited(Connections(4) if connections is None else connections)
    config = Config(app, http=http, ws=LimitedWebSocket, log_config=None, lifespan="off", ws_per_message_deflate=False)
    config.load()
    state, loop = ServerState(), asyncio.get_running_loop()
    server = await loop.create_server(lambda: http(config=config, server_state=state, app_state={}), "127.0.0.1", 0)
    reader, writer = await asyncio.open_connection(*server.sockets[0].getsockname())
    try:
        return await exchange(reader, writer)
    finally:
        writer.close()
        server.close()


@pytest.mark.parametrize("sent", [b"", b"GET / HT", b"GET / HTTP/1.1\r\nHost: a\r\n\r\nGET / HT"])
def test_who_sends_no_whole_request_is_closed(monkeypatch, sent):
    monkeypatch.setattr(module, "REQUEST", 0.05)

    async def exchange(reader, writer):
        writer.write(sent)
        return await reader.read()

    try:
        answered = asyncio.run(served(exchange))
    except ConnectionResetError:
        answered = b""
    assert answered.count(b"204") == sent.count(b"Host") or not answered


UPGRADE = (
    b"GET / HTTP/1.1\r\nHost: a\r\nUpgrade: websocket\r\nConnection: Upgrade\r\nSec-WebSocket-Version: 13\r\n"
    b"Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\n\r\n"
)


async def _send_for_ever(send):
    with suppress(ClientDisconnected):
        while True:
            await send({"type": "websocket.send", "text": "x" * 100_000})


def test_a_websocket_that_is_cut_off_ends_although_its_page_took_nothing():
    """Its end would come after all that waits for the page, which may take it as slowly as it likes."""

    async def send_much(scope, _receive, send):
        await send({"type": "websocket.accept"})
        sending = asyncio.create_task(_send_for_ever(send))
        while not sending.done():
            for _ in range(100):
                await asyncio.sleep(0)
            cut_off(SimpleNamespace(scope=scope))

    connections = Connections(4)

    async def exchange(_reader, writer):
        writer.transport.pause_reading()
        writer.write(UPGRADE)
        while not len(connections):
            await asyncio.sleep(0)
        while len(connections):  # the suite's own limit of time ends a connection that stays
            await asyncio.sleep(0)

    asyncio.run(served(exchange, send_much, connections))


def test_a_websocket_that_is_about_to_end_gives_way():
    sent = asyncio.Event()

    async def end_after_sending(_scope, _receive, send):
        await send({"type": "websocket.accept"})
        await send({"type": "websocket.send", "text": "x" * 40_000_000})  # more than the kernel keeps: it never ends
        sent.set()

    connections = Connections(1)

    async def exchange(_reader, writer):
        writer.transport.pause_reading()
        writer.write(UPGRADE)
        await sent.wait()
        assert len(connections) == 1
        while not connections.add(One(idle=False), "another"):
            await asyncio.sleep(0)

    asyncio.run(served(exchange, end_after_sending, connections))


@in_event_loop
async def test_many_websockets_are_opened_one_after_another(monkeypatch):
    """Two hundred that came together took the event loop for half a second, in which no Stop was answered."""
    monkeypatch.setattr(module, "NEXT_WEBSOCKET", 0.0)
    opened = []
    turn, most = InTurn(), 0
    for number in range(200):
        turn.call(lambda number=number: opened.append(number))
    assert opened == [0]  # the first one at once
    while len(opened) < 200:
        before = len(opened)
        await asyncio.sleep(0)
        most = max(most, len(opened) - before)
    assert most == 1
    assert opened == list(range(200))


def test_what_a_page_sends_before_its_websocket_is_open_is_not_lost(monkeypatch):
    waiting = []
    monkeypatch.setattr(InTurn, "call", lambda _self, function: waiting.append(function))

    async def echo(_scope, receive, send):
        await receive()
        await send({"type": "websocket.accept"})
        await send({"type": "websocket.send", "text": (await receive())["text"]})

    async def exchange(reader, writer):
        writer.write(UPGRADE)
        while not waiting:
            await asyncio.sleep(0)
        writer.write(b"\x81\x84\0\0\0\0stop")  # masked with zeros
        for _ in range(100):
            await asyncio.sleep(0)
        waiting.pop()()
        await reader.readuntil(b"\r\n\r\n")
        return await reader.readexactly(6)

    assert asyncio.run(served(exchange, echo)) == b"\x81\x04stop"
