"""The study: the same seed gives the same numbers, everything is scored, and its folder holds all files or none."""

import csv
import dataclasses
import json
from pathlib import Path
from typing import Any

import numpy as np
import pyarrow.parquet
import pytest

from app.calibration.vocabulary import DriveParameters, standard_parameters
from app.cli.errors import InputError
from app.cli.study.study_command import find_floorplan, study
from app.figures.study_figures import draw_study
from app.hardware.body.person import SimulatedPerson
from app.hardware.body.person_parameters import NOVICE, PRACTISED
from app.study import study_files
from app.study.experiment import run_study, shirt_layout
from app.study.participant import Participant
from app.study.second_process import second_process
from app.study.simulated_calibration import SAMPLE_RATE, calibrate
from app.study.simulated_trial import drive_trial, score_trial
from app.study.study_files import TRIAL_COLUMNS, trials_csv, write_study
from app.world.floorplan import bundled_floorplans, load_floorplan
from app.world.scene import bundled_scenes, load_scene

CLINIC = load_floorplan(bundled_floorplans()["clinic"])


@pytest.fixture(scope="module")
def short():
    """Two trials of a practised person along one corridor."""
    return run_study(2, 5, CLINIC, "corridor", person=PRACTISED)


def test_one_seed_gives_the_same_numbers_bit_for_bit(short) -> None:
    with second_process(2) as second:  # fitted and scored by another process
        again = run_study(2, 5, CLINIC, "corridor", person=PRACTISED, second=second)
    assert trials_csv(again) == trials_csv(short)
    assert study_files.summary(again) == study_files.summary(short)
    for one, other in zip(short.trials, again.trials, strict=True):
        for name in ("t", "x", "y", "theta", "v", "omega"):
            assert np.array_equal(getattr(one, name), getattr(other, name))


def test_another_seed_gives_other_numbers(short) -> None:
    other = run_study(1, 6, CLINIC, "corridor", person=PRACTISED)
    assert other.trials[0].measures != short.trials[0].measures


def test_a_practised_person_reaches_the_goal_and_is_scored(short) -> None:
    for number, trial in enumerate(short.trials, start=1):
        assert trial.number == number
        assert trial.measures["reached"] is True
        assert trial.measures["path_length"] == pytest.approx(7.8)
        assert 7.0 < trial.measures["dist"] < 9.0
        assert 0.0 <= trial.measures["e_diff"] < 2.0
        assert trial.measures["time"] == pytest.approx(trial.t[-1], abs=0.02)
        assert trial.t[0] == 0.0
        assert np.all(np.diff(trial.t) > 0)


def test_the_trajectory_obeys_the_unicycle_and_the_limits(short) -> None:
    speeds = short.parameters.speeds
    for trial in short.trials:
        assert np.max(trial.v) <= speeds.forward + 1e-9
        assert np.min(trial.v) >= -speeds.reverse - 1e-9
        assert np.max(np.abs(trial.omega)) <= speeds.turn + 1e-9
        step = np.hypot(np.diff(trial.x), np.diff(trial.y))
        assert np.max(step) <= speeds.forward / short.sample_rate + 1e-9


def test_a_short_time_limit_ends_the_trial_before_the_goal() -> None:
    hurried = CLINIC.path_named("corridor").model_copy(update={"time_limit": 3.0})
    plan = CLINIC.model_copy(update={"paths": (hurried,)})
    result = run_study(1, 1, plan, "corridor")
    assert result.trials[0].measures["reached"] is False
    assert result.trials[0].t[-1] <= 3.01


def test_the_calibration_of_the_study_is_good_enough_to_drive(short) -> None:
    joints = {joint.name: joint for joint in short.parameters.profile.joints}
    for name in ("right_elbow", "left_elbow", "right_shoulder", "left_shoulder"):
        assert joints[name].prompted
        assert joints[name].grade in ("good", "usable")


def without_figures(_folder: Path) -> None:
    """Draw nothing."""


def test_a_study_on_disk(short, tmp_path) -> None:
    write_study(short, tmp_path / "study", lambda folder: draw_study(short, folder, "png"))
    folder = tmp_path / "study"
    assert sorted(file.name for file in folder.iterdir()) == [
        "errors.png",
        "study.json",
        "trajectories.parquet",
        "trajectories.png",
        "trials.csv",
    ]
    assert [file.name for file in tmp_path.iterdir()] == ["study"]  # nothing half-written beside it
    with (folder / "trials.csv").open(encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    assert tuple(rows[0]) == TRIAL_COLUMNS
    assert {row["simulated"] for row in rows} == {"true"}
    assert [float(row["dist"]) for row in rows] == [trial.measures["dist"] for trial in short.trials]
    table = pyarrow.parquet.read_table(folder / "trajectories.parquet")
    assert table.column_names == ["trial", "t", "x", "y", "theta", "v", "omega"]
    assert table.num_rows == sum(len(trial.t) for trial in short.trials)
    document = json.loads((folder / "study.json").read_text(encoding="utf-8"))
    assert document["software"].startswith("bodydrive ")
    assert document["seed"] == 5
    assert document["person"]["reaction_time"] == NOVICE.reaction_time
    assert len(document["trials"]) == 2
    assert (folder / "trajectories.png").read_bytes().startswith(b"\x89PNG")


def test_figures_as_svg_are_the_same_for_the_same_study(short, tmp_path) -> None:
    for name in ("one", "two"):
        (tmp_path / name).mkdir()
        draw_study(short, tmp_path / name, "svg")
    for name in ("errors.svg", "trajectories.svg"):
        drawn = (tmp_path / "one" / name).read_bytes()
        assert b"<svg" in drawn
        assert drawn == (tmp_path / "two" / name).read_bytes()


def test_a_folder_with_something_in_it_is_refused_and_kept(short, tmp_path) -> None:
    folder = tmp_path / "study"
    folder.mkdir()
    (folder / "precious.txt").write_text("mine", encoding="utf-8")
    with pytest.raises(ValueError, match="not empty"):
        write_study(short, folder, without_figures)
    assert (folder / "precious.txt").read_text(encoding="utf-8") == "mine"
    write_study(short, folder, without_figures, overwrite=True)
    assert not (folder / "precious.txt").exists()
    assert (folder / "trials.csv").exists()
    (tmp_path / "file").write_text("", encoding="utf-8")
    with pytest.raises(ValueError, match="is a file"):
        write_study(short, tmp_path / "file", without_figures, overwrite=True)


def test_a_study_that_cannot_be_drawn_leaves_nothing(short, tmp_path) -> None:
    def broken(_folder: Path) -> None:
        raise OSError("no space left on device")

    (tmp_path / "study").mkdir()
    with pytest.raises(OSError, match="no space"):
        write_study(short, tmp_path / "study", broken)
    assert [file.name for file in tmp_path.iterdir()] == ["study"]
    assert list((tmp_path / "study").iterdir()) == []


def test_the_command_prints_one_json_object(tmp_path, capsys) -> None:
    study(out=tmp_path / "out", trials=1, seed=2, floorplan="clinic", path="corridor", jobs=1, as_json=True)
    printed = capsys.readouterr()
    answer = json.loads(printed.out)
    assert answer["out"] == str(tmp_path / "out")
    assert answer["trials"][0]["trial"] == 1
    assert printed.err == ""


@pytest.mark.parametrize(
    ("given", "sentence"),
    [({"floorplan": "nowhere"}, "no such floor plan"), ({"floorplan": "clinic", "path": "roof"}, "has no path 'roof'")],
)
def test_the_command_refuses_in_one_sentence(tmp_path, given, sentence) -> None:
    with pytest.raises(InputError, match=sentence):
        study(out=tmp_path / "out", **given)
    assert list(tmp_path.iterdir()) == []


def test_a_floor_plan_from_a_file(tmp_path) -> None:
    file = tmp_path / "mine.json"
    file.write_text(CLINIC.model_dump_json(), encoding="utf-8")
    assert find_floorplan(str(file)) == CLINIC
    file.write_text("{}", encoding="utf-8")
    with pytest.raises(InputError, match=r"mine\.json"):
        find_floorplan(str(file))


def test_the_same_seed_without_learning_drives_another_way() -> None:
    """Learning changes only the person; parameters, shirt and scoring are equal."""
    still = dataclasses.replace(NOVICE, learns=False)
    keen = run_study(2, 3, CLINIC, "corridor", person=NOVICE)
    same = run_study(2, 3, CLINIC, "corridor", person=still)
    assert keen.parameters.gestures == same.parameters.gestures
    assert keen.trials[1].measures != same.trials[1].measures


@pytest.fixture(scope="module")
def calibrated_participant() -> tuple[Participant, DriveParameters]:
    """A participant, and the standard parameters of its calibration."""
    participant = Participant(SimulatedPerson(PRACTISED, 1), shirt_layout(), SAMPLE_RATE, 2)
    return participant, standard_parameters(calibrate(participant))


@pytest.fixture
def drive(calibrated_participant):
    """Return a function that drives a task of a bundled scene and returns the trial."""
    participant, parameters = calibrated_participant

    def measured(scene: str, level: Any, task: str):
        plan = load_scene(bundled_scenes()[scene]).plans[level]
        path = plan.path_named(task)
        return score_trial(plan, path, drive_trial(1, participant, parameters, plan, path))

    return measured


@pytest.mark.parametrize(
    ("scene", "level", "task", "bounds"),
    [
        ("backing", "medium", "back", {"collisions": (0, 0)}),
        ("turning", "hard", "about", {"turn_drift": (0.0, 0.3)}),
        ("door", "medium", "aside", {}),
        ("follow_me", "easy", "person", {"follow_error_rms": (0.0, 0.5), "follow_near": (0.8, 1.0)}),
        ("skills", "easy", "course", {"stages": (7, 7), "stages_done": (7, 7)}),
    ],
)
def test_each_kind_of_task_is_driven_to_its_end(drive, scene, level, task, bounds) -> None:
    trial = drive(scene, level, task)
    assert trial.measures["reached"] is True
    assert {name for name, (low, high) in bounds.items() if not low <= trial.measures[name] <= high} == set()
    assert task != "back" or trial.v.min() < -0.1
