"""How far a person's trials differ without a change: within a session, and from one session to the next.

All values are on the scale of their measure (`measure_scales.py`).
"""

import math
from collections.abc import Callable, Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from app.scoring.learning_fit import exponential
from app.source import SourceGroup

Numbers = NDArray[np.float64]
Sessions = NDArray[np.int64]

CURVE_TRIALS = 8  # with fewer trials there is no curve, only a level
TAUS = 12  # learning constants that are tried
CLINIC_WEIGHT = 2.0  # degrees of freedom of the clinic's median variance within a session (docs/decisions/0023)
SESSION_WEIGHT = 4.0  # and of its median between sessions, of which each person has few (docs/learning/verdicts.md)
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
    """The median variances of a clinic's people in one task and measure."""

    trial: Variance  # within a session
    session: Variance  # between sessions


SpreadsOf = Callable[[str, str, SourceGroup], dict[str, Spread]]
"""Returns the median spreads of the clinic's other patients, by floor plan, path and source."""


class OwnSpread(NamedTuple):
    """The variances of one person in one task and measure."""

    trial: Variance  # within a session
    mean: Variance  # of the means of sessions: it contains the trials' share
    share: float  # mean of 1 / trials over the sessions that `mean` is of

    def of_difference(self, sessions: float, trials: float) -> Variance:
        """Return the variance of a difference that consists of means of sessions, with its degrees of freedom.

        Parameters
        ----------
        sessions
            The sum of 1 / sessions of its sets, 1 / m1 + 1 / m2.
        trials
            The sum of 1 / trials of its sets, 1 / k1 + 1 / k2.

        Notes
        -----
        It is s_session^2 (1 / m1 + 1 / m2) + s_trial^2 (1 / k1 + 1 / k2), written with the variance of the means of
        sessions, `s_session^2 + share s_trial^2`: trials of one session resemble each other, and their means do not.
        Sets of trials within one session differ by the second term alone, which also is the least. The degrees of
        freedom are Satterthwaite's, and where a set has more trials than usual not fewer than those of the means.
        """
        within = weighted_sum((trials, self.trial))
        if not sessions:
            return within
        total = weighted_sum((sessions, self.mean), (trials - self.share * sessions, self.trial))
        return Variance(max(total.value, within.value), max(total.df, min(self.mean.df, within.df)))


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


def own_spread(before: Series, later: Series | None = None, least: float = 0.0) -> OwnSpread:
    """Return a person's spread as far as it is known from their own trials.

    Parameters
    ----------
    before
        All trials before the later ones of a comparison. From these both variances are estimated.
    later
        The later trials. They are looked at apart, so that a change of their level does not count as noise: their
        spread within sessions, and that between sessions where they are of several. The first of their sessions does
        not count for the variance between sessions with its trials in `before`.
    least
        The smallest standard deviation within a session.

    Notes
    -----
    Within a session: around the learning curve, the mean of each session, and a slope that all sessions share. Means of
    sessions: of the residuals of the learning curve.
    """
    fitted = _residuals(before)
    parts = [(before.session, fitted[0])]
    later_part = [] if later is None else [(later.session, *_residuals(later))]
    if later is not None and len(later.value) > 1:
        parts.append(later_part[0][:2])
    places, values, sessions = [], [], 0
    for session, residual in parts:
        _, first, count = np.unique(session, return_index=True, return_counts=True)
        sessions += len(count)
        places.append(np.arange(len(session)) - np.repeat(first + (count - 1) / 2, count))
        values.append(residual - np.repeat(np.add.reduceat(residual, first) / count, count))
    trial = _around_slope(np.concatenate(places), np.concatenate(values), sessions)
    trial = Variance(max(trial.value, least**2), trial.df)
    if later is not None and (in_other_sessions := before.session != later.session[0]).sum() < len(in_other_sessions):
        before = before.where(in_other_sessions)
        fitted = _residuals(before)
    return OwnSpread(trial, *_between_sessions((before.session, *fitted), *later_part))


def course_spread(series: Series, least: float = 0.0) -> OwnSpread:
    """Return the spread of all of a person's trials around their course: a straight line or their learning curve.

    A change that goes on from session to session does not count as noise. Of the curve's three parameters, level and
    size are counted among those of the session means; how fast it falls is told by the trials within the sessions.
    """
    spread = own_spread(series, None, least)
    residual, parameters = _residuals(series)
    if parameters == 1:
        residual = _around_line(series.session, residual)
    return OwnSpread(spread.trial, *_between_sessions((series.session, residual, 2)))


def _around_line(session: Sessions, residual: Numbers) -> Numbers:
    """Return residuals (n,) less the straight line through the means of their sessions, in the order of these."""
    _, place, count = np.unique(session, return_inverse=True, return_counts=True)
    if len(count) < 2:
        return residual
    along = np.arange(len(count)) - (len(count) - 1) / 2
    slope = float(along @ (np.bincount(place, residual) / count)) / float(along @ along)
    return residual - slope * along[place]


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


def _between_sessions(*parts: tuple[Sessions, Numbers, int]) -> tuple[Variance, float]:
    """Return the variance of session means, each part's around its own curve, and the mean of 1 / trials of a session.

    A part is the sessions and the residuals of its trials (n,), and the parameters of its curve.
    """
    squares, df = 0.0, 0
    shares: list[float] = []
    for session, residual, parameters in parts:
        _, place, count = np.unique(session, return_inverse=True, return_counts=True)
        free = len(count) - parameters
        if free >= 1:
            means = np.bincount(place, residual) / count
            squares += float(np.sum((means - means.mean()) ** 2))
            df += free
        if free >= 1 or not shares:
            shares += (1.0 / count).tolist()
    return Variance(squares / df if df else 0.0, float(df)), float(np.mean(shares)) if shares else 1.0


def pool_spreads(own: OwnSpread, clinic: Spread | None) -> OwnSpread:
    """Return a person's spread, drawn towards the clinic's median as far as little is known of the person.

    Both are weighted by their degrees of freedom. Without a clinic's median, sessions are taken to differ as much as
    trials within a session do, where the person has sessions enough to say more: that holds on any scale.
    """
    if clinic is None:
        if own.trial.df <= 0 or own.mean.df <= 0:
            return own
        clinic = Spread(Variance(0.0, 0.0), Variance(own.trial.value, SESSION_WEIGHT))
    trial = _weighted(own.trial, clinic.trial)
    usual = Variance(clinic.session.value + own.share * trial.value, clinic.session.df)
    return OwnSpread(trial, _weighted(own.mean, usual), own.share)


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
    spread = own_spread(series, None, least)
    if spread.trial.df < 2:
        return None
    within = max(spread.trial.value / _median_share(spread.trial.df), least**2)
    if spread.mean.df < 1:
        return PersonVariances(within, None)
    between = spread.mean.value / _median_share(spread.mean.df)
    return PersonVariances(within, max(between - spread.share * spread.trial.value, 0.0))


def median_spread(people: Sequence[PersonVariances]) -> Spread | None:
    """Return the medians of people's variances; None when fewer than 3 people have enough trials."""
    trial = [variances.trial for variances in people]
    session = [variances.session for variances in people if variances.session is not None]
    if len(session) < CLINIC_PEOPLE:
        return None
    return Spread(
        Variance(float(np.median(trial)), CLINIC_WEIGHT),
        Variance(float(np.median(session)), SESSION_WEIGHT),
    )


def _median_share(df: float) -> float:
    """Return the median of chi-squared over its degrees of freedom."""
    return float((1 - 2 / (9 * df)) ** 3)
