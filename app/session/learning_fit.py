"""Curves over trials: an exponential, a power law and a level line, compared by the information they cost."""

import math
from collections.abc import Callable
from typing import Literal, NamedTuple

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import minimize_scalar
from scipy.stats import f as f_distribution
from scipy.stats import t as t_distribution

Numbers = NDArray[np.float64]
Form = Literal["exponential", "power", "level"]

CONFIDENCE = 0.95
GRID = 200  # points over the logarithm of the shape, before the search is refined
RELATIVE_ZERO = 1e-12  # of the series' own scale: below it a residual is rounding


class Curve(NamedTuple):
    """A fitted curve a + b shape(n, c); c is tau (trials) of the exponential, the exponent of the power law."""

    form: Form
    a: float
    b: float
    c: float
    residual: float  # sum of squares
    aicc: float
    c_low: float  # confidence interval of c by profile likelihood; an end of the search range is NaN
    c_high: float
    value: Numbers  # (n,) the curve at each trial
    low: Numbers  # (n,) confidence band of the curve's mean
    high: Numbers


def exponential(n: Numbers, tau: float) -> Numbers:
    """Return exp(-n / tau)."""
    return np.exp(-n / tau)


def power(n: Numbers, exponent: float) -> Numbers:
    """Return n ** -exponent, for n from 1."""
    return n**-exponent


def corrected_akaike(residual: float, count: int, parameters: int) -> float:
    """Return AICc of a least-squares fit; `parameters` includes the variance.

    Source: Burnham and Anderson, Model Selection and Multimodel Inference (2002), section 2.4.
    """
    penalty = 2.0 * parameters + 2.0 * parameters * (parameters + 1) / (count - parameters - 1)
    return count * math.log(residual / count) + penalty


def fit_level(values: Numbers) -> Curve:
    """Fit a constant: nothing was learnt."""
    count = len(values)
    mean = float(np.mean(values))
    residual = _at_least_rounding(float(np.sum((values - mean) ** 2)), values)
    half = float(t_distribution.ppf((1 + CONFIDENCE) / 2, count - 1)) * math.sqrt(residual / (count - 1) / count)
    level = np.full(count, mean)
    aicc = corrected_akaike(residual, count, 2)
    return Curve("level", mean, 0.0, math.nan, residual, aicc, math.nan, math.nan, level, level - half, level + half)


def fit_exponential(n: Numbers, values: Numbers) -> Curve:
    """Fit a + b exp(-n / tau); tau is searched from 0.3 trials to five times the number of trials."""
    return _fit("exponential", exponential, n, values, (0.3, 5.0 * float(n[-1])))


def fit_power(n: Numbers, values: Numbers) -> Curve:
    """Fit a + b n ** -c; c is searched from 0.05 to 5."""
    return _fit("power", power, n, values, (0.05, 5.0))


def _fit(
    form: Form, shape: Callable[[Numbers, float], Numbers], n: Numbers, values: Numbers, bounds: tuple[float, float]
) -> Curve:
    """Fit a + b shape(n, c) by least squares: a and b are linear, so that only c has to be searched.

    Band: delta method, Student's t with n - 3 degrees of freedom. Interval of c: all c whose residual is within
    F(1, n - 3) of the best. Source: Seber and Wild, Nonlinear Regression (1989), sections 5.1 and 5.4.
    """
    count = len(values)

    def residual_at(log_c: float) -> float:
        return _linear(shape(n, math.exp(log_c)), values)[2]

    grid = np.linspace(math.log(bounds[0]), math.log(bounds[1]), GRID)
    residuals = np.array([residual_at(log_c) for log_c in grid])
    best = int(np.argmin(residuals))
    around = (float(grid[max(best - 1, 0)]), float(grid[min(best + 1, GRID - 1)]))
    refined = minimize_scalar(residual_at, bounds=around, method="bounded", options={"xatol": 1e-7})
    log_c = float(refined.x) if refined.fun < residuals[best] else float(grid[best])
    c = math.exp(log_c)
    a, b, residual = _linear(shape(n, c), values)
    residual = _at_least_rounding(residual, values)
    freedom = count - 3

    step = 1e-5
    slope = b * (shape(n, c * (1 + step)) - shape(n, c * (1 - step))) / (2 * step)  # d value / d ln c
    jacobian = np.column_stack([np.ones(count), shape(n, c), slope])
    covariance = np.linalg.pinv(jacobian.T @ jacobian) * residual / freedom
    spread = np.sqrt(np.maximum(np.einsum("ij,jk,ik->i", jacobian, covariance, jacobian), 0.0))
    half = float(t_distribution.ppf((1 + CONFIDENCE) / 2, freedom)) * spread

    threshold = residual * (1 + float(f_distribution.ppf(CONFIDENCE, 1, freedom)) / freedom)
    inside = np.flatnonzero(residuals <= threshold)
    c_low = c_high = c
    if len(inside):
        c_low = math.exp(grid[inside[0]]) if inside[0] > 0 else math.nan
        c_high = math.exp(grid[inside[-1]]) if inside[-1] < GRID - 1 else math.nan
    value = a + b * shape(n, c)
    aicc = corrected_akaike(residual, count, 4)
    return Curve(form, a, b, c, residual, aicc, c_low, c_high, value, value - half, value + half)


def _linear(column: Numbers, values: Numbers) -> tuple[float, float, float]:
    """Return a, b and the residual of values ~ a + b column."""
    centred = column - np.mean(column)
    size = float(centred @ centred)
    b = float(centred @ values) / size if size > 0 else 0.0
    a = float(np.mean(values)) - b * float(np.mean(column))
    residual = values - a - b * column
    return a, b, float(residual @ residual)


def _at_least_rounding(residual: float, values: Numbers) -> float:
    """Keep the logarithm finite where a curve goes exactly through the points."""
    scale = float(np.max(np.abs(values))) or 1.0
    return max(residual, len(values) * (RELATIVE_ZERO * scale) ** 2)
