"""The ability of a joint to move in one direction: its rates, travel, effort and cross-talk in the recordings."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from app.calibration.dead_zone import full_over
from app.calibration.fit.joint_evidence import full_rate
from app.calibration.gaps import Frames
from app.calibration.gestures.evidence import Evidence, RepetitionRates
from app.calibration.profile import CalibrationProfile, JointMap

LEAST_ACTIVATION = (
    0.05  # s: lower limit of the divisor of the shares, for gestures that hardly answer their own prompts
)
WAY_BACK_EFFORT = 2.0  # a gesture made by moving back needs the movement there too, which drives nothing

Direction = Literal[1, -1]
WAYS: tuple[Direction, Direction] = (1, -1)


@dataclass(frozen=True, slots=True)
class Ability:
    """What the recordings show of one gesture: a joint moved in one direction."""

    joint: JointMap
    column: int
    direction: Direction
    dead_zone: float  # FS/s
    full: float  # FS/s
    reached: float  # FS/s, the measured full; 0 where no movement left the dead-zone
    rates: list[NDArray[np.float64]]  # FS/s, positive in this direction, one array for each own repetition
    travels: list[float]  # FS, one for each own repetition
    shares: Mapping[str, float]  # other joint -> activation in its repetitions, over that in the own ones

    @property
    def name(self) -> str:
        """Name of the gesture; that of the opposite direction ends in `_back`."""
        return self.joint.name if self.direction > 0 else f"{self.joint.name}_back"

    @property
    def peaks(self) -> list[float]:
        """Largest rate of each repetition, FS/s."""
        return [float(rate.max()) for rate in self.rates]

    @property
    def effort(self) -> float | None:
        """Distance (FS) to move for a full activation, at the person's usual duration of this movement.

        At a constant duration the rate is proportional to the distance. For a gesture made by moving back, the distance
        counts twice. None without repetitions.
        """
        if not self.rates or not all(peak > 0 for peak in self.peaks):
            return None
        moved = float(np.median([travel / peak for travel, peak in zip(self.travels, self.peaks, strict=True)]))
        return moved * self.full * (1.0 if self.direction > 0 else WAY_BACK_EFFORT)


def abilities(profile: CalibrationProfile, evidence: Evidence) -> list[Ability]:
    """Return the abilities of every joint of the profile in both directions, in the profile's order."""
    return [
        _ability(
            evidence,
            joint,
            column,
            direction,
            [repetition for repetition in evidence.repetitions if repetition.joint == joint.name],
        )
        for column, joint in enumerate(profile.joints)
        for direction in WAYS
    ]


def _ability(
    evidence: Evidence, joint: JointMap, column: int, direction: Direction, joint_repetitions: Sequence[RepetitionRates]
) -> Ability:
    windows = [
        (repetition.there, repetition.travel_there) if direction > 0 else (repetition.back, repetition.travel_back)
        for repetition in joint_repetitions
    ]
    windows = [(rates, travel) for rates, travel in windows if len(rates)]
    rates = [direction * window[:, column] for window, _ in windows]
    # The prompts ask for the way there. No cue asks for a fast way back: there, the free movement is used as well.
    strokes = rates if direction > 0 and rates else rates + [direction * piece[:, column] for piece in evidence.free]
    dead_zone, full = joint.thresholds
    reached = (full_rate(strokes, dead_zone) if strokes else None) or 0.0
    if direction < 0:
        full = full_over(dead_zone, reached)
    answer = _Answer(column, direction, dead_zone, full, evidence.sample_rate)
    return Ability(
        joint=joint,
        column=column,
        direction=direction,
        dead_zone=dead_zone,
        full=full,
        reached=reached,
        rates=rates,
        travels=[travel for _, travel in windows],
        shares=_shares(answer, joint.name, [window for window, _ in windows], evidence.repetitions),
    )


@dataclass(frozen=True, slots=True)
class _Answer:
    """The activation of a gesture by given rates."""

    column: int
    direction: Direction
    dead_zone: float
    full: float
    sample_rate: float

    def seconds(self, pieces: Sequence[Frames]) -> float:
        """Return the integral of the activation over time (s), as the mean over the pieces (n, n_joints) of rates."""
        reach = self.full - self.dead_zone
        return float(
            np.mean(
                [
                    np.clip((self.direction * piece[:, self.column] - self.dead_zone) / reach, 0.0, 1.0).sum()
                    for piece in pieces
                ]
            )
            / self.sample_rate
        )


def _shares(
    answer: _Answer, joint: str, own_windows: Sequence[Frames], repetitions: Sequence[RepetitionRates]
) -> dict[str, float]:
    """Return the activation during whole repetitions of each other joint, as a share of that during its own."""
    if not own_windows:
        return {}
    least = max(answer.seconds(own_windows), LEAST_ACTIVATION)
    others = dict.fromkeys(repetition.joint for repetition in repetitions if repetition.joint != joint)
    return {
        other: answer.seconds([repetition.whole for repetition in repetitions if repetition.joint == other]) / least
        for other in others
    }
