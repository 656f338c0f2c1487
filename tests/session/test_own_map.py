"""A stored trial is decoded again with its own version of the map, also after the map was changed."""

import numpy as np
from recorded_trial import record_trial

from app.pipeline.replay.exact_rerun import replay_run
from app.recording.reader import read_run
from app.store.parameters import as_document, current_parameters, save_parameters, save_profile
from app.store.patients import add_patient, start_session
from app.store.people import add_clinic
from app.store.runs import add_run, add_trial, finish_trial
from app.store.tables import ParameterSet, Profile
from building import make_parameters

COMMANDS = ("v", "omega", "u1", "u2")


def test_an_old_trial_gives_its_own_commands_and_the_new_map_gives_others(database, tmp_path):
    with database.transaction() as db:
        add_clinic(db, "Clinic")
        patient = add_patient(db, "P-1", "Heron", "")
        session = start_session(db, patient.id)
        first = make_parameters()
        save_parameters(db, save_profile(db, patient.id, session.id, first.profile), first)
        row, _ = current_parameters(db, patient.id)
        trial = add_trial(
            db,
            run=add_run(db, "r1", session.id, "drive", "r1"),
            patient_id=patient.id,
            parameters_id=row.id,
            floorplan="room",
            floorplan_title="Room",
            path="ahead",
            path_points=[[0.0, 0.0], [6.0, 0.0]],
        )
        record_trial(tmp_path / "r1", first)
        finish_trial(db, trial.id, "by hand", None)
    with database.transaction() as db:
        second = make_parameters(seed=2)
        save_parameters(db, save_profile(db, patient.id, session.id, second.profile), second)
    with database.transaction() as db:
        _, profile = current_parameters(db, patient.id)
        assert profile.version == 2
        row = db.get_one(ParameterSet, trial.parameters_id)
        own, newest = as_document(row, db.get_one(Profile, row.profile_id)), current_parameters(db, patient.id)
        assert (own.hash, own.profile) == (first.hash, first.profile)
        run = read_run(tmp_path / "r1")
        again = replay_run(run, own)
        for name in COMMANDS:
            np.testing.assert_array_equal(getattr(again, name), run.columns[name], err_msg=name)
            assert np.ptp(run.columns[name]) > 0.1
        other = replay_run(run, second)
        assert all(not np.array_equal(getattr(other, name), run.columns[name]) for name in COMMANDS)
        assert newest[0].hash == second.hash
