"""Do band and intervals of a learning curve cover the truth, and is its shape found?

`python -m bench.learning.curves --series 1000` prints the table of docs/learning/curves.md.
"""

import math
from collections.abc import Callable, Iterator
from typing import Annotated, NamedTuple

import numpy as np
import typer
from numpy.typing import NDArray

from app.scoring.learning_fit import Curve, Form, fit_exponential, fit_level, fit_power

Numbers = NDArray[np.float64]
FITS: dict[Form, Callable[[Numbers, Numbers], Curve]] = {
    "exponential": fit_exponential,
    "power": fit_power,
    "level": lambda _n, values: fit_level(values),
}
HEAD = (
    "| truth | noise | trials | band covers | interval of tau or c covers | that shape is chosen |\n"
    "|---|---|---|---|---|---|"
)


class Truth(NamedTuple):
    """A learning person: the shape of the curve with tau (trials) or the exponent c; NaN for somebody who is level."""

    form: Form
    c: float

    def values(self, n: Numbers) -> Numbers:
        """Return the measure without noise at each trial (n,), counted from 1."""
        if self.form == "exponential":
            return np.asarray(1.5 + 4.0 * np.exp(-n / self.c))
        return np.asarray(1.0 + 5.0 * n**-self.c) if self.form == "power" else np.full(len(n), 3.0)


SHORT, LONG = Truth("exponential", 4.0), Truth("exponential", 12.0)
POWER, LEVEL = Truth("power", 0.7), Truth("level", math.nan)
CASES = (
    *((SHORT, noise, trials) for noise in (0.3, 0.8) for trials in (12, 22, 60)),
    *((truth, 0.5, trials) for truth in (LONG, POWER, LEVEL) for trials in (12, 22)),
)


class Outcome(NamedTuple):
    """What one series of trials showed."""

    in_band: float  # share of the trials at which the band of the true shape holds the truth
    in_interval: bool  # an open end counts as covering
    is_chosen: bool  # whether the true shape has the least AICc


def outcomes(truth: Truth, noise: float, trials: int, series: int, seed: int = 1) -> Iterator[Outcome]:
    """Yield the outcome of each of `series` series with normal noise of this standard deviation."""
    rng = np.random.default_rng(seed)
    n = np.arange(1.0, trials + 1.0)
    exact = truth.values(n)
    for _ in range(series):
        values = exact + rng.normal(0.0, noise, trials)
        curves = {form: fit(n, values) for form, fit in FITS.items()}
        own = curves[truth.form]
        low = -math.inf if math.isnan(own.c_low) else own.c_low
        high = math.inf if math.isnan(own.c_high) else own.c_high
        best = min(curves.values(), key=lambda curve: curve.aicc)
        in_band = float(np.mean((own.low <= exact) & (exact <= own.high)))
        yield Outcome(in_band, low <= truth.c <= high, best.form == truth.form)


def row(truth: Truth, noise: float, trials: int, series: int) -> str:
    """Return a line of the table."""
    in_band, in_interval, is_chosen = np.mean(list(outcomes(truth, noise, trials, series)), axis=0)
    named = truth.form if truth.form == "level" else f"{truth.form}, {truth.c:g}"
    interval = "" if truth.form == "level" else f"{in_interval:.3f}"
    return f"| {named} | {noise} | {trials} | {in_band:.3f} | {interval} | {is_chosen:.2f} |"


def main(series: Annotated[int, typer.Option(min=1, help="Of each kind.")] = 1000) -> None:
    """Print one line of the table for each kind of person, noise and number of trials."""
    typer.echo(HEAD)
    for truth, noise, trials in CASES:
        typer.echo(row(truth, noise, trials, series))


if __name__ == "__main__":
    typer.run(main)
