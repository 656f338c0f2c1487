"""The control link with a control process that answers late, wrongly or not at all."""

import asyncio
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from app.clock import monotonic
from app.messages import TICK
from app.process.command_channel import LinkLost, LinkRefused
from app.refusals import Conflict, Unavailable
from app.session import control_link as control_module
from app.session.control_link import ControlLink


class Process:
    """A control process that gives these `answers`, and hangs for the answer None."""

    def __init__(self, answers: dict[str, Any]) -> None:
        self.answers = answers
        self.commands: list[tuple[str, dict[str, Any]]] = []
        self.loop = asyncio.get_running_loop()
        self.dead = asyncio.Event()
        self.killed = False
        self.ticking = True

    async def call(self, do: str, **fields: Any) -> dict[str, Any]:
        self.commands.append((do, fields))
        answer = self.answers.get(do, {})
        if isinstance(answer, Exception):
            raise answer
        if answer is None:
            await asyncio.sleep(3600)
        return dict(answer)

    def send(self, do: str, **fields: Any) -> None:
        self.commands.append((do, fields))

    def newest(self) -> np.void | None:
        tick = np.zeros(1, TICK)
        tick["t"] = monotonic() if self.ticking else 0.0
        return tick[0]

    def since(self, _number: int) -> NDArray[np.void]:
        return np.zeros(0, TICK)

    async def died(self) -> None:
        await self.dead.wait()

    def kill(self) -> None:
        self.killed = True
        self.loop.call_soon_threadsafe(self.dead.set)

    async def close(self) -> None:
        self.dead.set()


def played(story: Any, answers: dict[str, Any]) -> list[Process]:
    """Run a story with a control process that gives these answers; return it and those that replaced it."""
    opened: list[Process] = []

    async def whole() -> None:
        async def start_process() -> Process:
            opened.append(Process(answers if not opened else {}))
            return opened[-1]

        control = ControlLink(start_process)
        await control.start()
        try:
            await story(control, opened)
        finally:
            await control.close()

    asyncio.run(whole())
    return opened


async def until(condition: Any) -> None:
    while not condition():
        await asyncio.sleep(0.005)


def test_a_stop_that_is_not_answered_is_answered_all_the_same(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(control_module, "STOP_LIMIT", 0.05)

    async def story(control: ControlLink, _opened: list[Process]) -> None:
        assert not await control.stop()

    [process] = played(story, {"stop": None})
    assert ("stop", {"by": "tablet"}) in process.commands


def test_a_command_without_an_answer_ends_the_process_that_owes_it() -> None:
    async def story(control: ControlLink, opened: list[Process]) -> None:
        with pytest.raises(Unavailable):
            await control.call("run")
        await until(lambda: len(opened) == 2 and control.state == "alive")

    assert played(story, {"run": LinkLost("late")})[0].killed


def test_the_frames_of_a_slow_shirt_reach_back_as_far_as_asked(monkeypatch: pytest.MonkeyPatch) -> None:
    """Between two of its frames the loop makes ticks without one."""
    ticks = np.zeros(500, TICK)
    ticks["number"] = np.arange(1, 501)
    ticks["t"] = monotonic() + np.arange(-499, 1) / 50.0
    ticks["has_frame"] = ticks["number"] % 5 == 0
    ticks["values"][:, 0] = ticks["number"]
    monkeypatch.setattr(Process, "newest", lambda _process: ticks[-1])
    monkeypatch.setattr(Process, "since", lambda _process, number: ticks[number:])

    async def story(control: ControlLink, _opened: list[Process]) -> None:
        assert control.newest_frames(2, 10.0, 2.0)[:, 0].tolist() == [*range(405, 501, 5)]

    played(story, {})


def test_a_refusal_ends_nothing() -> None:
    async def story(control: ControlLink, _opened: list[Process]) -> None:
        with pytest.raises(Conflict, match="not now"):
            await control.call("arm")
        assert await control.stop()

    assert not played(story, {"arm": LinkRefused("not now")})[0].killed


def test_a_loop_that_stands_still_is_killed_and_given_more_time_while_it_opens(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(control_module, "WATCH_EVERY", 0.01)

    async def opening(control: ControlLink, opened: list[Process]) -> None:
        loading = asyncio.create_task(control.load("shirt", config={}))
        await until(lambda: ("shirt", {"config": {}}) in opened[0].commands)
        opened[0].ticking = False
        await asyncio.sleep(0.2)
        assert not opened[0].killed
        loading.cancel()
        await asyncio.gather(loading, return_exceptions=True)
        await until(lambda: opened[0].killed)

    monkeypatch.setattr(control_module, "HANG_LIMIT", 0.1)
    played(opening, {"shirt": None})


def test_the_next_one_is_given_what_was_accepted_last_and_nothing_else() -> None:
    async def story(control: ControlLink, opened: list[Process]) -> None:
        await control.load("parameters", parameters=None)
        await control.load("limits", clinic={"forward": 1.0})
        await control.load("limits", clinic={"forward": 0.5})
        await control.load("dial", share=0.5)
        with pytest.raises(Conflict):
            await control.load("chair", config={})
        control.forget("parameters")
        opened[0].kill()
        await until(lambda: len(opened) == 2 and control.state == "alive")
        given = [asked for asked in opened[1].commands if asked[0] != "heartbeat"]
        assert given == [("limits", {"clinic": {"forward": 0.5}}), ("dial", {"share": 0.5})]

    played(story, {"chair": LinkRefused("the key file cannot be read")})
