"""What one joint can do in one direction: how fast, how evenly, and what else moves with it."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from app.calibration.fit.joint_evidence import full_rate
from app.calibration.fit.joint_fit import LARGEST_THRESHOLD, LEAST_RANGE
from app.calibration.fit.pieces import Frames
from app.calibration.gestures.evidence import Evidence, MadeOnce
from app.calibration.profile import CalibrationProfile, JointMap

LEAST_ACTIVATION = 0.05  # s: a gesture that hardly answers its own prompts is no measure for others
WAY_BACK_EFFORT = 2.0  # the way there does nothing, and has to be made all the same

Direction = Literal[1, -1]
WAYS: tuple[Direction, Direction] = (1, -1)


@dataclass(frozen=True, slots=True)
class Ability:
    """One gesture, not judged yet."""

    joint: JointMap
    column: int
    direction: Direction
    dead_zone: float  # FS/s
    full: float  # FS/s
    reached: float  # FS/s, the full that was measured; 0 where no movement left the dead-zone
    rates: list[NDArray[np.float64]]  # FS/s in its own repetitions, rising this way
    travels: list[float]  # FS in each of them
    shares: Mapping[str, float]  # of its own activation, in whole repetitions of other joints

    @property
    def name(self) -> str:
        """As a gesture is called that is made by hand."""
        return self.joint.name if self.direction > 0 else f"{self.joint.name}_back"

    @property
    def peaks(self) -> list[float]:
        """Largest rate of each repetition, FS/s."""
        return [float(rate.max()) for rate in self.rates]

    @property
    def effort(self) -> float | None:
        """FS to be moved for a full activation, in the time that the person takes; both ways where only one counts.

        With the time held, the rate grows with the size of the movement.
        """
        if not self.rates or not all(peak > 0 for peak in self.peaks):
            return None
        moved = float(np.median([travel / peak for travel, peak in zip(self.travels, self.peaks, strict=True)]))
        return moved * self.full * (1.0 if self.direction > 0 else WAY_BACK_EFFORT)


def abilities(profile: CalibrationProfile, evidence: Evidence) -> list[Ability]:
    """Return what every joint of the profile can do, there and back, in the profile's order."""
    return [
        _ability(evidence, joint, column, direction, [one for one in evidence.made if one.joint == joint.name])
        for column, joint in enumerate(profile.joints)
        for direction in WAYS
    ]


def _ability(
    evidence: Evidence, joint: JointMap, column: int, direction: Direction, own: Sequence[MadeOnce]
) -> Ability:
    windows = [(one.there, one.travel_there) if direction > 0 else (one.back, one.travel_back) for one in own]
    windows = [(rates, travel) for rates, travel in windows if len(rates)]
    rates = [direction * window[:, column] for window, _ in windows]
    # The prompts show the way there as it was asked for; nobody was asked to hurry back, so that more is looked at.
    strokes = rates if direction > 0 and rates else rates + [direction * piece[:, column] for piece in evidence.free]
    dead_zone, full = joint.handles
    reached = (full_rate(strokes, dead_zone) if strokes else None) or 0.0
    if direction < 0:
        full = round(min(max(reached, dead_zone + LEAST_RANGE), LARGEST_THRESHOLD + LEAST_RANGE), 4)
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
        shares=_shares(answer, joint.name, [window for window, _ in windows], evidence.made),
    )


@dataclass(frozen=True, slots=True)
class _Answer:
    """How a gesture answers to rates (n, n_joints)."""

    column: int
    direction: Direction
    dead_zone: float
    full: float
    sample_rate: float

    def seconds(self, pieces: Sequence[Frames]) -> float:
        """Return its activation times time, s, in the mean over the pieces."""
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


def _shares(answer: _Answer, joint: str, own: Sequence[Frames], made: Sequence[MadeOnce]) -> dict[str, float]:
    """Return how much it answers to whole repetitions of each other joint, as a share of its own."""
    if not own:
        return {}
    least = max(answer.seconds(own), LEAST_ACTIVATION)
    others = dict.fromkeys(one.joint for one in made if one.joint != joint)
    return {other: answer.seconds([one.whole for one in made if one.joint == other]) / least for other in others}
