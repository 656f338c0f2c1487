"""The cues of a run: what a person is asked to do, and when."""

from collections.abc import Sequence
from typing import Annotated, Literal

from pydantic import Field

from app.messages import NO_CUE
from app.quantities import Count, Document, Name, Seconds

CueKind = Literal["ready", "rest", "free", "move", "return"]


class Cue(Document):
    """One instruction, in force from `start` to `end` (s since the start of the run)."""

    start: Seconds
    end: Annotated[Seconds, Field(gt=0)]
    kind: CueKind
    joint: Name | None = None  # the joint to move
    repetition: Count = 0  # 1, 2, 3 for the repetitions of a gesture


def cue_index(cues: Sequence[Cue], run_t: float) -> int:
    """Return the index of the cue in force `run_t` seconds into the run, NO_CUE when there is none."""
    for index, cue in enumerate(cues):
        if cue.start <= run_t < cue.end:
            return index
    return NO_CUE
