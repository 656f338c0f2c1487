"""A stored trial is decoded again with its own version of the map, also after the map was changed."""

import numpy as np
from clinic_rows import rows_in
from recorded_trial import record_trial

from app.pipeline.replay.exact_rerun import replay_run
from app.recording.reader import read_run
from app.store.parameters import as_document, current_parameters
from app.store.tables import ParameterSet, Profile
from building import make_parameters

COMMANDS = ("v", "omega", "u1", "u2")


def test_an_old_trial_gives_its_own_commands_and_the_new_map_gives_others(database, tmp_path):
    first, second = make_parameters(), make_parameters(seed=2)
    record_trial(tmp_path / "r1", first)
    with rows_in(database) as rows:
        session = rows.open_session()
        rows.map(session, first)
        trial = rows.trial(session, run="r1")
    with rows_in(database) as rows:
        rows.map(session, second)
    with database.transaction() as db:
        _, profile = current_parameters(db, session.patient_id)
        assert profile.version == 2
        row = db.get_one(ParameterSet, trial.parameters_id)
        own, newest = as_document(row, db.get_one(Profile, row.profile_id)), current_parameters(db, session.patient_id)
        assert (own.hash, own.profile) == (first.hash, first.profile)
        run = read_run(tmp_path / "r1")
        again = replay_run(run, own)
        for name in COMMANDS:
            np.testing.assert_array_equal(getattr(again, name), run.columns[name], err_msg=name)
            assert np.ptp(run.columns[name]) > 0.1
        other = replay_run(run, second)
        assert all(not np.array_equal(getattr(other, name), run.columns[name]) for name in COMMANDS)
        assert newest[0].hash == second.hash
