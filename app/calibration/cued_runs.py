"""Recordings made to cues, cut into phases: at rest, moving freely, moving towards a gesture, on the way back."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from app.calibration.fit.pieces import Frames, fill_forward
from app.calibration.fit.repetitions import Prompt
from app.cues import Cue, CueKind

WAY_BACK = 1.5  # of a prompt's length: how long the way back may take where nothing says how long it was


class Phase(NamedTuple):
    """What was asked for during some rows of a recording."""

    kind: CueKind
    rows: slice
    joint: str | None


@dataclass(frozen=True, slots=True)
class CuedRun:
    """One recording without holes, (n, n_channels), and what was asked for when."""

    values: Frames
    phases: tuple[Phase, ...]


def run_of_cues(values: NDArray[np.floating], cue: NDArray[np.integer], cues: Sequence[Cue]) -> CuedRun:
    """Return the recording of one step; `cue` (n,) holds for each frame the index into `cues`."""
    phases = []
    for index, asked in enumerate(cues):
        rows = np.flatnonzero(cue == index)
        if len(rows) > 1:
            phases.append(Phase(asked.kind, slice(int(rows[0]), int(rows[-1]) + 1), asked.joint))
    return CuedRun(fill_forward(np.asarray(values, np.float64)), tuple(phases))


def run_of_prompts(
    t: NDArray[np.float64],
    values: NDArray[np.floating],
    prompts: Sequence[Prompt],
    free: slice,
    rest: slice | None = None,
) -> CuedRun:
    """Return one long recording whose prompts stand in a table (times in s, as `t` (n,) counts them).

    The table does not say when the way back was made: it is looked for right after each prompt, for one and a half
    times its length, at most until the next prompt of the same joint.
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
