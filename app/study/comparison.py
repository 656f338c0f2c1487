"""Comparison of E_diff with a fixed and with an adapted map, for the same seeds of simulated people."""

from collections.abc import Sequence
from typing import TypedDict

import numpy as np
from numpy.typing import NDArray

from app.number_format import percent, signed_percent
from app.plain_table import table_lines
from app.study.sessions import StudySessionTrial
from app.texts import Figure, Text, value_text

RESAMPLES = 9999
CONFIDENCE = 0.95
CLAIM = -0.25  # relative difference of E_diff in the last session that is claimed
FELT_LIMIT = 0.10  # largest felt change of one adaptation step
LEAST_AREA = 0.01  # m2, least divisor of a relative difference

SESSION_COLUMNS = (
    *("session", "fixed", "adapted", "reached-fixed", "reached-adapted"),
    *("both-drove", "relative-there", "interval"),
)
SEED_COLUMNS = ("seed", "fixed", "adapted", "relative", "reached-fixed", "reached-adapted")

Interval = tuple[float, float]


class SessionAreas(TypedDict):
    """E_diff in one session with both maps."""

    session: int
    fixed: float  # m2
    adapted: float  # m2
    reached_fixed: float  # share of the trials
    reached_adapted: float
    seeds_that_always_drove: int  # with both maps
    relative: float | None  # over those seeds
    interval: Interval | None


class SeedAreas(TypedDict):
    """E_diff of one seed in the last session with both maps."""

    seed: int
    fixed: float  # m2
    adapted: float  # m2
    relative: float
    reached_fixed: float  # share of the trials
    reached_adapted: float


class LastSession(TypedDict):
    """The last session, seed by seed."""

    session: int
    per_seed: list[SeedAreas]
    median_relative: float | None
    interval: Interval | None


class LaterSessions(TypedDict):
    """All trials from the second session on."""

    fixed: float  # m2, mean
    adapted: float  # m2, mean
    relative: float
    interval: Interval | None
    reached_fixed: float  # share of the trials
    reached_adapted: float


class Proposals(TypedDict):
    """After how many trials of a seed something was proposed."""

    per_seed: list[int]
    median: float
    most: int


class AppliedSteps(TypedDict):
    """The steps that were applied."""

    steps: int
    largest_felt_change: float
    largest_turn_deg: float
    sign_flips: int


class MapComparison(TypedDict):
    """A fixed and an adapted map over the same seeds, ready for JSON."""

    seeds: int
    sessions: list[SessionAreas]
    last_session: LastSession
    proposals: Proposals
    later_sessions: LaterSessions | None  # None: there is one session only
    last_session_in_which_most_drove_with_both: SessionAreas | None
    applied: AppliedSteps
    claim_holds: bool


def compare(fixed: Sequence[StudySessionTrial], other: Sequence[StudySessionTrial]) -> MapComparison:
    """Return the comparison over seeds, ready for JSON.

    Per session: the median over seeds of each seed's mean E_diff (m2), the share of trials that reached the goal, and
    the median of (adapted - fixed) / fixed over the seeds that reached the goal in all trials of both conditions. For
    the last session also each seed's figures, and a bootstrap interval of the median (scipy, percentile, 95 %). From
    the second session on also the means over all trials, and the interval of their ratio over the seeds.

    A trial that did not reach the goal has an area, too: that between its trajectory, or the place where the chair
    stood, and the path. The shares of trials that reached the goal are therefore given beside the areas.
    """
    seeds = sorted({row.seed for row in fixed})
    last = max(row.session for row in fixed)
    sessions = [_session(fixed, other, seeds, number) for number in range(1, last + 1)]
    before, after = (_means(rows, seeds, last) for rows in (fixed, other))
    relative = _relative(before, after)
    driving = [session for session in sessions if session["seeds_that_always_drove"] >= max(2, len(seeds) // 2)]
    applied = [row for row in other if row.mode == "auto"]
    median, interval = _median(relative)
    felt = max((row.felt_change for row in applied), default=0.0)
    flips = sum(row.flips for row in applied)
    return {
        "seeds": len(seeds),
        "sessions": sessions,
        "last_session": {
            "session": last,
            "per_seed": [
                {
                    "seed": seed,
                    "fixed": float(before[i]),
                    "adapted": float(after[i]),
                    "relative": float(relative[i]),
                    "reached_fixed": _reached(fixed, seed, last),
                    "reached_adapted": _reached(other, seed, last),
                }
                for i, seed in enumerate(seeds)
            ],
            "median_relative": median,
            "interval": interval,
        },
        "proposals": _proposals(other, seeds),
        "later_sessions": _later_sessions(fixed, other, seeds) if last > 1 else None,
        "last_session_in_which_most_drove_with_both": driving[-1] if driving else None,
        "applied": {
            "steps": sum(row.proposed > 0 for row in applied),
            "largest_felt_change": felt,
            "largest_turn_deg": max((row.angle_deg for row in applied), default=0.0),
            "sign_flips": flips,
        },
        "claim_holds": bool(
            median is not None
            and interval is not None
            and median <= CLAIM
            and interval[1] < 0.0
            and felt <= FELT_LIMIT
            and not flips
        ),
    }


def table(comparison: MapComparison) -> str:
    """Return the comparison as text: the sessions, the seeds of the last session, and a sentence."""
    last = comparison["last_session"]
    lines = [
        str(Text("study-area-title")),
        *_sessions_table(comparison["sessions"]),
        "",
        str(Text("study-session", session=last["session"])),
        *_seeds_table(last["per_seed"]),
    ]
    later = comparison["later_sessions"]
    if later is not None:
        sentence = Text(
            "study-later-sessions",
            fixed=Figure(later["fixed"], 2),
            adapted=Figure(later["adapted"], 2),
            relative=signed_percent(later["relative"]),
            interval=_interval_text(later["interval"]),
            reached_fixed=Figure(100.0 * later["reached_fixed"], 1),
            reached_adapted=Figure(100.0 * later["reached_adapted"], 1),
        )
        lines += ["", str(sentence)]
    applied, proposals = comparison["applied"], comparison["proposals"]
    sentence = Text(
        "study-last-session",
        seeds=comparison["seeds"],
        relative=_percent(last["median_relative"]),
        interval=_interval_text(last["interval"]),
        median=proposals["median"],
        most=proposals["most"],
        steps=applied["steps"],
        felt_change=Figure(100.0 * applied["largest_felt_change"], 1),
        turn=Figure(applied["largest_turn_deg"], 2),
        flips=applied["sign_flips"],
    )
    return "\n".join([*lines, "", str(sentence)]) + "\n"


def _later_sessions(
    fixed: Sequence[StudySessionTrial], other: Sequence[StudySessionTrial], seeds: list[int]
) -> LaterSessions:
    """Return the means over all trials from the second session on, and the interval of their ratio - 1."""
    rows = [[row for row in every if row.session > 1] for every in (fixed, other)]
    before, after = (
        np.array([np.mean([row.e_diff for row in of if row.seed == seed]) for seed in seeds]) for of in rows
    )
    later: LaterSessions = {
        "fixed": float(before.mean()),
        "adapted": float(after.mean()),
        "relative": float(after.mean() / max(before.mean(), LEAST_AREA) - 1.0),
        "interval": None,
        "reached_fixed": float(np.mean([row.reached for row in rows[0]])),
        "reached_adapted": float(np.mean([row.reached for row in rows[1]])),
    }
    if len(seeds) >= 3:
        from scipy.stats import bootstrap

        bounds = bootstrap(
            (before, after),
            lambda fixed, adapted, axis: adapted.mean(axis=axis) / np.maximum(fixed.mean(axis=axis), LEAST_AREA) - 1.0,
            paired=True,
            n_resamples=RESAMPLES,
            confidence_level=CONFIDENCE,
            method="percentile",
            rng=np.random.default_rng(1),
        ).confidence_interval
        later["interval"] = (float(bounds.low), float(bounds.high))
    return later


def _proposals(rows: Sequence[StudySessionTrial], seeds: list[int]) -> Proposals:
    """Return after how many trials of each seed something was proposed."""
    counts = [sum(row.proposed > 0 for row in rows if row.seed == seed) for seed in seeds]
    return {"per_seed": counts, "median": float(np.median(counts)), "most": max(counts)}


def _session(
    fixed: Sequence[StudySessionTrial], other: Sequence[StudySessionTrial], seeds: list[int], session: int
) -> SessionAreas:
    before, after = (_means(rows, seeds, session) for rows in (fixed, other))
    drove = np.array([min(_reached(fixed, seed, session), _reached(other, seed, session)) == 1.0 for seed in seeds])
    median, interval = _median(_relative(before, after)[drove])
    return {
        "session": session,
        "fixed": float(np.median(before)),
        "adapted": float(np.median(after)),
        "reached_fixed": float(np.mean([_reached(fixed, seed, session) for seed in seeds])),
        "reached_adapted": float(np.mean([_reached(other, seed, session) for seed in seeds])),
        "seeds_that_always_drove": int(drove.sum()),
        "relative": median,
        "interval": interval,
    }


def _means(rows: Sequence[StudySessionTrial], seeds: list[int], session: int) -> NDArray[np.float64]:
    """Return each seed's mean E_diff (n_seeds,) in m2 in a session."""
    return np.array([np.mean([row.e_diff for row in rows if (row.seed, row.session) == (s, session)]) for s in seeds])


def _relative(before: NDArray[np.float64], after: NDArray[np.float64]) -> NDArray[np.float64]:
    relative: NDArray[np.float64] = (after - before) / np.maximum(before, LEAST_AREA)
    return relative


def _reached(rows: Sequence[StudySessionTrial], seed: int, session: int) -> float:
    return float(np.mean([row.reached for row in rows if (row.seed, row.session) == (seed, session)]))


def _median(values: NDArray[np.float64]) -> tuple[float | None, Interval | None]:
    """Return the median with its bootstrap interval; no interval for fewer than 3 values, no median for none."""
    if len(values) < 3 or not np.isfinite(values).all():
        return (float(np.median(values)) if len(values) else None), None
    from scipy.stats import bootstrap

    bounds = bootstrap(
        (values,),
        np.median,
        n_resamples=RESAMPLES,
        confidence_level=CONFIDENCE,
        method="percentile",
        rng=np.random.default_rng(1),
    ).confidence_interval
    return float(np.median(values)), (float(bounds.low), float(bounds.high))


def _sessions_table(sessions: Sequence[SessionAreas]) -> list[str]:
    rows = [
        (
            row["session"],
            _area(row["fixed"]),
            _area(row["adapted"]),
            percent(row["reached_fixed"]),
            percent(row["reached_adapted"]),
            row["seeds_that_always_drove"],
            _percent(row["relative"]),
            _interval_text(row["interval"]),
        )
        for row in sessions
    ]
    titles = [Text(f"study-column-{column}") for column in SESSION_COLUMNS]
    return table_lines([titles, *rows], left=(len(titles) - 1,))


def _seeds_table(seeds: Sequence[SeedAreas]) -> list[str]:
    rows = [
        (
            row["seed"],
            _area(row["fixed"]),
            _area(row["adapted"]),
            signed_percent(row["relative"]),
            percent(row["reached_fixed"]),
            percent(row["reached_adapted"]),
        )
        for row in seeds
    ]
    return table_lines([[Text(f"study-column-{column}") for column in SEED_COLUMNS], *rows], left=())


def _area(area: float) -> str:
    return value_text(Figure(area, 2))


def _percent(share: float | None) -> str:
    return "-" if share is None else signed_percent(share)


def _interval_text(interval: Interval | None) -> Text | str:
    if interval is None:
        return "-"
    return Text("study-interval", low=signed_percent(interval[0]), high=signed_percent(interval[1]))
