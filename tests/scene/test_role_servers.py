"""The 3D servers: where they listen, what each role gets, their page."""

import logging
import socket
import threading

import pytest
from scene.scene_messages import everything

from app.scene.role_servers import ROLES, RoleServers
from app.scene.session_scene import LiveScene
from app.scene.viewer_page import client_page


def test_servers_listen_here_only_say_nothing_and_end(capfd):
    before = set(threading.enumerate())
    servers = RoleServers()
    ports = [servers.port(role) for role in ROLES]
    assert len(set(ports)) == len(ROLES)
    assert {servers[role].get_host() for role in ROLES} == {"127.0.0.1"}
    servers.stop()
    servers.stop()
    assert [thread for thread in set(threading.enumerate()) - before if thread.is_alive()] == []
    for port in ports:
        with pytest.raises(ConnectionRefusedError):
            socket.create_connection(("127.0.0.1", port), timeout=1)
    assert capfd.readouterr() == ("", "")


def test_no_server_can_be_asked_for_a_public_tunnel(servers):
    for role in ROLES:
        handled = {kind.__name__ for kind in servers[role]._websock_server._incoming_handlers}
        assert not {name for name in handled if name.startswith("ShareUrl")}


def test_only_the_clinician_gets_plots(servers):
    LiveScene(servers)
    kinds = {role: {message["type"] for message in everything(servers.port(role))} for role in ROLES}
    assert "GuiUplotMessage" in kinds["clinician"]
    assert "GuiUplotMessage" not in kinds["patient"]


def test_the_page_is_visers_own_with_our_head():
    page = client_page().decode()
    assert page.count("</head>") == 1
    assert "bodydriveView" in page[: page.index("</head>")]
    assert "<title>Viser" not in page


def test_servers_that_were_looked_at_leave_no_filter_in_the_log():
    filters = logging.getLogger("websockets.server").filters
    before = list(filters)
    for _ in range(2):
        with RoleServers() as servers:
            for role in ROLES:
                everything(servers.port(role))
    assert filters == before
