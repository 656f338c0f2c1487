"""A second socket uses the screen token of the driving page, and that page falls silent."""

import asyncio
import time
from contextlib import ExitStack, closing

from drills.results import Result, Watcher
from processes.served_demo import Demo, InView, until

from app.clock import monotonic

WORD = "the-screen-of-this-drill"
SHOWN_EVERY = 0.05  # s between two messages of the live socket, which show when the chair stopped
A_TICK = 0.02  # s
# s: the server drops a silent socket after 2 s; the pause ends 1 s of punctual reports after that, by a check for rest
LOOK_ON = 2.8
MOVES = 0.15  # m/s


async def second_socket(runs, dice):
    """S7: another page with the same word must not keep the chair driving."""
    return await asyncio.to_thread(_second_socket, runs, dice)


def _second_socket(runs, dice):
    result = Result("a second socket with the screen's word, and the screen silent", 0.32 + SHOWN_EVERY + A_TICK)
    with closing(Watcher()) as watcher, Demo.running() as demo:
        plan = demo.client.get("/floorplans/apartment").json()
        where = {"floorplan": plan["name"], "path": plan["paths"][0]["name"], "screen": WORD}
        refusals = sum(_run(demo, where, result, dice, watcher) for _ in range(runs))
    result.remark = f"the virtual chair of a whole demonstration; {refusals} sockets refused; ends by itself"
    return result


def _run(demo, where, result, dice, watcher):
    """Run the drill once; return how often the second socket was refused."""
    with ExitStack() as stack:
        live = stack.enter_context(demo.socket("live"))
        first = InView(demo, WORD)
        stack.callback(first.close)
        until(live, lambda message: message["values"] is not None and message["trial"] is None)
        assert demo.client.post("/trials", json=where).status_code == 201
        _until_driving(demo, live)
        second = InView(demo, WORD)
        stack.callback(second.close)
        time.sleep(dice.uniform(0.3, 0.6))
        first.speaks = False  # with its socket open
        silent = monotonic()
        shown = []
        until(live, lambda message: shown.append(message) or monotonic() > silent + LOOK_ON)
        late = watcher.late(silent, silent + LOOK_ON)
        stopped = [message for message in shown if message["state"] == "disarmed"]
        if not stopped or stopped != shown[-len(stopped) :] or stopped[-1]["trial"]["paused"]["name"] != "screen_lost":
            result.violated("the chair went on, or stopped for another reason")
        result.add(stopped[0]["t"] - silent if stopped else None, late=late)
        _until_driving(demo, live)  # by itself: the second socket now reports for the screen
        assert demo.client.post("/trials/current/end", json={}).is_success
        return second.refusals


def _until_driving(demo, live):
    demo.go_on_until(live, lambda message: abs(message["v"]) > MOVES)
