"""Sessions of a study, with fixed and adapted maps and with interface tests: equal beginnings, steps within limits."""

import csv
import json
from dataclasses import replace

import pytest

from app.calibration.vocabulary import standard_parameters
from app.cli.errors import InputError
from app.cli.study.study_command import study
from app.hardware.body.person_parameters import PRACTISED
from app.study.interface_sessions import InterfaceSession, do_interface_test, interface_summary, interface_table
from app.study.sessions import calibrated_participant, run_participants, run_sessions
from app.world.cursor_task import CursorPlan
from app.world.floorplan import bundled_floorplans, load_floorplan

CLINIC = load_floorplan(bundled_floorplans()["clinic"])
CORRIDOR = CLINIC.path_named("corridor")


def first():
    """Return a participant of one seed just after the calibration."""
    return calibrated_participant("redonned", 5)


def test_both_conditions_begin_alike_and_nothing_turns_that_loses_nothing() -> None:
    fixed = run_sessions("off", first(), 2, 1, CLINIC, CORRIDOR)
    auto = run_sessions("auto", first(), 2, 1, CLINIC, CORRIDOR)
    assert fixed[0].e_diff == auto[0].e_diff  # the first trial is driven with the calibration's own map
    assert fixed[1].reached  # after putting the shirt on again, sound channels do not count as broken
    assert auto[1].reached
    assert [row.from_calibration_deg for row in (*fixed, *auto)] == [0.0] * 4


@pytest.mark.parametrize(("kind", "tremor", "sessions"), [("guided", 0.015, 3), ("prior", 0.08, 5)])
def test_a_map_learnt_from_cues_or_from_other_people_is_followed_as_any_other(kind, tremor, sessions) -> None:
    learnt = calibrated_participant("steady", 5, kind)
    assert {joint.map for joint in learnt.profile.joints if joint.prompted or kind == "prior"} == {kind}
    learnt.participant.person.parameters = replace(PRACTISED, tremor=tremor)
    rows = run_sessions("auto", learnt, sessions, 1, CLINIC, CORRIDOR)
    assert sum(row.proposed for row in rows) > 0
    assert rows[-1].dead_zone > rows[0].dead_zone
    assert [row.from_calibration_deg for row in rows] == [0.0] * sessions


def test_an_outgrown_dead_zone_follows_by_itself_and_a_suggestion_changes_nothing() -> None:
    """A tremor that is there at once stands for one that has grown over many sessions."""
    shaking = replace(PRACTISED, tremor=0.015)
    rows = {}
    for mode in ("off", "suggest", "auto"):
        calm = calibrated_participant("steady", 5)
        calm.participant.person.parameters = shaking
        rows[mode] = run_sessions(mode, calm, 4, 1, CLINIC, CORRIDOR)
    assert [row.e_diff for row in rows["off"]] == [row.e_diff for row in rows["suggest"]]
    assert [row.proposed for row in rows["off"]] == [0] * 4
    assert max(row.proposed for row in rows["suggest"]) > 0
    assert {row.dead_zone for row in rows["suggest"]} == {0.15}
    assert rows["auto"][-1].dead_zone > 0.2
    assert all(row.angle_deg == 0.0 and row.felt_change == 0.0 and row.flips == 0 for row in rows["auto"])


def test_the_trials_do_not_depend_on_the_number_of_processes() -> None:
    alone, together = (
        list(run_participants("redonned", (3, 4), ("off",), 1, 1, CLINIC, CORRIDOR, processes=count))
        for count in (1, 2)
    )
    assert alone == together


def test_the_command_writes_rows_table_and_summary(tmp_path, capsys) -> None:
    study(tmp_path, 1, 2, adapt="auto", person="deteriorating", sessions=1, path="corridor", jobs=1, as_json=True)
    answer = json.loads(capsys.readouterr().out)
    assert answer["applied"]["sign_flips"] == 0
    assert answer["sessions"][0]["relative"] == 0.0  # nothing can be applied before the first trial
    assert len((tmp_path / "sessions.csv").read_text().splitlines()) == 1 + 2
    assert "session 1" in (tmp_path / "table.txt").read_text()


def test_the_command_writes_rows_table_and_summary_of_interface_tests(tmp_path, capsys):
    study(tmp_path, 1, 5, interface_test=True, person="redonned", sessions=2, path="corridor", jobs=1, as_json=True)
    answer = json.loads(capsys.readouterr().out)
    assert [one["session"] for one in answer["sessions"]] == [1, 2]
    assert answer["rank_correlation"] == {"between": None, "within": None}  # one person, two sessions
    rows = list(csv.DictReader((tmp_path / "interface_tests.csv").read_text().splitlines()))
    first = calibrated_participant("redonned", 5)
    test = do_interface_test(first.participant, standard_parameters(first.profile), CursorPlan(seed=1))
    assert float(rows[0]["throughput"]) == test.throughput > 0.5
    assert int(rows[0]["acquired"]) == test.acquired > 20
    assert rows[1]["reached"] == "1.0"
    assert "targets/min" in (tmp_path / "interface_table.txt").read_text()


def test_the_options_that_exclude_each_other_are_named(tmp_path):
    with pytest.raises(InputError, match="--interface-test goes without --adapt"):
        study(out=tmp_path / "one", interface_test=True, adapt="auto")
    with pytest.raises(InputError, match="--no-learning"):
        study(out=tmp_path / "two", interface_test=True, no_learning=True)


def test_the_correlation_is_that_of_the_ranks():
    first = calibrated_participant("improving", 1)
    plan = CursorPlan(seed=1, duration=5.0)
    one = do_interface_test(first.participant, standard_parameters(first.profile), plan)
    assert one.throughput is None  # too few targets in five seconds
    rows = [
        InterfaceSession(seed, session, one.model_copy(update={"throughput": 1.0 + seed + session}), 9.0 - seed, 1.0)
        for seed in range(8)
        for session in (1, 2)
    ]
    summary = interface_summary(rows)
    assert summary["rank_correlation"]["between"] == pytest.approx(-1.0)
    assert summary["rank_correlation"]["within"] is None
    assert "between people −1.00, within people -." in interface_table(summary)
    nothing = interface_summary([InterfaceSession(1, 1, one, 2.0, 0.0)])
    assert nothing["sessions"][0]["throughput_p90"] is None
    assert "-" in interface_table(nothing)
