"""The 3D servers: where they listen, what each role gets, their page."""

import asyncio
import logging
import socket
import threading

import pytest
from scene.scene_messages import everything
from viser import _messages as wire
from viser.infra._async_message_buffer import AsyncMessageBuffer

from app.scene.role_servers import ROLES, LoopBuffer, RoleServers, quiet_server
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


def push_from_another_thread(buffer: AsyncMessageBuffer) -> None:
    message = wire.SetPositionMessage("/chair", (1.0, 2.0, 3.0))
    pushing = threading.Thread(target=buffer.push, args=(message,))
    pushing.start()
    pushing.join()


def test_another_thread_wakes_nobody_itself_and_the_loop_wakes_everybody():
    """Waking would go through the list of those who wait, which the loop may change at the same time."""

    async def wake() -> None:
        buffer = LoopBuffer(asyncio.get_running_loop(), persistent_messages=True)
        waiting = [asyncio.create_task(buffer.message_event.wait()) for _ in range(3)]
        await asyncio.sleep(0)
        push_from_another_thread(buffer)  # the loop does nothing meanwhile
        assert not buffer.message_event.is_set()
        await asyncio.gather(*waiting)

    asyncio.run(wake())


def test_a_block_of_changes_wakes_at_its_end():
    async def wake() -> None:
        buffer = LoopBuffer(asyncio.get_running_loop(), persistent_messages=False)
        waiting = asyncio.create_task(buffer.message_event.wait())
        buffer.atomic_start()
        push_from_another_thread(buffer)
        await asyncio.sleep(0)
        assert not waiting.done()
        buffer.atomic_end()
        await waiting

    asyncio.run(wake())


def test_every_server_has_such_buffers_for_all_pages():
    server = quiet_server()
    try:
        assert isinstance(server.scene._websock_interface.get_message_buffer(), LoopBuffer)
    finally:
        server.stop()
