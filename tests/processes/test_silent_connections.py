"""Connections that do nothing and uploads of nobody, in a real program with 1,024 descriptors."""

import socket
import threading

import psutil
import pytest
from drills.connections import DESCRIPTORS, KINDS, MOST_KEPT, connections, few_descriptors, stop, upload_as_nobody

pytestmark = pytest.mark.xdist_group("silent connections")  # one program for all of them


@pytest.fixture(scope="module")
def demo():
    with few_descriptors() as made:
        yield made


@pytest.mark.parametrize("kind", KINDS)
def test_stop_and_a_new_page_come_through_a_thousand_connections_that_do_nothing(demo, kind):
    """1,100 silent connections took all descriptors, and POST Stop was not answered."""
    with demo.socket("live") as live, connections(demo, kind) as used:
        for _ in range(5):
            stop(demo)
        with demo.socket("live") as another:
            another.recv()
        live.recv()  # a page that is open stays
        assert max(used) < DESCRIPTORS - 100  # at no moment, not only after the 10 s for a request


def test_a_page_that_reads_nothing_is_cut_off(demo):
    host = demo.base.removeprefix("http://")
    cookie = "; ".join(f"{name}={value}" for name, value in demo.client.cookies.items())
    head = (
        f"GET /api/v1/live HTTP/1.1\r\nHost: {host}\r\nOrigin: {demo.base}\r\nCookie: {cookie}\r\n"
        "Upgrade: websocket\r\nConnection: Upgrade\r\nSec-WebSocket-Version: 13\r\n"
        "Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\n\r\n"
    )
    program = psutil.Process(demo.process.pid)
    with socket.socket() as page:
        page.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, 4096)
        page.connect((host.split(":")[0], int(host.split(":")[1])))
        page.sendall(head.encode())
        assert page.recv(12) == b"HTTP/1.1 101"
        mine = page.getsockname()[1]
        pause = threading.Event()
        while any(one.raddr and one.raddr.port == mine and one.status == "ESTABLISHED" for one in opened(program)):
            pause.wait(0.5)  # the suite's own limit of time ends a page that stays


def opened(program):
    return program.net_connections(kind="tcp")


def test_nothing_is_kept_of_files_that_nobody_may_send(demo):
    """Twenty uploads of somebody who was not signed in kept 1.18 GB of temporary disk."""
    assert upload_as_nobody(demo) < MOST_KEPT
    assert demo.client.get("/equipment").json()["files"] == []
