"""Studies with several seeds: their counts, and their folder with all files or none."""

import csv
import dataclasses
import itertools
import json
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np
import pyarrow.parquet
import pytest
from hypothesis import given
from hypothesis import strategies as st

from app.cli.errors import InputError
from app.cli.study.study_command import study
from app.figures.study_figures import draw_seeds
from app.hardware.body.person_parameters import PRACTISED
from app.scoring.learning import learning_curves
from app.study.experiment import StudyResult, run_study
from app.study.seeds import decimated, largest_step, measure_over_seeds, run_seeds
from app.study.seeds_files import seeds_summary, sentences, write_seeds
from app.study.simulated_trial import StudyTrial
from app.world.floorplan import bundled_floorplans, load_floorplan

CLINIC = load_floorplan(bundled_floorplans()["clinic"])
FALLING = (9.0, 5.0, 4.0, 3.5, 3.2, 3.0, 2.9, 2.8)
LEVEL = (4.0, 4.3, 3.9, 4.2, 4.1, 3.8, 4.4, 4.0)
LATE = (9.0, 8.9, 8.8, 8.7, 8.6, 3.0, 2.9, 2.8)


def made(seed: int, e_diff, reached=None) -> StudyResult:
    """Return a study with the given measures, along the clinic's corridor."""
    rows = np.linspace(0.0, 1.0, 25)
    same = {"time": 20.0, "cross_track_rms": 0.1, "collisions": 0}
    goals = [True] * len(e_diff) if reached is None else reached
    trials = tuple(
        StudyTrial(number, {"dist": 10.0 + value, "e_diff": value, "reached": goal, **same}, 0, *[rows] * 6)
        for number, (value, goal) in enumerate(zip(e_diff, goals, strict=True), start=1)
    )
    curves = learning_curves([{"trial": trial.number, **trial.measures} for trial in trials])
    path = CLINIC.path_named("corridor")
    return StudyResult(seed, CLINIC, path, PRACTISED, 100.0, None, trials, curves)  # type: ignore[arg-type]  # not driven


@pytest.fixture(scope="module")
def pair():
    """Two seeds, two trials each, along one corridor."""
    return run_seeds((5, 6), 2, CLINIC, "corridor", PRACTISED, processes=2)


def test_the_outcome_of_a_seed_does_not_depend_on_the_others(pair) -> None:
    alone = run_study(2, 6, CLINIC, "corridor", person=PRACTISED)
    assert [result.seed for result in pair] == [5, 6]
    assert [trial.measures for trial in pair[1].trials] == [trial.measures for trial in alone.trials]
    assert np.array_equal(pair[1].trials[1].x, decimated(alone.trials[1]).x)


def test_seeds_that_fall_rise_and_stay_are_counted() -> None:
    rising = tuple(reversed(FALLING))
    over = measure_over_seeds([made(1, FALLING), made(2, LEVEL), made(3, rising), made(4, LATE)], "e_diff")
    assert (over.falls, over.rises, over.no_trend) == (2, 1, 1)
    assert over.early_steps == 1  # 9 to 5; the others fall most later, or never
    assert over.p[0] < 0.05 < over.p[1]
    assert over.median[0] == pytest.approx(np.median([9.0, 4.0, 2.8, 9.0]))
    assert measure_over_seeds([made(1, FALLING)], "dist").median[0] == pytest.approx(19.0)
    assert measure_over_seeds([made(1, FALLING), made(2, LATE)], "e_diff").median_step == 5


def test_a_trial_that_missed_the_goal_is_left_out() -> None:
    missed = [True] * 8
    missed[0] = False
    over = measure_over_seeds([made(1, FALLING, missed)], "e_diff")
    assert over.median[0] is None
    assert over.early_steps == 1  # from the second to the third
    assert over.median_step == 2
    nothing = measure_over_seeds([made(1, FALLING, [False] * 8)], "e_diff")
    assert nothing.median == (None,) * 8
    assert (nothing.no_trend, nothing.early_steps, nothing.median_step) == (1, 0, None)
    assert "left out" in sentences([made(1, FALLING, missed)])[-1]


@given(st.lists(st.one_of(st.floats(-100, 100), st.just(float("nan"))), max_size=12))
def test_the_largest_step_is_the_largest(values) -> None:
    falls = {i: a - b for i, (a, b) in enumerate(itertools.pairwise(values), start=1) if a - b > 0}
    step = largest_step(values)
    assert (step is None) == (not falls)
    if step is not None:
        assert falls[step] == max(falls.values())


def test_a_folder_of_several_seeds(pair, tmp_path) -> None:
    write_seeds(pair, tmp_path / "out", lambda folder: draw_seeds(pair, folder, "png"))
    folder = tmp_path / "out"
    assert sorted(file.name for file in folder.iterdir()) == [
        *("errors-seed-5.png", "errors.png", "study.json", "trajectories-seed-5.png"),
        *("trajectories.parquet", "trajectories.png", "trials.csv"),
    ]
    with (folder / "trials.csv").open(encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    assert [(row["seed"], row["trial"]) for row in rows] == [("5", "1"), ("5", "2"), ("6", "1"), ("6", "2")]
    assert float(rows[3]["e_diff"]) == pair[1].trials[1].measures["e_diff"]
    table = pyarrow.parquet.read_table(folder / "trajectories.parquet")
    assert table.column_names[0] == "seed"
    assert table.num_rows == sum(len(decimated(t).t) for t in pair[0].trials) + sum(len(t.t) for t in pair[1].trials)
    document = json.loads((folder / "study.json").read_text(encoding="utf-8"))
    assert document["seeds"] == [5, 6]
    assert document["person"]["learns"] is True
    assert set(document["over_seeds"]) == {"dist", "e_diff"}
    assert document["studies"][0]["learning"]["dist"] == {
        "text": "Not enough trials for a learning curve: 2 of at least 8 that reached the goal.",
        "details": [],
    }
    assert document == json.loads(json.dumps(seeds_summary(pair)))


def test_seeds_that_cannot_be_drawn_leave_nothing(tmp_path) -> None:
    def broken(_folder: Path) -> None:
        raise OSError("no space left on device")

    with pytest.raises(OSError, match="no space"):
        write_seeds([made(1, FALLING), made(2, LEVEL)], tmp_path / "out", broken)
    assert list(tmp_path.iterdir()) == []


def test_the_figure_of_all_seeds_with_trials_that_missed_the_goal(tmp_path) -> None:
    missed = [False] + [True] * 7
    results = [made(1, FALLING, missed), made(2, LEVEL, missed)]
    draw_seeds(results, tmp_path, "svg")
    assert (tmp_path / "errors.svg").stat().st_size > 0
    assert seeds_summary(results)["not_reached"] == 2


def test_the_command_with_seeds_and_without_learning(tmp_path, capsys) -> None:
    asked = partial(study, tmp_path / "out", 1, 3, 2, path="corridor")
    asked(figures="none", no_learning=True, as_json=True)
    answer = json.loads(capsys.readouterr().out)
    assert answer["seeds"] == [3, 4]
    assert answer["person"]["learns"] is False
    asked(overwrite=True)
    printed = capsys.readouterr().out
    assert "of 2 people it fell in 0, rose in 0 and stayed within noise in 2;" in printed
    assert "Mann-Kendall" not in printed


def test_seeds_beyond_the_largest_are_refused(tmp_path) -> None:
    with pytest.raises(InputError, match="leaves no room"):
        study(tmp_path / "out", 1, 2**31 - 1, 2)
    assert list(tmp_path.iterdir()) == []


def test_a_decimated_trial_keeps_its_end() -> None:
    trial = made(1, FALLING).trials[0]
    rows: dict[str, Any] = {name: np.arange(95.0) for name in ("t", "x", "y", "theta", "v", "omega")}
    long = dataclasses.replace(trial, **rows)
    assert decimated(long).t.tolist() == [0, 10, 20, 30, 40, 50, 60, 70, 80, 90, 94]
