"""What a page says of simulated people: the words on sessions, the sentence on all of them, and on a deterioration.

`python -m bench.learning.verdicts` prints its tables, for docs/learning/verdicts.md.
"""

import math
from collections.abc import Sequence

import numpy as np
import typer

from app.scoring.verdict.change_over_sessions import course_change
from app.scoring.verdict.deterioration import deteriorations
from app.scoring.verdict.leading_measures import leading_of_task
from app.scoring.verdict.spread import Spread
from app.scoring.verdict.verdicts import task_verdicts
from bench.learning.simulated_trials import LEADING, Course, Row, trials

CHANGE = ("better", "worse")
AREA = LEADING[:1]
LEVELS = (0.01, 0.02, 0.03, 0.04, 0.06, 0.1)
LONG = (5,) * 20
THREES = (3,) * 7  # eight sessions of three trials, of which the first is for getting used to the task


def words_on_page(rows: list[Row], clinic: dict[str, Spread]) -> set[str]:
    """Return what a page says of these trials that is more than noise: "sessions", "course", "deterioration"."""
    found = task_verdicts(rows, clinic)
    words = [one.word for pair in found.sessions for one in pair.verdicts.values()]
    is_told = {
        "sessions": any(word in CHANGE for word in words),
        "course": tells_course(rows, clinic),
        "deterioration": bool(found.deterioration),
    }
    return {place for place, told in is_told.items() if told}


def tells_course(rows: list[Row], clinic: dict[str, Spread]) -> bool:
    """Return whether the sentence on all sessions tells a change in one of the measures."""
    leading = leading_of_task(rows)
    return any(course_change(name, rows, leading, clinic).word in CHANGE for name in leading)


def least_of_course(rows: list[Row], clinic: dict[str, Spread]) -> float:
    """Return the smallest level at which the sentence on all sessions tells a change in one of the measures."""
    leading = leading_of_task(rows)
    p_values = [course_change(name, rows, leading, clinic).p_value for name in leading]
    return len(leading) * min((one for one in p_values if one is not None), default=1.0)


def alarms_of(rows: list[Row], clinic: dict[str, Spread]) -> tuple[bool, bool]:
    """Return whether a deterioration is told after any session, and after the last one."""
    sessions = sorted({row["session"] for row in rows})
    found = [bool(deteriorations([row for row in rows if row["session"] <= one], clinic)) for one in sessions]
    return any(found), found[-1]


class People:
    """Simulated people, each with the median of a clinic, or without."""

    def __init__(self, count: int, offers: Sequence[Spread], seed: int = 1) -> None:
        """`offers` are the medians of several clinics; none of them: a clinic of nobody else."""
        self.count, self.offers, self.seed = count, offers, seed

    def rows(self, course: Course, names: Sequence[str] = LEADING) -> list[tuple[list[Row], dict[str, Spread]]]:
        """Return the trials of everybody, with the medians of their clinic."""
        rng = np.random.default_rng(self.seed)
        found = []
        for i in range(self.count):
            within, between = rng.uniform(0.1, 0.4), rng.uniform(0.05, 0.2)
            offer = self.offers[i % len(self.offers)] if self.offers else None
            clinic = {} if offer is None else dict.fromkeys(names, offer)
            found.append((trials(rng, within, between, course, names), clinic))
        return found

    def alarms(self, course: Course, names: Sequence[str] = AREA) -> tuple[float, float, float]:
        """Return the share of trials that missed the goal, and of people called worse at any time, and at the end."""
        people = self.rows(course, names)
        missed = float(np.mean([not row["reached"] for rows, _ in people for row in rows]))
        ever, at_end = np.mean([alarms_of(*one) for one in people], axis=0).tolist()
        return missed, ever, at_end

    def words(self, course: Course, names: Sequence[str] = LEADING) -> dict[str, float]:
        """Return the shares of people of whom a page says something in each of its places, and in any."""
        said = [words_on_page(*one) for one in self.rows(course, names)]
        places = ("sessions", "course", "deterioration")
        return {place: sum(place in one for one in said) / len(said) for place in places} | {
            "page": sum(bool(one) for one in said) / len(said)
        }


def steady(_session: int, _number: int) -> float:
    """No change."""
    return 0.0


def learning(_session: int, number: int) -> float:
    """From three times the level, learning constant 6 trials."""
    return math.log1p(2.0 * math.exp(-(number - 1) / 6.0))


def worse(session: int, _number: int) -> float:
    """60 % worse from session 11 on."""
    return math.log(1.6) * (session > 10)


DETERIORATIONS = {
    "steady": Course(LONG, steady),
    "steady, trials correlated by 0.5": Course(LONG, steady, correlation=0.5),
    "learning": Course(LONG, learning),
    "30 % worse from session 11 on": Course(LONG, lambda session, _: math.log(1.3) * (session > 10)),
    "60 % worse from session 11 on": Course(LONG, worse),
    "5 % worse with each session from 11 on": Course(LONG, lambda session, _: math.log(1.05) * max(session - 10, 0)),
    "steady, missed beyond 1.6 times the level": Course(LONG, steady, limit=1.6),
    "60 % worse, missed beyond 1.6 times the level": Course(LONG, worse, limit=1.6),
    "steady, missed beyond 1.3 times the level": Course(LONG, steady, limit=1.3),
    "60 % worse, missed beyond 1.3 times the level": Course(LONG, worse, limit=1.3),
    "steady, 3 in 10 missed": Course(LONG, missed=lambda _: 0.3),
    "60 % worse, 3 in 10 missed, then 6 in 10": Course(LONG, worse, missed=lambda one: 0.6 if one > 10 else 0.3),
    "60 % worse, none missed, then 8 in 10": Course(LONG, worse, missed=lambda one: 0.8 if one > 10 else 0.0),
}
UNCHANGED = {
    "4 sessions of 5": Course((5,) * 4),
    "10 sessions of 5": Course((5,) * 10),
    "7 sessions of 3": Course(THREES),
    "6 sessions of 5, trials correlated by 0.5": Course((5,) * 6, correlation=0.5),
    "7 sessions of 3, trials correlated by 0.5": Course(THREES, correlation=0.5),
    "10 sessions of 5, trials correlated by 0.5": Course((5,) * 10, correlation=0.5),
    "1 session of 28, trials correlated by 0.5": Course((28,), correlation=0.5),
    "4 sessions of 5, 3 in 10 missed": Course((5,) * 4, missed=lambda _: 0.3),
}
CHANGED = {
    "half of the level in the newest session": Course(THREES, lambda session, _: math.log(0.5) * (session > 6)),
    "half of the level, evenly over the sessions": Course(THREES, lambda session, _: math.log(0.5) * session / 7),
    "half of the level in the last four sessions": Course(THREES, lambda session, _: math.log(0.5) * (session > 3)),
}

CHANGED_IN_ONE = {f"{title}, in one measure": course._replace(changes=1) for title, course in CHANGED.items()}


def print_pages(people: int, offers: Sequence[Spread], seed: int) -> None:
    """Print the shares of people of whom something is said."""
    clinics = People(people, offers, seed), People(people, (), seed)
    typer.echo("\n| three measures | others | words on sessions | sentence on all | deterioration | any of a page |")
    typer.echo("|---|---|---|---|---|---|")
    for title, course in (UNCHANGED | CHANGED_IN_ONE | CHANGED).items():
        for group in clinics:
            shares = " | ".join(f"{share:.1%}" for share in group.words(course).values())
            typer.echo(f"| {title} | {'a clinic' if group.offers else 'none'} | {shares} |")


def print_levels(people: int, offers: Sequence[Spread], seed: int) -> None:
    """Print what the sentence on all sessions would say at other levels."""
    typer.echo(f"\n| 7 sessions of 3 | others | {' | '.join(f'{level:.0%}' for level in LEVELS)} |")
    typer.echo("|---|---|" + "---|" * len(LEVELS))
    titles = ("7 sessions of 3", "7 sessions of 3, trials correlated by 0.5")
    courses = {title: UNCHANGED[title] for title in titles} | CHANGED_IN_ONE | CHANGED
    for title, course in courses.items():
        for group in (People(people, offers, seed), People(people, (), seed)):
            found = np.array([least_of_course(*one) for one in group.rows(course)])
            shares = " | ".join(f"{np.mean(found <= level):.1%}" for level in LEVELS)
            typer.echo(f"| {title} | {'a clinic' if group.offers else 'none'} | {shares} |")


def print_deteriorations(people: int, offers: Sequence[Spread], seed: int) -> None:
    """Print the shares of people who are called worse."""
    group = People(people, offers, seed)
    typer.echo("\n| 20 sessions of 5 | trials missed | called worse at any time | at the end |")
    typer.echo("|---|---|---|---|")
    for title, course in DETERIORATIONS.items():
        missed, ever, at_end = group.alarms(course, LEADING if title.startswith("steady") else AREA)
        typer.echo(f"| {title} | {missed:.0%} | {ever:.0%} | {at_end:.0%} |")
