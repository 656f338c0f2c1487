"""The web process does only a little in each turn of its event loop."""

import asyncio
import socket
from collections import Counter
from contextlib import ExitStack

from app.cli.host.event_loop import EVENTS, FewAtOnce, event_loop

PAGES = 50


def test_few_sockets_are_attended_to_in_a_turn_and_each_as_often_as_the_others():
    selector = FewAtOnce()
    with ExitStack() as stack:
        for number in range(PAGES):
            here, there = (stack.enter_context(end) for end in socket.socketpair())
            there.send(b"x")
            selector.register(here, 1, number)
        turns = [[key.data for key, _ in selector.select(0)] for _ in range(5 * PAGES)]
        selector.close()
    assert {len(turn) for turn in turns} == {EVENTS}
    times = Counter(number for turn in turns for number in turn)
    assert len(times) == PAGES
    assert max(times.values()) - min(times.values()) <= 2


def test_a_new_connection_comes_before_all_that_were_attended_to():
    selector = FewAtOnce()
    with ExitStack() as stack:

        def ready(name):
            here, there = (stack.enter_context(end) for end in socket.socketpair())
            there.send(b"x")
            selector.register(here, 1, name)
            return here

        pages = [ready("page") for _ in range(PAGES)]
        for _ in range(PAGES):
            selector.select(0)
        selector.unregister(pages[0])
        pages[0].close()
        ready("Stop")  # with the descriptor that has become free
        assert "Stop" in [key.data for key, _ in selector.select(0)]
        selector.close()


def test_two_hundred_pages_that_leave_at_once_leave_every_turn_to_a_stop():
    lost = 0

    class Page(asyncio.Protocol):
        def connection_lost(self, _exc):
            nonlocal lost
            lost += 1

    async def story():
        loop, most = asyncio.get_running_loop(), 0
        ends = [socket.socketpair() for _ in range(200)]
        for here, _ in ends:
            await loop.connect_accepted_socket(Page, here)
        for _, there in ends:
            there.close()
        while lost < len(ends):
            before = lost
            await asyncio.sleep(0)
            most = max(most, lost - before)
        return most

    with asyncio.Runner(loop_factory=event_loop) as runner:
        assert runner.run(story()) <= EVENTS
