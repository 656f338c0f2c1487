"""A recording made ready for the fits: checked, its channels chosen, its gaps filled."""

from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Self

import numpy as np
from numpy.typing import NDArray

from app.calibration.fit.omissions import channels_left_out
from app.calibration.fit.repetitions import Repetition, Stretch
from app.calibration.gaps import Frames, without_gaps
from app.layout import ShirtLayout
from app.texts import Figure, Text

SHORTEST_FREE = 2.0  # s
SHORTEST_REST = 0.5  # s


@dataclass(frozen=True, slots=True)
class CleanRecording:
    """What one person recorded in one shirt, as every fit reads it: frames (n, n_channels) without NaN."""

    layout: ShirtLayout
    sample_rate: float  # Hz
    free: Frames
    rest: Frames | None
    repetitions: Sequence[Repetition]
    stretches: Sequence[Stretch]
    left_out: Mapping[str, Text]  # channel name -> why no map reads it
    low: tuple[float, ...]  # (n_channels,) smallest recorded value
    high: tuple[float, ...]  # (n_channels,) largest recorded value

    @classmethod
    def of(
        cls,
        layout: ShirtLayout,
        sample_rate: float,
        free: NDArray[np.floating],
        rest: NDArray[np.floating] | None = None,
        repetitions: Sequence[Repetition] = (),
        stretches: Sequence[Stretch] = (),
        unused: Collection[str] = (),
        full_scale: float | None = None,
    ) -> Self:
        """Return the recording made ready for the fits.

        Parameters
        ----------
        layout : ShirtLayout
            Names the columns of all arrays.
        sample_rate : float
            Hz.
        free, rest : (n, n_channels) array
            Frames of the free movement and of the rest; NaN where a sample is missing.
        repetitions : sequence of Repetition
            Prompted movements towards the gesture; they fix the direction.
        stretches : sequence of Stretch
            The prompted movements with the ways back and the pauses around them.
        unused : names of channels
            Channels that a person has marked as unused.
        full_scale : float or None
            Largest absolute value of the shirt's electronics, in signal units, when it is known.

        Raises
        ------
        ValueError
            One sentence: what is too short or unknown, and what to do.
        """
        moved = np.asarray(free, dtype=np.float64)
        resting = None if rest is None else np.asarray(rest, dtype=np.float64)
        prompted = [
            Repetition(repetition.joint, np.asarray(repetition.values, np.float64), repetition.moving)
            for repetition in repetitions
        ]
        _check(layout, sample_rate, moved, resting, prompted, unused)
        pieces = [moved, *([] if resting is None else [resting]), *(repetition.values for repetition in prompted)]
        low, high = _value_range(pieces)
        return cls(
            layout=layout,
            sample_rate=float(sample_rate),
            free=without_gaps(moved, sample_rate),
            rest=None if resting is None else without_gaps(resting, sample_rate),
            repetitions=[
                replace(repetition, values=without_gaps(repetition.values, sample_rate)) for repetition in prompted
            ],
            stretches=[replace(stretch, values=without_gaps(stretch.values, sample_rate)) for stretch in stretches],
            left_out=channels_left_out(layout, sample_rate, moved, resting, prompted, unused, full_scale),
            low=low,
            high=high,
        )

    def with_stretches(self, stretches: Sequence[Stretch]) -> Self:
        """Return the recording with the prompted movements cut into other stretches."""
        clean = [replace(stretch, values=without_gaps(stretch.values, self.sample_rate)) for stretch in stretches]
        return replace(self, stretches=clean)

    def repetitions_of(self, joint: str) -> list[Repetition]:
        """Return the repetitions of one joint."""
        return [repetition for repetition in self.repetitions if repetition.joint == joint]

    def stretches_of(self, joint: str) -> list[Stretch]:
        """Return the stretches of one joint."""
        return [stretch for stretch in self.stretches if stretch.joint == joint]


def _check(
    layout: ShirtLayout,
    sample_rate: float,
    free: Frames,
    rest: Frames | None,
    repetitions: Sequence[Repetition],
    unused: Collection[str],
) -> None:
    """Check that the pieces are long enough and fit the layout.

    Raises
    ------
    ValueError
        One sentence: which piece is wrong, and what to do.
    """
    count = len(layout.channels)
    for what, piece in (
        ("free", free),
        ("rest", rest),
        *((repetition.joint, repetition.values) for repetition in repetitions),
    ):
        if piece is not None and (piece.ndim != 2 or piece.shape[1] != count):
            raise ValueError(Text("calibration-recording-channels", what=what, count=count, layout=layout.name))
    for what, piece, shortest in (("free", free, SHORTEST_FREE), ("rest", rest, SHORTEST_REST)):
        if piece is not None and len(piece) < shortest * sample_rate:
            lasts = Figure(len(piece) / sample_rate, 2)
            raise ValueError(Text("calibration-recording-short", what=what, lasts=lasts, least=shortest))
    for names, existing, what in (
        ({repetition.joint for repetition in repetitions}, layout.joint_names, "joint"),
        (set(unused), layout.channel_names, "channel"),
    ):
        if strange := sorted(names - set(existing)):
            known = ", ".join(existing)
            raise ValueError(
                Text("calibration-unknown-name", what=what, name=strange[0], layout=layout.name, names=known)
            )


def _value_range(pieces: Sequence[Frames]) -> tuple[tuple[float, ...], tuple[float, ...]]:
    """Return the smallest and the largest value of each channel over all pieces; 0 for a channel without values."""
    # fmin and fmax pass over NaN, and give it only for a channel that has nothing else.
    lows = np.fmin.reduce([np.fmin.reduce(piece, axis=0) for piece in pieces])
    highs = np.fmax.reduce([np.fmax.reduce(piece, axis=0) for piece in pieces])
    silent = ~np.isfinite(lows)
    lows[silent] = highs[silent] = 0.0
    return tuple(map(float, lows)), tuple(map(float, highs))
