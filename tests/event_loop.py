"""`in_event_loop` runs a test that is a coroutine function in an event loop of its own."""

import asyncio
import functools


def in_event_loop(test):
    @functools.wraps(test)
    def run(*arguments, **keywords):
        asyncio.run(test(*arguments, **keywords))

    return run
