"""Cuts recordings made to cues into phases: rest, free movement, movement towards a gesture, way back."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from app.calibration.fit.repetitions import Prompt
from app.calibration.gaps import Frames, fill_forward
from app.calibration.script import WAY_BACK
from app.cues import Cue, CueKind


class Phase(NamedTuple):
    """The rows of a recording during which one thing was asked for."""

    kind: CueKind
    rows: slice
    joint: str | None


@dataclass(frozen=True, slots=True)
class CuedRun:
    """One recording with its phases."""

    values: Frames  # (n, n_channels), without NaN
    phases: tuple[Phase, ...]


def run_of_cues(values: NDArray[np.floating], cue: NDArray[np.integer], cues: Sequence[Cue]) -> CuedRun:
    """Return the recording of one step; `cue` (n,) is the index into `cues` of each frame."""
    phases = []
    for index, prompt in enumerate(cues):
        rows = np.flatnonzero(cue == index)
        if len(rows) > 1:
            phases.append(Phase(prompt.kind, slice(int(rows[0]), int(rows[-1]) + 1), prompt.joint))
    return CuedRun(fill_forward(np.asarray(values, np.float64)), tuple(phases))


def run_of_prompts(
    t: NDArray[np.float64],
    values: NDArray[np.floating],
    prompts: Sequence[Prompt],
    free: slice,
    rest: slice | None = None,
) -> CuedRun:
    """Return one long recording with the phases of a table of prompts (times in s, on the time axis `t` (n,)).

    The table does not contain the ways back: each is taken to follow its prompt for 1.5 times the prompt's duration, at
    most until the next prompt of the same joint.
    """
    phases = [Phase("free", free, None)]
    if rest is not None:
        phases.append(Phase("rest", rest, None))
    for prompt in prompts:
        later = [other.start for other in prompts if other.joint == prompt.joint and other.start >= prompt.end]
        until = min([prompt.end + WAY_BACK * (prompt.end - prompt.start), *later])
        start, end, back = (int(place) for place in np.searchsorted(t, (prompt.start, prompt.end, until)))
        if end - start > 1:
            phases.append(Phase("move", slice(start, end), prompt.joint))
            if back - end > 1:
                phases.append(Phase("return", slice(end, back), prompt.joint))
    return CuedRun(fill_forward(np.asarray(values, np.float64)), tuple(phases))
