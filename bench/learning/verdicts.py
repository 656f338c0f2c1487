"""Checks the verdicts "better than noise" and "worse than noise" on many simulated people.

`python -m bench.learning.verdicts` prints the tables of docs/learning/verdicts.md. A simulated person has a level, a
spread between trials and a spread between sessions, both as shares of the level. The clinic's median comes from other
simulated people, twenty for each clinic.
"""

import math
from collections.abc import Iterator, Sequence
from typing import Annotated, Any, NamedTuple

import numpy as np
import typer
from numpy.typing import NDArray

from app.scoring.verdict.detectable_change import noise_of
from app.scoring.verdict.measure_scales import least_spread
from app.scoring.verdict.measure_verdict import clinic_spreads, compare, people_variances, series_of
from app.scoring.verdict.spread import Spread, own_spread, pool_spreads
from bench.learning.words_told import print_deteriorations, print_levels, print_pages

MEASURE = "e_diff"
LEVEL = 3.0  # m2
WITHIN = (0.1, 0.4)  # of the level
BETWEEN = (0.05, 0.2)
CLINICS, PEOPLE_OF_CLINIC = 25, 20
# Trials of each session: 5, 10 and 20 trials in all, after those for getting used to the task.
LAYOUTS = ((3, 2), (5, 5), (2,) * 5, (5,) * 4, (10, 10), (2,) * 10)
ONE_SESSION = ((5,), (10,), (20,))

Numbers = NDArray[np.float64]
Row = dict[str, Any]


class Person(NamedTuple):
    """The spreads of a simulated person, as shares of the level."""

    within: float
    between: float


CELLS = {
    "10 %, 5 %": Person(0.1, 0.05),
    "10 %, 20 %": Person(0.1, 0.2),
    "25 %, 12 %": Person(0.25, 0.125),
    "40 %, 5 %": Person(0.4, 0.05),
    "40 %, 20 %": Person(0.4, 0.2),
}


class Outcome(NamedTuple):
    """What a simulated person was told, without a change and with two kinds of change."""

    false: bool  # better or worse, without a change
    found: bool  # better, after a change of twice the MDC that was estimated for the person
    found_true: bool  # better, after a change of twice the MDC at the person's true spread


def draw_person(rng: np.random.Generator) -> Person:
    """Return a person whose spreads are drawn evenly from their ranges."""
    return Person(float(rng.uniform(*WITHIN)), float(rng.uniform(*BETWEEN)))


def drive(
    rng: np.random.Generator, person: Person, layout: Sequence[int], curve: Numbers | None = None, shape: str = "log"
) -> list[Row]:
    """Return the trials of one person, a session for each entry of `layout`.

    `curve` (n,) is the learning curve as the logarithm of shares of the level. The noise multiplies the level
    (`log`, log-normal), or is added to it (`added`, normal, and never below 2 % of the level).
    """
    session = np.repeat(np.arange(len(layout)), layout)
    noise = rng.normal(0.0, 1.0, len(layout))[session], rng.normal(0.0, 1.0, len(session))
    if shape == "log":
        parts = (math.sqrt(math.log1p(part**2)) for part in (person.between, person.within))
        value = np.exp(sum(size * one for size, one in zip(parts, noise, strict=True)))
    else:
        value = np.maximum(1.0 + person.between * noise[0] + person.within * noise[1], 0.02)
    value = LEVEL * value * (1.0 if curve is None else np.exp(curve))
    return [
        {"id": i, "number": i, "session": int(session[i - 1]) + 1, "familiarisation": False, MEASURE: float(one)}
        for i, one in enumerate(value, start=1)
    ]


def clinics(rng: np.random.Generator, shape: str = "log", count: int = CLINICS) -> list[Spread]:
    """Return the median spreads of several clinics, each of its own twenty people with 4 to 40 trials."""
    found = []
    for _ in range(count):
        people = [
            drive(rng, draw_person(rng), [int(rng.choice([2, 3, 5]))] * int(rng.integers(2, 9)), shape=shape)
            for _ in range(PEOPLE_OF_CLINIC)
        ]
        found.append(clinic_spreads(people_variances(dict(enumerate(people))))[MEASURE])
    return found


def judge(rng: np.random.Generator, person: Person, layout: Sequence[int], clinic: Spread, shape: str) -> Outcome:
    """Compare the last session with the one before, or in one session the last trial with the one before."""
    series, _ = series_of(drive(rng, person, layout, shape=shape), MEASURE)
    if len(layout) == 1:
        later = np.arange(len(series.value)) == len(series.value) - 1
        earlier = np.roll(later, -1)
    else:
        later, earlier = series.session == len(layout), series.session == len(layout) - 1
    plain = compare(MEASURE, series, earlier, later, clinic)
    counts = int(earlier.sum()), int(later.sum())
    own = own_spread(series.where(~later), series.where(later), least_spread(MEASURE, series.value))
    spread = pool_spreads(own, clinic)
    noise = noise_of(spread, *counts, same_session=len(layout) == 1)
    if plain is None or noise is None:
        raise RuntimeError("a verdict is missing")
    within, between = (math.log1p(part**2) for part in person)
    truth = within * (1 / counts[0] + 1 / counts[1]) + (0.0 if len(layout) == 1 else 2 * between)
    estimated = spread.of_difference(0.0 if len(layout) == 1 else 2.0, 1 / counts[0] + 1 / counts[1])
    t = noise.mdc / math.sqrt(estimated.value)
    words = []
    for mdc in (noise.mdc, t * math.sqrt(truth)):
        changed = series._replace(value=series.value - 2 * mdc * later)
        verdict = compare(MEASURE, changed, earlier, later, clinic)
        words.append(verdict is not None and verdict.word == "better")
    return Outcome(plain.word in ("better", "worse"), *words)


def outcomes(
    layout: Sequence[int], people: int, person: Person | None = None, shape: str = "log", seed: int = 1
) -> Outcome:
    """Return the shares of many people; all are like `person`, or each is drawn."""
    rng = np.random.default_rng(seed)
    offers = clinics(rng, shape)
    found = [judge(rng, person or draw_person(rng), layout, offers[i % len(offers)], shape) for i in range(people)]
    return Outcome(*(float(np.mean(column)) for column in zip(*found, strict=True)))  # type: ignore[arg-type]


def layout_words(layout: Sequence[int]) -> str:
    """Return how the trials lie in sessions, in words."""
    if len(layout) == 1:
        return f"{layout[0]} in one session, the last against the one before"
    if len(set(layout)) > 1:
        return f"{sum(layout)}: {' and '.join(map(str, layout))}"
    return f"{sum(layout)}: {len(layout)} sessions of {layout[0]}"


def print_verdicts(people: int) -> None:
    """Print the shares for people drawn from the ranges."""
    typer.echo("| trials | noise | told better or worse without a change | better after 2 MDC (estimated) | (true) |")
    typer.echo("|---|---|---|---|---|")
    for layout in (*LAYOUTS, *ONE_SESSION):
        for shape, words in (("log", "log-normal"), ("added", "normal")):
            share = outcomes(layout, people, shape=shape)
            typer.echo(
                f"| {layout_words(layout)} | {words} | {share.false:.1%} | {share.found:.1%} | {share.found_true:.1%} |"
            )


def print_cells(people: int) -> None:
    """Print what people are told falsely who all have the same spreads."""
    typer.echo(f"\n| trials | {' | '.join(CELLS)} |")
    typer.echo("|---|" + "---|" * len(CELLS))
    for layout in LAYOUTS:
        shares = [outcomes(layout, people, person) for person in CELLS.values()]
        row = " | ".join(f"{share.false:.1%}, {share.found:.0%}, {share.found_true:.0%}" for share in shares)
        typer.echo(f"| {layout_words(layout)} | {row} |")


def learners(people: int, seed: int = 1) -> Iterator[tuple[str, float]]:
    """Yield what improving people are told: a curve from three times the level, constant 6 trials, 4 sessions of 5."""
    rng = np.random.default_rng(seed)
    offers, layout = clinics(rng), (5,) * 4
    curve = np.log1p(2.0 * np.exp(-np.arange(20) / 6.0))
    words: dict[str, list[str]] = {"the last session against the first": [], "the last against the one before": []}
    for i in range(people):
        series, _ = series_of(drive(rng, draw_person(rng), layout, curve), MEASURE)
        for name, session in zip(words, (1, 3), strict=True):
            verdict = compare(MEASURE, series, series.session == session, series.session == 4, offers[i % len(offers)])
            words[name].append("" if verdict is None else verdict.word)
    for name, said in words.items():
        for word in ("better", "worse"):
            yield f"{name}: {word}", said.count(word) / people


def main(
    people: Annotated[int, typer.Option(min=20, help="Simulated people of each row.")] = 1000,
    seed: Annotated[int, typer.Option(help="The people whose pages are judged.")] = 1,
) -> None:
    """Print the tables of docs/learning/verdicts.md."""
    print_verdicts(people)
    print_cells(people)
    typer.echo("")
    for words, share in learners(people):
        typer.echo(f"learning people, {words}: {share:.1%}")
    offers = clinics(np.random.default_rng(seed))
    print_pages(people, offers, seed)
    print_levels(people, offers, seed)
    print_deteriorations(people, offers, seed)


if __name__ == "__main__":
    typer.run(main)
