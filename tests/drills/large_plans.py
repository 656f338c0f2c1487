"""The drill of the largest floor plan that is accepted: Stop, and the memory of the web process, beside it."""

import asyncio
import http.client
import json
import math
import threading
import time
from contextlib import closing
from pathlib import Path

from drills.bomb_effects import MOST_GROWTH, RESET_PEAK, memory
from drills.connections import stop
from drills.results import Result, Watcher, waited
from processes.served_demo import Demo

from app.clock import monotonic
from app.world.floorplan import MAX_LINE_POINTS, MAX_WALLS

LIMIT = 0.1  # s: S6 of a tablet
OBSTACLES = 1000
NAME = "large"
WORD = "0123456789abcdef"
LONGEST = {"checked": 2.0, "listed": 2.0, "prepared": 8.0, "driven in": None}  # s until Stop; None: after the answer
GOOD = {
    "checked": {200},
    "listed": {200},
    "prepared": {201, 409},
    "driven in": {201},
}  # 409: Stop came before the start


def largest_plan():
    """Return the document of a floor plan with as much of everything as is taken: 1.6 MB."""
    comb = [[5.0 + 0.000123456789 * number, 5.0 + 0.3123456789 * (number % 2)] for number in range(MAX_WALLS)]
    boxes = [
        {
            "kind": "box",
            "label": f"Box {number}",
            "position": [6.0 + 0.01234567891 * number, 8.0 + 0.0123456789 * (number % 7)],
            "size": [0.3123456789, 0.3123456789],
            "angle": 0.1234567891,
        }
        for number in range(OBSTACLES)
    ]
    line = [[3.0 * number / MAX_LINE_POINTS, 0.1 * math.sin(number / 100)] for number in range(MAX_LINE_POINTS)]
    path = {"name": "main", "title": "Main", "points": line, "instruction": "Follow the line."}
    places = [[8.0 + 0.1 * number, 12.0] for number in range(200)]
    plan = {"name": NAME, "title": "Large", "walls": [comb], "obstacles": boxes, "paths": [path]}
    plan["rooms"] = [{"label": f"Room {number}", "position": place} for number, place in enumerate(places)]
    plan["cones"] = [{"position": place} for place in places]
    plan["doors"] = [{"position": place} for place in places]
    return json.dumps(plan, indent=8)


async def large_plan(runs, dice):
    """S6, C15: Stop while the largest plan is checked, listed, prepared for a trial and driven in."""
    result = Result("Stop while the largest floor plan is checked, listed, prepared, driven in", LIMIT)
    await asyncio.to_thread(_beside_plan, runs, dice, result)
    return result


def _beside_plan(runs, dice, result):
    document, most = largest_plan(), 0
    with closing(Watcher()) as watcher, Demo.running() as demo, demo.socket("live") as live:
        pid = demo.process.pid
        assert demo.client.post("/floorplans", content=document).status_code == 201
        for run in range(runs):
            way = list(LONGEST)[run % len(LONGEST)]
            demo.go_on_until(live, lambda message: message["state"] != "fault" and message["values"] is not None)
            Path(f"/proc/{pid}/clear_refs").write_text(RESET_PEAK)
            before = memory(pid, "VmRSS")
            asking = Asking(lambda way=way: _ask(demo.client, way, document))
            if LONGEST[way] is None:
                asking.answer()
            else:
                time.sleep(dice.uniform(0.0, LONGEST[way]))
            result.add(*_timed_stop(demo, watcher))
            status = asking.answer()
            growth = memory(pid, "VmHWM") - before
            most = max(most, growth)
            if growth > MOST_GROWTH:
                result.violations.append(f"run {result.runs}: the web process grew by {growth / 1e6:.0f} MB")
            if status not in GOOD[way]:
                result.violations.append(f"run {result.runs}: the plan that was to be {way} was answered with {status}")
            if status == http.client.CREATED:
                assert demo.client.post("/trials/current/end", json={}).is_success
    result.remark = (
        f"{len(document) / 1e6:.1f} MB; until Stop is answered; the web process grew by {most / 1e6:.0f} MB "
        f"(limit {MOST_GROWTH / 1e6:.0f})"
    )


def _ask(client, way, document):
    if way == "checked":
        return client.post("/floorplans/check", content=document)
    if way == "listed":
        return client.get("/floorplans")
    return client.post("/trials", json={"floorplan": NAME, "path": "main", "screen": WORD, "picture": "plan"})


def _timed_stop(demo, watcher):
    """Stop; return after how long it was answered, nothing, and how late this machine was (s)."""
    processes = demo.process.pid, demo.control_process().pid
    began, before = monotonic(), sum(map(waited, processes))
    stop(demo)
    ended = monotonic()
    return ended - began, None, watcher.late(began, ended) + sum(map(waited, processes)) - before


class Asking:
    """A request that is under way."""

    def __init__(self, ask):
        self._ask, self._status = ask, None
        self._thread = threading.Thread(target=self._run)
        self._thread.start()

    def _run(self):
        self._status = self._ask().status_code

    def answer(self):
        """Return the status of the answer, once it is there."""
        self._thread.join()
        return self._status
