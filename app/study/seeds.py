"""The study with several seeds: in how many of them a measure falls, and at which trial it falls most."""

import dataclasses
from collections.abc import Callable, Sequence
from concurrent.futures import ProcessPoolExecutor, as_completed
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from app.hardware.body.person_parameters import NOVICE, PersonParameters
from app.scoring.trend import mann_kendall
from app.study.experiment import StudyResult, run_study
from app.study.simulated_trial import StudyTrial
from app.world.floorplan import FloorPlan

MEASURES = ("dist", "e_diff")
EARLY = 3  # trials; in the paper's figures, the largest step is among them
KEPT_EVERY = 10  # rows of a trajectory of which one is kept: ten a second are enough for drawings

Progress = Callable[[StudyResult], None]


@dataclass(frozen=True, slots=True)
class MeasureOverSeeds:
    """One measure over trials: its median over the seeds, and the number of seeds with each trend."""

    median: tuple[float | None, ...]  # of each trial, over the seeds in which it reached the goal; None where none did
    p: tuple[float, ...]  # of the Mann-Kendall test, one per seed
    falls: int  # seeds in which it falls with p < 0.05
    rises: int
    no_trend: int
    early_steps: int  # seeds whose largest step (fall between neighbouring trials) is among the first three trials
    median_step: int | None  # the trial from which the median falls most to the next one


def run_seeds(
    seeds: Sequence[int],
    trials: int,
    floorplan: FloorPlan,
    path_name: str,
    person: PersonParameters = NOVICE,
    progress: Progress | None = None,
    processes: int = 1,
) -> tuple[StudyResult, ...]:
    """Run one study per seed, several in parallel, and return the results in the order of `seeds`.

    The results do not depend on the number of processes. The first seed's trajectories are kept whole, of the others'
    every tenth row.

    Parameters
    ----------
    seeds, trials, floorplan, path_name, person
        As for `run_study`.
    progress
        Called with each result when its study is done, in the order in which they finish.
    processes
        Largest number of parallel processes.

    Raises
    ------
    ValueError
        When one of the studies cannot be made.
    """
    done: dict[int, StudyResult] = {}
    with ProcessPoolExecutor(min(len(seeds), processes)) as pool:
        studies = [
            pool.submit(_study_of, seed, trials, floorplan, path_name, person, whole=seed == seeds[0]) for seed in seeds
        ]
        try:
            for finished in as_completed(studies):
                result = finished.result()
                done[result.seed] = result
                if progress is not None:
                    progress(result)
        except BaseException:
            pool.shutdown(cancel_futures=True)
            raise
    return tuple(done[seed] for seed in seeds)


def measure_over_seeds(results: Sequence[StudyResult], measure: str) -> MeasureOverSeeds:
    """Return the trend of one measure over trials in all studies, which have equally many trials.

    A trial that did not reach the goal is left out, as in a learning curve: its distance and area are those of a part
    of the path.
    """
    table = comparable_table(results, measure)
    trends = [mann_kendall(row[~np.isnan(row)].tolist()) for row in table]
    directions = [trend.direction for trend in trends]
    steps = [largest_step(row.tolist()) for row in table]
    median = tuple(
        float(np.median(reached)) if len(reached := column[~np.isnan(column)]) else None for column in table.T
    )
    return MeasureOverSeeds(
        median=median,
        p=tuple(trend.p for trend in trends),
        falls=directions.count("falls"),
        rises=directions.count("rises"),
        no_trend=directions.count("none"),
        early_steps=sum(step is not None and step < EARLY for step in steps),
        median_step=largest_step([np.nan if value is None else value for value in median]),
    )


def largest_step(values: Sequence[float]) -> int | None:
    """Return the trial (from 1) after which `values` fall most, None when they never fall.

    NaN stands for a trial that did not reach the goal: steps to it and from it are left out.
    """
    falls = -np.diff(np.asarray(values, dtype=np.float64))
    falls[np.isnan(falls)] = -np.inf
    if not len(falls) or not np.max(falls) > 0.0:
        return None
    return int(np.argmax(falls)) + 1


def comparable_table(results: Sequence[StudyResult], measure: str) -> NDArray[np.float64]:
    """Return one measure (n_seeds, n_trials), NaN where the goal was not reached."""
    return np.array(
        [
            [float(trial.measures[measure]) if trial.measures["reached"] else np.nan for trial in result.trials]
            for result in results
        ]
    )


def _study_of(
    seed: int, trials: int, floorplan: FloorPlan, path_name: str, person: PersonParameters, *, whole: bool
) -> StudyResult:
    result = run_study(trials, seed, floorplan, path_name, person=person)
    if whole:
        return result
    return dataclasses.replace(result, trials=tuple(decimated(trial) for trial in result.trials))


def decimated(trial: StudyTrial) -> StudyTrial:
    """Return a trial with every tenth row of its trajectory, and the last one."""
    rows = np.unique(np.append(np.arange(0, len(trial.t), KEPT_EVERY), len(trial.t) - 1))
    columns = {name: getattr(trial, name)[rows] for name in ("t", "x", "y", "theta", "v", "omega")}
    return dataclasses.replace(trial, **columns)
