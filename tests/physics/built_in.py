"""The two built-in dynamics beside another chair's course: how far apart, and which parameters fit. No MuJoCo.

A course is (ticks, 5): x, y (m), heading (rad, without jumps), speed (m/s), turn rate (rad/s), at 100 Hz.
"""

from collections.abc import Sequence
from typing import Final, NamedTuple

import numpy as np
from numpy.typing import NDArray
from pipeline.gates import DT
from scipy.optimize import least_squares

from app.geometry import Pose, Twist
from app.world import dynamics
from app.world.dynamics import BOUNDS, Motion, Wheelchair

UNICYCLE: Final = Wheelchair(speed_lag=0.0, turn_lag=0.0, castor_push=0.0, turn_slip=0.0, speed_slip=0.0)
FITTED: Final = ("speed_lag", "turn_lag", "castor_push", "turn_slip", "speed_slip")  # lengths are the chair's own
SCALES: Final = (0.05, 0.1)  # m/s, rad/s: errors that count alike
SOON: Final = 500  # ticks, 5 s, after which a course that began together is compared
LAGS: Final = range(-30, 61)  # ticks

Numbers = NDArray[np.float64]
Pair = tuple[Sequence[Twist], Numbers]
"""Commands, 100 a second, and the course that a chair made of them."""


class Difference(NamedTuple):
    """How far a built-in course is from another one."""

    distance: float  # m, root mean square over the whole way
    heading: float  # degrees, likewise
    soon: float  # m, root mean square of the distances 5 s after both stood at one place and heading
    speed_lag: float  # s by which the other course follows later
    turn_lag: float  # s


def built_in(twists: Sequence[Twist], chair: Wheelchair) -> Numbers:
    """Return the course of a built-in chair; UNICYCLE is the one that answers at once."""
    motion = Motion(Pose(0.0, 0.0, 0.0))
    rows = []
    for twist in twists:
        motion = dynamics.step(motion, twist, DT, chair)
        rows.append((*motion.pose, motion.v, motion.omega))
    course = np.array(rows)
    course[:, 2] = np.unwrap(course[:, 2])
    return course


def difference(own: Numbers, other: Numbers) -> Difference:
    """Compare a built-in course with another one of equal length, above 5 s."""
    apart = np.linalg.norm(own[:, :2] - other[:, :2], axis=1)
    turned = np.degrees(own[:, 2] - other[:, 2])
    starts = range(0, len(own) - SOON, SOON)
    soon = [float(np.linalg.norm(_way(own, start) - _way(other, start))) for start in starts]
    return Difference(
        distance=_rms(apart),
        heading=_rms(turned),
        soon=_rms(soon),
        speed_lag=lag(own[:, 3], other[:, 3]),
        turn_lag=lag(own[:, 4], other[:, 4]),
    )


def lag(own: Numbers, other: Numbers) -> float:
    """Return by how much (s) `other` (n,) follows later than `own` (n,): the shift at which they agree best."""

    def misfit(ticks: int) -> float:
        early, late = max(0, -ticks), max(0, ticks)
        return _rms(own[early : len(own) - late] - other[late : len(other) - early])

    return DT * min(LAGS, key=misfit)


def fit(pairs: Sequence[Pair]) -> Wheelchair:
    """Return the wheelchair whose speed and turn rate come nearest to those of the courses, within BOUNDS."""
    low, high = zip(*(BOUNDS[name] for name in FITTED), strict=True)

    def chair_of(values: Numbers) -> Wheelchair:
        return Wheelchair(**dict(zip(FITTED, values.tolist(), strict=True)))

    def misfit(values: Numbers) -> Numbers:
        chair = chair_of(values)
        errors = [(built_in(twists, chair) - course)[:, 3:] / SCALES for twists, course in pairs]
        return np.concatenate(errors).ravel()

    start = [getattr(Wheelchair(), name) for name in FITTED]
    return chair_of(least_squares(misfit, start, bounds=(low, high), diff_step=1e-3).x)


def _way(course: Numbers, start: int) -> Numbers:
    """Return the way (2,) of the next 5 s, as seen from the pose at `start`."""
    x, y = course[start + SOON, :2] - course[start, :2]
    cosine, sine = np.cos(course[start, 2]), np.sin(course[start, 2])
    return np.array([cosine * x + sine * y, cosine * y - sine * x])


def _rms(values: list[float] | Numbers) -> float:
    return float(np.sqrt(np.mean(np.square(values))))
