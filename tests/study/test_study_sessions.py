"""Sessions of a study: both conditions begin with equal participants, and applied steps keep their limits."""

import json

import pytest

from app.cli.study.study_command import study
from app.study.sessions import calibrated_participant, run_participants, run_sessions
from app.world.floorplan import bundled_floorplans, load_floorplan

CLINIC = load_floorplan(bundled_floorplans()["clinic"])
CORRIDOR = CLINIC.path_named("corridor")


def first():
    """Return a participant of one seed just after the calibration."""
    return calibrated_participant("redonned", 5)


def test_both_conditions_begin_alike_and_applied_steps_keep_their_limits() -> None:
    fixed = run_sessions("off", first(), 2, 1, CLINIC, CORRIDOR)
    auto = run_sessions("auto", first(), 2, 1, CLINIC, CORRIDOR)
    assert fixed[0].e_diff == auto[0].e_diff  # the first trial is driven with the calibration's own map
    assert [row.felt_change for row in fixed] == [0.0, 0.0]
    assert fixed[1].reached  # after putting the shirt on again, sound channels do not count as broken
    assert all(row.felt_change <= 0.1 and row.flips == 0 and row.angle_deg <= 2.0 + 1e-6 for row in auto)
    assert auto[0].angle_deg > 0.0
    assert auto[1].from_calibration_deg == pytest.approx(auto[0].angle_deg, abs=1e-6)
    assert fixed[1].from_calibration_deg == 0.0


def test_a_suggested_step_changes_nothing() -> None:
    fixed = run_sessions("off", first(), 1, 2, CLINIC, CORRIDOR)
    suggested = run_sessions("suggest", first(), 1, 2, CLINIC, CORRIDOR)
    assert [row.e_diff for row in fixed] == [row.e_diff for row in suggested]
    assert suggested[0].felt_change > 0.0


def test_the_trials_do_not_depend_on_the_number_of_processes() -> None:
    asked = ("redonned", (3, 4), ("off",), 1, 1, CLINIC, CORRIDOR)
    assert list(run_participants(*asked)) == list(run_participants(*asked, processes=2))


def test_the_command_writes_rows_table_and_summary(tmp_path, capsys) -> None:
    study(
        out=tmp_path, adapt="auto", person="deteriorating", sessions=1, trials=1, seed=2, path="corridor", as_json=True
    )
    answer = json.loads(capsys.readouterr().out)
    assert answer["applied"]["sign_flips"] == 0
    assert answer["sessions"][0]["relative"] == 0.0  # nothing can be applied before the first trial
    assert len((tmp_path / "sessions.csv").read_text().splitlines()) == 1 + 2
    assert "session 1" in (tmp_path / "table.txt").read_text()
