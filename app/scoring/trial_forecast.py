"""A recorded trial decoded with another parameter set: how the same movements would have been read.

The forecast says what the recorded movements would have commanded. It does not say where the chair would have gone:
the person would have moved otherwise had the chair moved otherwise.
"""

import numpy as np
from numpy.typing import NDArray

from app.calibration.vocabulary import DriveParameters
from app.faults import State
from app.pipeline.replay.batch import DecodedRun, decode_block
from app.quantities import Document
from app.recording.format import Columns
from app.recording.reader import RunRecording
from app.texts import Text

BRIEF = 0.1  # s; an activation shorter than this is shorter than any deliberate movement


class Effect(Document):
    """The movements of a trial as two parameter sets decode them."""

    seconds: float  # for which motion was permitted
    activations_before: int  # of all bound gestures
    activations_after: int
    false_before: int  # activations shorter than `BRIEF`
    false_after: int
    alike: float  # share of the time in which u1 and u2 have the same signs with both sets
    felt_change: float  # rms of the change of u1 and u2, over rms of u1 and u2 before


def predicted_effect(run: RunRecording, before: DriveParameters, after: DriveParameters) -> Effect | None:
    """Decode a recorded trial with the parameters `before` and `after`, and compare the results.

    None when motion was never permitted in the trial.

    Raises
    ------
    ValueError
        One sentence, when the run is of another shirt.
    """
    frames = run.frames()
    permitted = np.asarray(frames["state"] == State.ARMED)
    if not permitted.any():
        return None
    old, new = _decoded(frames, before), _decoded(frames, after)
    seconds = float(np.clip(np.diff(frames["t"], prepend=frames["t"][0]), 0.0, 1.0)[permitted].sum())
    period = seconds / permitted.sum()
    counts = [
        _activations(decoded, parameters, permitted, period) for decoded, parameters in ((old, before), (new, after))
    ]
    u_old, u_new = (np.column_stack((decoded.u1, decoded.u2))[permitted] for decoded in (old, new))
    return Effect(
        seconds=seconds,
        activations_before=counts[0][0],
        activations_after=counts[1][0],
        false_before=counts[0][1],
        false_after=counts[1][1],
        alike=float(np.mean((np.sign(u_old) == np.sign(u_new)).all(axis=1))),
        felt_change=_share(u_new - u_old, u_old),
    )


def _decoded(frames: Columns, parameters: DriveParameters) -> DecodedRun:
    values, profile = frames["values"], parameters.profile
    if values.shape[1] != len(profile.layout.channels):
        channels = len(profile.layout.channels)
        raise ValueError(Text("measure-forecast-channels", recorded=values.shape[1], channels=channels))
    return decode_block(
        parameters,
        profile.sample_rate,
        frames["t"],
        values.astype(np.float32, copy=False),
        t_device=frames["t_device"],
        state=frames["state"],
    )


def _activations(
    decoded: DecodedRun, parameters: DriveParameters, permitted: NDArray[np.bool_], period: float
) -> tuple[int, int]:
    """Return the number of activations of bound gestures, and how many of them were shorter than `BRIEF`."""
    lengths = [_lengths((decoded.activation[:, i] > 0.0) & permitted) * period for i in parameters.bound_gestures]
    together = np.concatenate(lengths) if lengths else np.empty(0)
    return len(together), int((together < BRIEF).sum())


def _lengths(mask: NDArray[np.bool_]) -> NDArray[np.intp]:
    """Return the length (frames) of each stretch in which a mask (n,) is true."""
    edges = np.flatnonzero(np.diff(np.concatenate(([False], mask, [False])).astype(np.int8)))
    return edges[1::2] - edges[::2]


def _share(change: NDArray[np.float64], of: NDArray[np.float64]) -> float:
    """Return rms(change) / rms(of); 0 where `of` is 0 throughout."""
    reference = float(np.sqrt(np.mean(of**2)))
    return float(np.sqrt(np.mean(change**2))) / reference if reference > 0.0 else 0.0
