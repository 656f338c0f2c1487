"""A run in progress: its clock, its cues, its writer."""

import math
from collections.abc import Sequence
from typing import Literal

from app.cues import Cue, cue_index
from app.messages import NO_CUE
from app.recording.writer import RunWriter
from app.world.cursor_task import CursorPlan, CursorTask

RunKind = Literal["rest", "free", "prompt", "drive", "interface_test"]


class OpenRun:
    """One uninterrupted recording in progress."""

    def __init__(
        self,
        run_id: str,
        number: int,
        kind: RunKind,
        cues: Sequence[Cue],
        start: float,
        writer: RunWriter,
        test: CursorPlan | None = None,
    ) -> None:
        """Begin at `start` (monotonic s); `number` names the run in ticks, `test` is the plan of an interface test."""
        self.run_id = run_id
        self.number = number
        self.kind = kind
        self.cues = tuple(cues)
        self.start = start
        self.writer = writer
        self.was_armed = False
        self.task = None if test is None else CursorTask(test)  # for the eyes of a simulated body
        self._edges = sorted({edge for cue in self.cues for edge in (cue.start, cue.end)})
        self._cue = NO_CUE
        self._until = -math.inf  # run time up to which the current cue stays in force

    def cue_at(self, run_t: float) -> int:
        """Return the index of the cue in force at `run_t` (s since the start), which must not go back."""
        if run_t >= self._until:
            self._cue = cue_index(self.cues, run_t)
            self._until = next((edge for edge in self._edges if edge > run_t), math.inf)
        return self._cue
