"""Trials of an older program are measured again; one that the machine interrupted too much asks a person."""

import asyncio
from pathlib import Path
from types import SimpleNamespace

import pytest
from clinic_rows import rows_in
from recorded_trial import record_trial
from session.same_process import SameProcess
from sqlalchemy import select

from app.features.records.sign_off import sign_off
from app.session.measures_renewal import MeasuresRenewal
from app.session.recordings import MEASURES_VERSION, measure_again
from app.store.database import Database
from app.store.learning_trials import counted_trials
from app.store.runs import keep_trial, trials_of_older_measures
from app.store.tables import LogEntry, PatientSession, Trial
from app.texts import reader_language
from building import make_parameters, plan_of

PLAN = plan_of()
OLD = {"time": 99.0, "dist": 1.0, "reached": True, "measures_version": MEASURES_VERSION - 1}
HALTED = {**OLD, "halts": 3, "halt_time": 14.2, "pauses": 0, "pause_time": 0.0, "interrupted": True}


def stored(database: Database, *trials) -> list[int]:
    with rows_in(database) as rows:
        return rows.course(rows.patient(), PLAN, [trials])


def renewed(database: Database, folder: Path, measures=None) -> None:
    """Renew as a start of the program does; the recordings say `measures` where they are given."""
    computing = SameProcess({} if measures is None else {measure_again: lambda _folder: measures})
    runs = SimpleNamespace(open=None, folder_of=lambda run: folder / run)

    async def work():
        renewal = MeasuresRenewal(database, runs, computing, lambda _news: None)
        renewal.start()
        await renewal._task

    asyncio.run(work())


def test_a_trial_that_the_machine_interrupted_counts_when_a_person_says_so(database):
    ids = stored(database, {**OLD, "interrupted": False}, HALTED)
    with database.transaction() as db:
        first, halted = (db.get_one(Trial, each) for each in ids)
        assert (first.kept, first.discard_reason, halted.kept) == (True, None, False)
        assert "halted 3 times, 14 s" in str(halted.discard_reason)
        with reader_language("de"):
            assert "3-mal angehalten, 14 s" in str(halted.discard_reason)
        task = (halted.patient_id, halted.floorplan, halted.path)
        assert [one.trial.id for one in counted_trials(db, *task)] == [first.id]
        reason = halted.discard_reason
        keep_trial(db, halted.id, None)
        assert [one.trial.id for one in counted_trials(db, *task)] == ids
        keep_trial(db, halted.id, reason)  # undone
        assert [one.trial.id for one in counted_trials(db, *task)] == [first.id]


def test_an_old_trial_is_measured_again_from_its_recording(database, tmp_path):
    ids = stored(database, OLD, OLD)
    with database.transaction() as db:
        folder = tmp_path / db.get_one(Trial, ids[0]).run.folder
    record_trial(folder, make_parameters(), plan=PLAN, stop_at=4.0)
    renewed(database, tmp_path)
    with database.transaction() as db:
        measures = db.get_one(Trial, ids[0]).measures
        assert (measures["measures_version"], measures["person_stops"]) == (MEASURES_VERSION, 1)
        assert measures["time"] + measures["person_stop_time"] == pytest.approx(11.5, abs=0.1)
        assert db.get_one(Trial, ids[1]).measures == OLD  # its recording is gone
        assert [*trials_of_older_measures(db, MEASURES_VERSION)] == [ids[1]]
        row = db.scalars(select(LogEntry).where(LogEntry.what == "trial measured again")).one()
        assert (row.details["before"]["time"], row.details["now"]["time"]) == (99.0, measures["time"])


def test_an_old_trial_that_was_interrupted_is_left_out_until_a_person_says_so(database, tmp_path):
    (trial,) = stored(database, OLD)
    again = {**HALTED, "time": 20.0, "measures_version": MEASURES_VERSION}
    renewed(database, tmp_path, again)
    with database.transaction() as db:
        assert not db.get_one(Trial, trial).kept
        keep_trial(db, trial, None)
    renewed(database, tmp_path, {**again, "time": 21.0})  # its measures are of this version: nothing is done
    with database.transaction() as db:
        row = db.get_one(Trial, trial)
        assert (row.kept, row.measures["time"]) == (True, 20.0)


def test_what_was_signed_is_measured_again_and_goes_on_counting(database, tmp_path):
    (trial,) = stored(database, OLD)
    with database.transaction() as db:
        sign_off(db, db.get_one(PatientSession, db.get_one(Trial, trial).session_id), "Ann")
    renewed(database, tmp_path, {**HALTED, "time": 20.0, "measures_version": MEASURES_VERSION})
    with database.transaction() as db:
        row = db.get_one(Trial, trial)
        assert (row.kept, row.measures["time"]) == (True, 20.0)
