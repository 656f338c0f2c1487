"""Curves over trials: an exponential, a power law and a level line, and the one that describes a measure best."""

import math
from collections.abc import Sequence
from typing import Literal, NamedTuple

import numpy as np
from numpy.typing import NDArray

Numbers = NDArray[np.float64]
Form = Literal["exponential", "power", "level"]

MIN_TRIALS = 8  # a curve has three parameters
MIN_TRIALS_FOR_CONSTANT = 20  # with fewer, the learning constant is too uncertain to be given
CONFIDENCE = 0.95
STARTS = 25  # start values over the logarithm of c: the residual may have more than one local minimum
ROUNDING = 1e-12  # relative to the series' scale; smaller differences are rounding errors


class Curve(NamedTuple):
    """A fitted curve a + b shape(n, c); c is the exponential's tau (trials) or the power law's exponent."""

    form: Form
    a: float
    b: float
    c: float
    aicc: float  # comparable between curves through the same values only
    c_low: float  # confidence interval of c; NaN where it leaves the searched range
    c_high: float
    value: Numbers  # (n,) the curve at each trial
    low: Numbers  # (n,) confidence band of the curve's mean
    high: Numbers


class LearningCurve(NamedTuple):
    """One measure over trials, and its fitted curves."""

    n: Numbers  # (n,) trial numbers, from 1
    values: Numbers  # (n,)
    curves: tuple[Curve, ...]  # level line, exponential and power law, the one with the smallest AICc first

    @property
    def curve(self) -> Curve:
        """The best curve; its form is "level" where nothing was learnt."""
        return self.curves[0]

    @property
    def levels_off(self) -> bool:
        """Whether the constant's whole confidence interval is below the number of trials (false where it is NaN)."""
        return self.curve.form == "exponential" and self.curve.c_high <= self.n[-1]

    @property
    def constant(self) -> tuple[float, float, float] | None:
        """The learning constant tau in trials with its confidence interval, where there are trials enough for it."""
        if not self.levels_off or len(self.n) < MIN_TRIALS_FOR_CONSTANT or math.isnan(self.curve.c_low):
            return None
        return self.curve.c, self.curve.c_low, self.curve.c_high


def exponential(n: Numbers, log_tau: float) -> tuple[Numbers, Numbers]:
    """Return exp(-n / tau) and its derivative by ln tau."""
    along = n / math.exp(log_tau)
    shape = np.exp(-along)
    return shape, along * shape


def power(n: Numbers, log_exponent: float) -> tuple[Numbers, Numbers]:
    """Return n ** -exponent, for n from 1, and its derivative by ln exponent."""
    along = np.log(n) * math.exp(log_exponent)
    shape = np.exp(-along)
    return shape, -along * shape


SHAPES = {"exponential": exponential, "power": power}


def fit_level(values: Numbers) -> Curve:
    """Fit a constant, the curve of a series without learning."""
    scaled, centre, scale = _scaled(values)
    mean = float(np.mean(scaled))
    half, _interval = _uncertainty(scaled - mean, np.ones((len(scaled), 1)))
    level, half = np.full(len(scaled), centre + scale * mean), scale * half
    aicc = _aicc(scaled - mean, 2)
    return Curve("level", float(level[0]), 0.0, math.nan, aicc, math.nan, math.nan, level, level - half, level + half)


def fit_exponential(n: Numbers, values: Numbers) -> Curve:
    """Fit a + b exp(-n / tau); tau is searched from 0.3 trials to five times the number of trials."""
    return _fit("exponential", n, values, (0.3, 5.0 * float(n[-1])))


def fit_power(n: Numbers, values: Numbers) -> Curve:
    """Fit a + b n ** -c; c is searched from 0.05 to 5."""
    return _fit("power", n, values, (0.05, 5.0))


def fit_learning_curve(n: Sequence[float], values: Sequence[float]) -> LearningCurve | None:
    """Fit one measure over trials; None with fewer than 8 trials.

    `n` are trial numbers from 1, rising; `values` (n,) are finite and below 1e100. The curves are compared by AICc,
    which prefers the level line unless a bent curve fits well enough for its additional parameters.
    """
    if len(values) < MIN_TRIALS:
        return None
    number = np.asarray(n, dtype=np.float64)
    series = np.asarray(values, dtype=np.float64)
    curves = [fit_level(series), fit_exponential(number, series), fit_power(number, series)]
    curves.sort(key=lambda curve: curve.aicc)
    return LearningCurve(number, series, tuple(curves))


def _fit(form: Form, n: Numbers, values: Numbers, bounds: tuple[float, float]) -> Curve:
    """Fit a + b shape(n, c) by least squares.

    a and b are linear, so that only ln c is searched (variable projection: Golub and Pereyra, SIAM Journal on
    Numerical Analysis 10 (1973)). Band and interval: delta method, which is a linear regression on the tangent plane
    at the optimum, with Student's t. Source: Seber and Wild, Nonlinear Regression (1989), section 5.1.
    """
    from scipy.optimize import least_squares

    shape = SHAPES[form]
    scaled, centre, scale = _scaled(values)

    def linear(log_c: float) -> tuple[Numbers, Numbers]:
        """Return the best (a, b) for this c, and their residual (n,)."""
        columns = np.column_stack([np.ones(len(n)), shape(n, log_c)[0]])
        solution = np.linalg.lstsq(columns, scaled, rcond=None)[0].astype(np.float64)
        return solution, scaled - columns @ solution

    def residual_at(x: Numbers) -> Numbers:
        return linear(float(x[0]))[1]

    lowest, highest = math.log(bounds[0]), math.log(bounds[1])
    starts: list[float] = np.linspace(lowest, highest, STARTS)[1:-1].tolist()
    start = min(starts, key=lambda log_c: float(np.sum(linear(log_c)[1] ** 2)))
    solution = least_squares(residual_at, [start], bounds=(lowest, highest), x_scale=0.1)
    log_c = float(solution.x[0])
    (a, b), residual = linear(log_c)

    at, slope = shape(n, log_c)
    half, interval = _uncertainty(residual, np.column_stack([np.ones(len(n)), at, b * slope]))
    low, high = (log_c + end if lowest < log_c + end < highest else math.nan for end in interval)
    value, half = centre + scale * (scaled - residual), scale * half
    return Curve(
        form,
        centre + scale * float(a),
        scale * float(b),
        math.exp(log_c),
        _aicc(residual, 4),
        math.exp(low),
        math.exp(high),
        value,
        value - half,
        value + half,
    )


def _uncertainty(residual: Numbers, jacobian: Numbers) -> tuple[Numbers, tuple[float, float]]:
    """Return half the confidence band (n,), and the interval of the last parameter around its estimate."""
    from scipy.special import stdtrit

    columns = jacobian.shape[1]
    while np.linalg.matrix_rank(jacobian[:, :columns]) < columns:  # for example b = 0: c has no effect
        columns -= 1
    # Orthonormal columns span the same plane: each of their coefficients has the variance of the residual, and none
    # depends on another. The last one belongs to the last parameter.
    orthonormal, triangle = np.linalg.qr(jacobian[:, :columns])
    coefficients = orthonormal.T @ residual
    freedom = len(residual) - columns
    deviation = math.sqrt(float(np.sum((residual - orthonormal @ coefficients) ** 2)) / freedom)
    reach = float(stdtrit(freedom, (1 + CONFIDENCE) / 2)) * deviation
    half = reach * np.linalg.norm(orthonormal, axis=1)
    if columns < jacobian.shape[1]:
        return half, (math.nan, math.nan)
    last = float(coefficients[-1])
    low, high = sorted(((last - reach) / triangle[-1, -1], (last + reach) / triangle[-1, -1]))
    return half, (low, high)


def _aicc(residual: Numbers, parameters: int) -> float:
    """Return AICc of a least-squares fit; `parameters` includes the variance.

    Source: Burnham and Anderson, Model Selection and Multimodel Inference (2002), section 2.4.
    """
    n = len(residual)
    variance = max(float(np.mean(residual**2)), ROUNDING**2)  # a curve through all points has a residual of 0
    return n * math.log(variance) + 2 * parameters * n / (n - parameters - 1)


def _scaled(values: Numbers) -> tuple[Numbers, float, float]:
    """Return the series around its median, scaled to -1..1, the median, and the scale: fits do not depend on units."""
    centre = float(np.median(values))
    scale = float(np.max(np.abs(values - centre)))
    if scale <= ROUNDING * abs(centre) or scale == 0.0:
        return np.zeros(len(values)), centre, 1.0
    return (values - centre) / scale, centre, scale
