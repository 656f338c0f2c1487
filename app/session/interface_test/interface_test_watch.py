"""The progress of an interface test, from its ticks: the cursor, the target, and whether it has ended."""

import numpy as np
from numpy.typing import NDArray

from app.faults import State
from app.store.tables import InterfaceTestEnding
from app.world.cursor_task import CursorPlan, CursorTask

SILENT = 2.0  # s without a frame of the shirt, after which a test ends: the cursor stands, and nobody made it stand


class InterfaceTestWatch:
    """Takes the ticks of one interface test, in order, and moves the cursor that the screens show."""

    def __init__(self, plan: CursorPlan) -> None:
        self.task = CursorTask(plan)
        self._frame_t: float | None = None

    def take(self, ticks: NDArray[np.void]) -> InterfaceTestEnding | None:
        """Take the newest ticks (`app.messages.TICK`) of the run; return how the test ended, None while it goes on."""
        for tick in ticks:
            t = float(tick["t"])
            if tick["has_frame"] or self._frame_t is None:
                self._frame_t = t
            self.task.step(float(tick["run_t"]), float(tick["u1"]), float(tick["u2"]))
            if self.task.phase == "over":
                return "complete"
            if int(tick["state"]) == State.FAULT:
                return "stopped"
            if t - self._frame_t > SILENT:
                return "fault"
        return None
