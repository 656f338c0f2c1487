"""Follow a run by its ticks until it ends: a trial on the virtual chair or a drive of a real one."""

import asyncio
from collections.abc import Callable
from typing import NamedTuple, TypeVar

import numpy as np
from numpy.typing import NDArray

from app.session.control_link import ControlLink
from app.session.runs import SessionRun

WATCH_EVERY = 0.04  # s
# s for which a halted trial or drive waits for Continue: time to help the patient or to change a cable. S27 requires
# at least 180. It is limited because nothing else can be recorded meanwhile.
HALT_LIMIT = 300.0

End = TypeVar("End")


class RunLost(Exception):  # noqa: N818
    """The control process that recorded the run has ended."""


class Starter(NamedTuple):
    """The person who starts a trial or a drive, and the screen, which must stay in view; others may only stop."""

    person_id: int
    name: str
    screen: str
    picture: str | None = None  # what that screen shows: "view" (3D) or "plan"; None: not reported


class Halt:
    """The halt of a trial or a drive by a latched stop or a pause, and how long it still waits.

    Attributes
    ----------
    remaining : float or None
        For how much longer (s); None while it is not halted.
    """

    def __init__(self) -> None:
        self.remaining: float | None = None
        self._since: float | None = None

    def update(self, t: float, waits: bool) -> bool:
        """Store whether it is halted at `t` (s); return True when the halt has lasted for HALT_LIMIT."""
        if not waits:
            self._since = self.remaining = None
            return False
        self._since = t if self._since is None else self._since
        self.remaining = max(0.0, HALT_LIMIT - (t - self._since))
        return self.remaining == 0.0


async def follow_run(
    control: ControlLink, run: SessionRun, asked_to_end: asyncio.Event, follow: Callable[[NDArray[np.void]], End | None]
) -> End | None:
    """Pass the ticks of a run, from its first, to `follow` until that returns how it ended.

    Return None when `asked_to_end` is set; raise RunLost when the control process has ended.
    """
    last = run.after
    while True:
        try:
            await asyncio.wait_for(asked_to_end.wait(), WATCH_EVERY)
        except TimeoutError:
            pass
        else:
            return None
        ticks = control.since(last)
        if ticks is None:
            raise RunLost
        if len(ticks):
            last = int(ticks["number"][-1])
            end = follow(ticks[ticks["run"] == run.number])
            if end is not None:
                return end
