import asyncio
from types import SimpleNamespace

import pytest
from fastapi import WebSocketDisconnect

from app.api.sockets import OpenSockets
from app.cli import server as server_module
from app.cli.server import WebServer


class Socket:
    """A browser's websocket that ends in a given way."""

    cookies: dict = {}  # noqa: RUF012

    def __init__(self, trouble=None):
        self.trouble, self.code = trouble, None

    async def close(self, code):
        if self.trouble is not None:
            raise self.trouble
        self.code = code


@pytest.mark.parametrize("trouble", [WebSocketDisconnect(1006), RuntimeError("closed"), TimeoutError()])
def test_a_page_that_is_just_gone_does_not_keep_the_others_open(trouble):
    async def close():
        sockets = OpenSockets(SimpleNamespace(), SimpleNamespace())
        gone, here = Socket(trouble), Socket()
        async with sockets.guarded(gone, None), sockets.guarded(here, None):
            await sockets.close_all()
        return here.code

    assert asyncio.run(close()) == 1001


def test_the_program_ends_whatever_becomes_of_its_goodbye(monkeypatch):
    async def trouble(_app):
        raise OSError("the network is gone")

    monkeypatch.setattr(server_module, "say_goodbye", trouble)

    async def leave():
        server = WebServer(None, None, "")
        with pytest.raises(OSError, match="gone"):
            await server._leave()
        return server.should_exit

    assert asyncio.run(leave())
