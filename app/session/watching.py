"""Follows a run by its ticks until it is over: for trials on the virtual chair and drives of a real one alike."""

import asyncio
from collections.abc import Callable
from typing import NamedTuple, TypeVar

import numpy as np
from numpy.typing import NDArray

from app.faults import State
from app.session.control import Control

LOOK_EVERY = 0.04  # s
FAULT_LIMIT = 20.0  # s: a latched stop pauses a trial or a drive; uncleared for so long, it ends it

End = TypeVar("End")


class RunLost(Exception):  # noqa: N818
    """The control process that recorded the run is gone."""


class Starter(NamedTuple):
    """Who starts a trial or a drive, and from which screen: it must stay in view, and others only look and stop."""

    person_id: int
    name: str
    screen: str
    picture: str | None = None  # what that screen shows to drive by: "view" or "plan", None: not known


class FaultPatience:
    """Says when a latched stop has lasted for too long."""

    def __init__(self) -> None:
        self._since: float | None = None

    def ends(self, t: float, state: State) -> bool:
        """Take the state at `t` (s); return whether nobody will go on any more."""
        if state is not State.FAULT:
            self._since = None
            return False
        self._since = t if self._since is None else self._since
        return t - self._since >= FAULT_LIMIT


async def watched(
    control: Control, run: int, asked_to_end: asyncio.Event, take: Callable[[NDArray[np.void]], End | None]
) -> End | None:
    """Give the ticks of a run (its number in ticks) to `take` until that returns how it ended.

    Return None when somebody asked to end it; raise RunLost when nothing is left that could be followed.
    """
    last = 0
    while True:
        try:
            await asyncio.wait_for(asked_to_end.wait(), LOOK_EVERY)
        except TimeoutError:
            pass
        else:
            return None
        ticks = control.since(last)
        if ticks is None:
            raise RunLost
        if len(ticks):
            last = int(ticks["number"][-1])
            end = take(ticks[ticks["run"] == run])
            if end is not None:
                return end
