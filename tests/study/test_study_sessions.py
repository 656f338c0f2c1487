"""Sessions of a study: both conditions begin with equal participants, and applied steps keep their limits."""

import json
from dataclasses import replace

from app.cli.study.study_command import study
from app.hardware.body.person_parameters import PRACTISED
from app.study.sessions import calibrated_participant, run_participants, run_sessions
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


def test_a_map_learnt_from_cues_is_followed_as_any_other() -> None:
    guided = calibrated_participant("steady", 5, "guided")
    assert {joint.map for joint in guided.profile.joints if joint.prompted} == {"guided"}
    guided.participant.person.parameters = replace(PRACTISED, tremor=0.015)
    rows = run_sessions("auto", guided, 4, 1, CLINIC, CORRIDOR)
    assert sum(row.proposed for row in rows) > 0
    assert rows[-1].dead_zone > rows[0].dead_zone
    assert [row.from_calibration_deg for row in rows] == [0.0] * 4


def test_a_map_learnt_from_other_people_is_followed_as_any_other() -> None:
    by_others = calibrated_participant("steady", 5, "prior")
    assert {joint.map for joint in by_others.profile.joints} == {"prior"}
    by_others.participant.person.parameters = replace(PRACTISED, tremor=0.08)
    rows = run_sessions("auto", by_others, 5, 1, CLINIC, CORRIDOR)
    assert sum(row.proposed for row in rows) > 0
    assert rows[-1].dead_zone > rows[0].dead_zone
    assert [row.from_calibration_deg for row in rows] == [0.0] * 5


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
    study(
        out=tmp_path, adapt="auto", person="deteriorating", sessions=1, trials=1, seed=2, path="corridor", as_json=True
    )
    answer = json.loads(capsys.readouterr().out)
    assert answer["applied"]["sign_flips"] == 0
    assert answer["sessions"][0]["relative"] == 0.0  # nothing can be applied before the first trial
    assert len((tmp_path / "sessions.csv").read_text().splitlines()) == 1 + 2
    assert "session 1" in (tmp_path / "table.txt").read_text()
