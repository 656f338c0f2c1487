"""How far a person's trials differ without a change: within a session, and from one session to the next.

All values are on the scale of their measure (`measure_comparison.py`).
"""

import math
from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from app.scoring.learning_fit import exponential

Numbers = NDArray[np.float64]
Sessions = NDArray[np.int64]

CURVE_TRIALS = 8  # with fewer trials there is no curve, only a level
TAUS = 12  # learning constants that are tried
CLINIC_WEIGHT = 2.0  # degrees of freedom of the clinic's median (docs/decisions/0023)
CLINIC_PEOPLE = 3  # with fewer other people the clinic has no median


class Variance(NamedTuple):
    """An estimated variance."""

    value: float
    df: float  # degrees of freedom; 0: nothing is known


def weighted_sum(*parts: tuple[float, Variance]) -> Variance:
    """Return the sum of weighted variances with Satterthwaite's degrees of freedom; 0 where one part has none.

    Source: Satterthwaite, Biometrics Bulletin 2 (1946).
    """
    value = sum(weight * part.value for weight, part in parts)
    if value <= 0 or any(part.df <= 0 for _, part in parts):
        return Variance(value, 0.0)
    return Variance(value, 1 / sum((weight * part.value / value) ** 2 / part.df for weight, part in parts))


class Series(NamedTuple):
    """One measure over trials, in the order driven, on its scale."""

    number: Numbers  # (n,) trial numbers, rising
    session: Sessions  # (n,) rising
    value: Numbers  # (n,)

    def where(self, chosen: NDArray[np.bool_]) -> "Series":
        """Return the chosen trials (n,)."""
        return Series(self.number[chosen], self.session[chosen], self.value[chosen])


class Spread(NamedTuple):
    """The variances of one person, or of a clinic, in one task and measure."""

    trial: Variance  # within a session
    session: Variance  # between sessions


def fit_curve(number: Numbers, value: Numbers, at: Numbers) -> tuple[Numbers, int]:
    """Return the learning curve through `value` (n,) at the trial numbers `at` (m,), and how many parameters it has.

    It is a level line, or a + b exp(-n / tau) where that has the smaller AICc. tau is the best of a row of values: the
    curve is subtracted here, never shown. A curve that is shown is fitted by `learning_fit.py`.
    """
    level = float(np.mean(value))
    count, span = len(value), float(number[-1] - number[0])
    if count < CURVE_TRIALS or span <= 0:
        return np.full(len(at), level), 1
    centred = value - level
    squares = float(centred @ centred)
    log_taus = np.linspace(0.0, math.log(2 * span), TAUS)
    shapes = np.exp(-(number - number[0]) / np.exp(log_taus)[:, None])  # (TAUS, n)
    middles = shapes.mean(axis=1)
    shapes -= middles[:, None]
    along = shapes @ centred
    steep = np.einsum("ij,ij->i", shapes, shapes)
    rest = np.maximum(squares - along**2 / steep, 0.0)
    best = int(rest.argmin())
    if _aicc(float(rest[best]), count, 4) >= _aicc(squares, count, 2):
        return np.full(len(at), level), 1
    b = float(along[best] / steep[best])
    return level + b * (exponential(at - number[0], float(log_taus[best]))[0] - float(middles[best])), 3


def _aicc(squares: float, count: int, parameters: int) -> float:
    """Return AICc of a least-squares fit; `parameters` includes the variance."""
    correction = 2 * parameters * count / (count - parameters - 1)
    return count * math.log(max(squares, 1e-24) / count) + correction


def own_spread(before: Series, later: Series | None = None, least: float = 0.0) -> tuple[Spread, float]:
    """Return a person's spread, and the mean of 1 / trials over the sessions that the session's variance is of.

    Parameters
    ----------
    before
        All trials before the later ones of a comparison. From these both variances are estimated.
    later
        The later trials, of one session. Only their spread within it is used: a change of their level does not count
        as noise. The session's trials in `before` do not count for the variance between sessions either.
    least
        The smallest standard deviation within a session.

    Notes
    -----
    Within a session: around the learning curve, the mean of each session, and a slope that all sessions share. Between
    sessions: means of the residuals of the learning curve. The variance of these means contains the variance within a
    session over its trials; `session` is not freed of it (see `pool_spreads`).
    """
    fitted = _residuals(before)
    parts = [(before.session, fitted[0])]
    if later is not None and len(later.value) > 1:
        parts.append((later.session, _residuals(later)[0]))
    places, values, sessions = [], [], 0
    for session, residual in parts:
        _, first, count = np.unique(session, return_index=True, return_counts=True)
        sessions += len(count)
        places.append(np.arange(len(session)) - np.repeat(first + (count - 1) / 2, count))
        values.append(residual - np.repeat(np.add.reduceat(residual, first) / count, count))
    trial = _around_slope(np.concatenate(places), np.concatenate(values), sessions)
    trial = Variance(max(trial.value, least**2), trial.df)
    if later is not None and (others := before.session != later.session[0]).sum() < len(others):
        before = before.where(others)
        fitted = _residuals(before)
    between, share = _between_sessions(before.session, *fitted)
    return Spread(trial, between), share


def course_spread(series: Series, least: float = 0.0) -> tuple[Spread, float]:
    """Return the spread of all of a person's trials around their learning curve, and the mean of 1 / trials as above.

    Of the curve's three parameters, level and size are counted among those of the session means; how fast it falls is
    told by the trials within the sessions.
    """
    own, _ = own_spread(series, None, least)
    residual, parameters = _residuals(series)
    between, share = _between_sessions(series.session, residual, min(parameters, 2))
    return Spread(own.trial, between), share


def _residuals(series: Series) -> tuple[Numbers, int]:
    """Return the values less the learning curve (n,), and how many parameters the curve has."""
    if not len(series.value):
        return series.value, 1
    curve, parameters = fit_curve(series.number, series.value, series.number)
    return series.value - curve, parameters


def _around_slope(place: Numbers, value: Numbers, sessions: int) -> Variance:
    """Return the variance around the slope that all sessions share, with one degree of freedom less for it.

    Places and values (n,), both less the mean of their session.
    """
    df = len(value) - sessions
    steep = float(place @ place)
    if df < 2 or steep == 0:
        return Variance(float(value @ value) / df, df) if df > 0 else Variance(0.0, 0.0)
    rest = value - float(place @ value) / steep * place
    return Variance(float(rest @ rest) / (df - 1), df - 1)


def _between_sessions(session: Sessions, residual: Numbers, parameters: int) -> tuple[Variance, float]:
    """Return the variance of the session means around the learning curve, and the mean of 1 / trials of a session."""
    if not len(session):
        return Variance(0.0, 0.0), 1.0
    _, place, count = np.unique(session, return_inverse=True, return_counts=True)
    share = float(np.mean(1.0 / count))
    df = len(count) - parameters
    if df < 1:
        return Variance(0.0, 0.0), share
    means = np.bincount(place, residual) / count
    if parameters == 1:
        means = means - means.mean()
    return Variance(float(means @ means) / df, float(df)), share


def pool_spreads(own: Spread, share: float, clinic: Spread | None) -> Spread:
    """Return a person's spread, drawn towards the clinic's median as far as little is known of the person.

    Both are weighted by their degrees of freedom. Those of the variance between sessions are Satterthwaite's for a
    difference of two variances, taken at the clinic's median. Without a clinic's median the variance of the session
    means stands for the variance between sessions: that errs on the side of more noise.
    """
    if clinic is None:
        return own
    trial = _weighted(own.trial, clinic.trial)
    noise = share * trial.value
    total, df = clinic.session.value + noise, 0.0
    if own.session.df > 0 and total > 0:
        error = 1 / own.session.df + (noise / total) ** 2 / trial.df
        df = (clinic.session.value / total) ** 2 / error
    between = Variance(max(own.session.value - noise, 0.0), df)
    return Spread(trial, _weighted(between, clinic.session))


def _weighted(own: Variance, clinic: Variance) -> Variance:
    df = own.df + clinic.df
    return Variance((own.df * own.value + clinic.df * clinic.value) / df, df)


class PersonVariances(NamedTuple):
    """The variances of one person in one task and measure, each freed of its bias."""

    trial: float  # within a session
    session: float | None  # between sessions; None: of one session


def person_variances(series: Series, least: float = 0.0) -> PersonVariances | None:
    """Return a person's variances for the clinic's median; None with too few trials.

    A variance with few degrees of freedom is more often too small than too large, so each is divided by the median of
    chi-squared over its degrees of freedom (Wilson and Hilferty, PNAS 17 (1931)).
    """
    own, share = own_spread(series, None, least)
    if own.trial.df < 2:
        return None
    within = max(own.trial.value / _median_share(own.trial.df), least**2)
    if own.session.df < 1:
        return PersonVariances(within, None)
    between = own.session.value / _median_share(own.session.df)
    return PersonVariances(within, max(between - share * own.trial.value, 0.0))


def median_spread(people: Sequence[PersonVariances]) -> Spread | None:
    """Return the medians of people's variances; None when fewer than 3 people have enough trials."""
    trial = [one.trial for one in people]
    session = [one.session for one in people if one.session is not None]
    if len(session) < CLINIC_PEOPLE:
        return None
    return Spread(
        Variance(float(np.median(trial)), CLINIC_WEIGHT),
        Variance(float(np.median(session)), CLINIC_WEIGHT),
    )


def _median_share(df: float) -> float:
    """Return the median of chi-squared over its degrees of freedom."""
    return float((1 - 2 / (9 * df)) ** 3)
