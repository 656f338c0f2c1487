"""The interface test over sessions: at the beginning of each session of a simulated person, before the trials."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import partial
from typing import Any, TypedDict

import numpy as np
from numpy.typing import NDArray

from app.calibration.vocabulary import DriveParameters, standard_parameters
from app.geometry import Pose
from app.hardware.chair.simulator import VirtualChair
from app.number_format import percent
from app.pipeline.chain import Chain
from app.pipeline.safety_gate import Conditions
from app.plain_table import table_lines
from app.scoring.interface_test.interface_measures import InterfaceMeasures, interface_measures
from app.study.choices import PersonKind
from app.study.participant import Participant
from app.study.sessions import CalibratedParticipant, begin_session, calibrated_participant, each_seed
from app.study.simulated_trial import drive_trial, score_trial
from app.texts import Figure, Text, value_text
from app.world.cursor_task import CursorPlan, CursorTask
from app.world.floorplan import FloorPlan, PrescribedPath

FEWEST_PAIRS = 8  # of numbers, below which no rank correlation is given
COLUMNS = (
    *("acquisitions_per_minute", "missed", "first_entry", "dial_in", "path_efficiency", "throughput"),
    *("e_diff", "reached"),
)
TITLES = ("targets", "missed", "first-entry", "dial-in", "straightness", "throughput", "area", "reached")


SessionRow = dict[str, Any]
"""A session as one flat row: numbers by name, None where a measure has no value."""


class RankCorrelation(TypedDict):
    """Spearman's rank correlation of throughput with the area off the path; None below 8 pairs."""

    between: float | None  # people
    within: float | None  # people, the median over them


class InterfaceSummary(TypedDict):
    """The medians over people in each session, and how the test goes with the trials, ready for JSON."""

    seeds: int
    sessions: list[SessionRow]
    rank_correlation: RankCorrelation


@dataclass(frozen=True, slots=True)
class InterfaceSession:
    """One session of one seed: the interface test, and the trials after it."""

    seed: int
    session: int  # from 1
    test: InterfaceMeasures
    e_diff: float  # m2, mean of the session's trials
    reached: float  # share of the session's trials that reached the goal

    def row(self) -> SessionRow:
        """Return the session as one flat row."""
        flat = self.test.model_dump(exclude={"directions"})
        ways = {
            f"{way}_{name}": value
            for way, measures in self.test.directions.items()
            for name, value in measures.model_dump().items()
        }
        trials = {"e_diff": self.e_diff, "reached": self.reached}
        return {"seed": self.seed, "session": self.session, **flat, **ways, **trials}


def do_interface_test(participant: Participant, parameters: DriveParameters, plan: CursorPlan) -> InterfaceMeasures:
    """Let the participant do one interface test through the chain, the chair disarmed, and return its measures."""
    chain = Chain(participant.sample_rate, parameters, VirtualChair(None, Pose(0.0, 0.0, 0.0)))
    conditions = Conditions()
    task = CursorTask(plan)
    frame = participant.rest()
    begin = frame.t
    while task.phase != "over":
        tick = chain.step(frame, frame.t, conditions)
        task.step(frame.t - begin, tick.u1, tick.u2)
        frame = participant.point(task)
    return interface_measures(task)


def run_interface_sessions(
    first: CalibratedParticipant, sessions: int, trials: int, floorplan: FloorPlan, path: PrescribedPath
) -> list[InterfaceSession]:
    """Let one calibrated person come to `sessions` sessions: each an interface test, then `trials` trials.

    The map stays fixed. The number of the session is the seed of the order of the targets.
    """
    participant, parameters = first.participant, standard_parameters(first.profile)
    rows = []
    for session in range(1, sessions + 1):
        parameters = begin_session(first, session, parameters)
        test = do_interface_test(participant, parameters, CursorPlan(seed=session))
        trials_driven = [
            drive_trial(number, participant, parameters, floorplan, path) for number in range(1, trials + 1)
        ]
        measures = [score_trial(floorplan, path, trial).measures for trial in trials_driven]
        e_diff = float(np.mean([trial_measures["e_diff"] for trial_measures in measures]))
        reached = float(np.mean([bool(trial_measures["reached"]) for trial_measures in measures]))
        rows.append(InterfaceSession(first.seed, session, test, e_diff, reached))
    return rows


def run_interface_seeds(
    kind: PersonKind,
    seeds: Sequence[int],
    sessions: int,
    trials: int,
    floorplan: FloorPlan,
    path: PrescribedPath,
    processes: int = 1,
) -> Iterator[list[InterfaceSession]]:
    """Return all sessions of one seed after the other; the results do not depend on `processes`."""
    return each_seed(partial(_run_seed, kind, sessions, trials, floorplan, path), seeds, processes)


def _run_seed(
    kind: PersonKind, sessions: int, trials: int, floorplan: FloorPlan, path: PrescribedPath, seed: int
) -> list[InterfaceSession]:
    return run_interface_sessions(calibrated_participant(kind, seed), sessions, trials, floorplan, path)


def interface_summary(rows: Sequence[InterfaceSession]) -> InterfaceSummary:
    """Return, ready for JSON, the medians over seeds in each session, and how the test goes with the trials.

    Returns
    -------
    dict
        `sessions`: per session the median over seeds of each measure, and the 10th and 90th percentile of throughput.
        `rank_correlation`: Spearman's of throughput with the area off the path, `between` people (each one's means
        over the sessions) and `within` people (median over seeds of that over the sessions); None below 8 pairs.
    """
    flat = [row_of_session.row() for row_of_session in rows]
    numbers = sorted({row["session"] for row in flat})
    seeds = sorted({row["seed"] for row in flat})
    of_seed = [_columns([row for row in flat if row["seed"] == seed], ("throughput", "e_diff")) for seed in seeds]
    means = np.array([both.mean(axis=0) for both in of_seed if len(both)]).reshape(-1, 2)
    within = [rho for both in of_seed if (rho := _rank_correlation(both)) is not None]
    return {
        "seeds": len(seeds),
        "sessions": [_session([row for row in flat if row["session"] == number], number) for number in numbers],
        "rank_correlation": {
            "between": _rank_correlation(means),
            "within": float(np.median(within)) if within else None,
        },
    }


def interface_table(summary: InterfaceSummary) -> str:
    """Return the summary as text."""
    titles = [Text("study-column-session"), *(Text(f"study-test-{column}") for column in TITLES)]
    lines = [str(Text("study-test-title")), *table_lines([titles, *map(_cells, summary["sessions"])], left=())]
    correlation = summary["rank_correlation"]
    between, within = (
        "-" if rho is None else Figure(rho, 2) for rho in (correlation["between"], correlation["within"])
    )
    sentence = Text("study-rank-correlation", between=between, within=within)
    return "\n".join([*lines, "", str(sentence)]) + "\n"


def _cells(row: SessionRow) -> tuple[object, ...]:
    low, high = row["throughput_p10"], row["throughput_p90"]
    spread = "-" if low is None else Text("study-spread", low=Figure(low, 2), high=Figure(high, 2))
    return (
        row["session"],
        _figure(row["acquisitions_per_minute"], 1),
        _figure(row["missed"], 1),
        *(_figure(row[name]) for name in ("first_entry", "dial_in", "path_efficiency")),
        f"{_figure(row['throughput'])} {spread}",
        _figure(row["e_diff"]),
        percent(row["reached"]),
    )


def _session(rows: list[SessionRow], number: int) -> SessionRow:
    document: SessionRow = {"session": number}
    for name in COLUMNS:
        values = _columns(rows, (name,))[:, 0]
        document[name] = float(np.median(values)) if len(values) else None
    document["reached"] = float(np.mean([row["reached"] for row in rows]))
    rates = _columns(rows, ("throughput",))[:, 0]
    for share in (10, 90):
        document[f"throughput_p{share}"] = float(np.percentile(rates, share)) if len(rates) else None
    return document


def _columns(rows: list[SessionRow], names: tuple[str, ...]) -> NDArray[np.float64]:
    """Return columns (n, n_names) of the rows that have all of them."""
    values = [[row[name] for name in names] for row in rows if all(row[name] is not None for name in names)]
    return np.array(values, dtype=np.float64).reshape(-1, len(names))


def _rank_correlation(pairs: NDArray[np.float64]) -> float | None:
    """Return Spearman's rank correlation of two columns (n, 2); None below 8 rows, or where a column is constant."""
    if len(pairs) < FEWEST_PAIRS or (pairs == pairs[0]).all(axis=0).any():
        return None
    from scipy.stats import spearmanr

    return float(spearmanr(pairs[:, 0], pairs[:, 1]).statistic)


def _figure(value: float | None, digits: int = 2) -> str:
    return "-" if value is None else value_text(Figure(value, digits))
