"""The interface test of simulated people over sessions, and its command."""

import csv
import json

import pytest

from app.calibration.vocabulary import standard_parameters
from app.cli.errors import InputError
from app.cli.study.study_command import study
from app.study.interface_sessions import InterfaceSession, do_interface_test, interface_summary, interface_table
from app.study.sessions import calibrated_participant
from app.world.cursor_task import CursorPlan


def test_the_command_writes_rows_table_and_summary(tmp_path, capsys):
    asked = {"person": "redonned", "sessions": 2, "trials": 1, "seed": 5, "path": "corridor", "as_json": True}
    study(out=tmp_path, interface_test=True, **asked)
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
    assert "between people -1.00, within people -." in interface_table(summary)
    nothing = interface_summary([InterfaceSession(1, 1, one, 2.0, 0.0)])
    assert nothing["sessions"][0]["throughput_p90"] is None
    assert "-" in interface_table(nothing)
