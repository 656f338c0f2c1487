import asyncio
import threading
from contextlib import AsyncExitStack
from types import SimpleNamespace

import pytest
from fastapi import WebSocketDisconnect

from app.api import sockets as sockets_module
from app.api.sign_in.identity import COOKIE, SignedInPerson
from app.api.sockets import CUT_OFF, OpenSockets
from app.cli import server as server_module
from app.cli.server import WebServer
from app.session.equipment.paired_phones import PairedPhones


class Socket:
    """A browser's websocket that ends in a given way."""

    cookies: dict = {}  # noqa: RUF012
    scope: dict = {}  # noqa: RUF012

    def __init__(self, trouble=None):
        self.trouble, self.code = trouble, None

    async def close(self, code):
        if self.trouble is not None:
            raise self.trouble
        self.code = code


@pytest.mark.parametrize("trouble", [WebSocketDisconnect(1006), RuntimeError("closed"), TimeoutError()])
def test_a_page_that_is_just_gone_does_not_keep_the_others_open(trouble):
    async def close():
        sockets = OpenSockets(SimpleNamespace(), SimpleNamespace(), PairedPhones())
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


class Page:
    """A page's open websocket with a cookie; what it takes is written down."""

    def __init__(self, cookie, takes=True):
        self.cookies, self._takes = {COOKIE: cookie}, takes
        self.code, self.is_asked, self.is_cut_off = None, False, False
        self.scope = {"scheme": "http", "state": {CUT_OFF: self.cut_off}}

    def cut_off(self):
        self.is_cut_off = True

    async def close(self, code):
        self.is_asked = True
        if not self._takes:
            await asyncio.Event().wait()
        self.code = code


async def with_pages(pages, act):
    """Keep the websockets of pages open while `act` does something with all open ones; return what it returns."""
    opened = OpenSockets(SimpleNamespace(), SimpleNamespace(), PairedPhones())
    async with AsyncExitStack() as stack:
        for number, page in enumerate(pages):
            who = SignedInPerson(sign_in_id=number, person_id=1, clinic_id=1, name="Ada", role="owner")
            await stack.enter_async_context(opened.guarded(page, who))
        return await act(opened)


def test_each_sign_in_is_looked_up_once_for_all_its_pages_and_one_at_a_time(monkeypatch):
    """Two hundred pages of one person were two hundred look-ups at the same moment: a Stop waited for them."""
    looked_up, alone, met = [], threading.Lock(), []

    def find(_database, page, **_):
        if not alone.acquire(blocking=False):
            met.append(page)
            return None
        looked_up.append(page.cookies[COOKIE])
        alone.release()
        return None if page.cookies[COOKIE] == "ended" else SignedInPerson(1, 1, 1, "Ada", "owner")

    async def until_closed(_opened):
        while not all(page.code for page in pages if page.cookies[COOKIE] == "ended"):
            await asyncio.sleep(0)
        return list(looked_up)

    monkeypatch.setattr(sockets_module, "find_sign_in", find)
    monkeypatch.setattr(sockets_module, "CHECK_EVERY", 0.0)
    pages = [Page(cookie) for cookie in ("one", "another", "ended") for _ in range(200)]
    found = asyncio.run(with_pages(pages, until_closed))
    assert len(found) < len(pages) / 2
    assert found[:3] == ["one", "another", "ended"]
    assert not met
    assert {page.code for page in pages} == {None, 4401}


def test_pages_that_take_nothing_are_cut_off_together_when_their_sign_in_ends(monkeypatch):
    """Each was waited for after the other, and stayed open: its messages went on counting as those of a person."""
    monkeypatch.setattr(sockets_module, "CLOSE_LIMIT", 0.01)
    pages = [Page("one", takes=False) for _ in range(5)] + [Page("one")]
    pages[0].scope["state"][CUT_OFF] = lambda: asked.extend(page.is_asked for page in pages)
    asked = []
    asyncio.run(with_pages(pages, lambda opened: opened.close_person(1)))
    assert asked == [True] * 6  # before the first one was cut off
    assert [page.is_cut_off for page in pages] == [False, True, True, True, True, False]
    assert pages[-1].code == 4401


def test_closing_many_pages_leaves_every_turn_of_the_event_loop_to_a_stop():
    async def close(opened):
        closing, most, before = asyncio.create_task(opened.close_all()), 0, 0
        while not closing.done():
            await asyncio.sleep(0)
            closed = sum(page.code is not None for page in pages)
            most, before = max(most, closed - before), closed
        return most

    pages = [Page("one") for _ in range(200)]
    assert asyncio.run(with_pages(pages, close)) <= 2
