"""viser's own ports answer only the bridge: no page of any origin, and no other program."""

import socket

import httpx
import pytest
import viser
import websockets.sync.client
from viser.infra import _infra
from websockets.exceptions import InvalidStatus

from app.scene import role_servers
from app.scene.bridge_secret import BRIDGE_HEADERS, HEADER, SECRET
from app.scene.client_messages import SUBPROTOCOL
from app.scene.role_servers import ROLES, RoleServers
from app.scene.viewer_page import client_page

ORIGINS = [None, "http://evil.example", "http://127.0.0.1:8080", "null"]
STRANGERS = [
    {},
    {"Cookie": "bodydrive_sign_in=anything"},
    {HEADER: ""},
    {HEADER: SECRET[:-1]},
    {HEADER: SECRET.lower()},
    {HEADER: "ä" * 43},
    {"Cookie": f"{HEADER}={SECRET}"},
]


@pytest.fixture(scope="module")
def ports():
    with RoleServers() as started:
        yield [started.port(role) for role in ROLES]


def connect(port, headers, origin=None):
    options = {"subprotocols": [SUBPROTOCOL], "compression": None, "max_size": None, "proxy": None}
    address = f"ws://127.0.0.1:{port}"
    return websockets.sync.client.connect(address, additional_headers=headers, origin=origin, **options)


@pytest.mark.parametrize("origin", ORIGINS)
@pytest.mark.parametrize("headers", STRANGERS)
def test_a_client_without_the_secret_gets_no_byte_of_the_scene(ports, headers, origin):
    for port in ports:
        with pytest.raises(InvalidStatus) as refused, connect(port, headers, origin):
            pass
        assert refused.value.response.status_code == 403
        assert len(refused.value.response.body) < 200


def test_two_headers_with_the_secret_are_refused(ports):
    lines = ["GET / HTTP/1.1", "Host: here", "Upgrade: websocket", "Connection: Upgrade", "Sec-WebSocket-Version: 13"]
    lines += ["Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==", f"Sec-WebSocket-Protocol: {SUBPROTOCOL}"]
    lines += [f"{HEADER}: {SECRET}"] * 2
    with socket.create_connection(("127.0.0.1", ports[0]), timeout=10) as raw:
        raw.sendall("\r\n".join([*lines, "", ""]).encode())
        assert raw.recv(4096).startswith(b"HTTP/1.1 403")


@pytest.mark.parametrize("path", ["/", "/index.html", "/?websocket=x", "/nothing"])
def test_no_page_is_served_without_the_secret(ports, path):
    for port in ports:
        for headers in ({}, {"Upgrade": "websocket"}):
            assert httpx.get(f"http://127.0.0.1:{port}{path}", headers=headers).status_code == 403


def test_our_bridge_gets_the_scene(ports):
    for port in ports:
        with connect(port, BRIDGE_HEADERS) as bridge:
            assert len(bridge.recv(timeout=10)) > 100


def test_the_page_does_not_contain_the_secret():
    assert SECRET.encode() not in client_page()


def test_a_server_that_does_not_require_the_secret_is_not_used(monkeypatch):
    """Another version of viser may open its port in another way."""
    opened = []
    monkeypatch.setattr(_infra, "websockets", websockets)
    monkeypatch.setattr(role_servers, "guard_viser", lambda: None)
    made = viser.ViserServer.__init__

    def noted(self, **given):
        made(self, **given)
        opened.append(self.get_port())

    monkeypatch.setattr(viser.ViserServer, "__init__", noted)
    with pytest.raises(RuntimeError, match="install viser"):
        RoleServers()
    with pytest.raises(ConnectionRefusedError):
        socket.create_connection(("127.0.0.1", opened[0]), timeout=1)
