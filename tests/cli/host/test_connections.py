import asyncio
import resource
import socket
from types import SimpleNamespace

import pytest
from hypothesis import given
from hypothesis import strategies as st
from uvicorn.config import Config
from uvicorn.server import ServerState

from app.cli.host import connections as module
from app.cli.host.connections import (
    MOST,
    RESERVE,
    SHARE,
    Connections,
    EncryptedListener,
    limited,
    most_connections,
)

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


async def served(exchange):
    """Serve with the limited classes, and return what `exchange` returns of a connection."""
    http = limited(Connections(4))
    config = Config(answer, http=http, ws="none", log_config=None, lifespan="off")
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
