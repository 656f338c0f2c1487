"""A rerun of a recorded drive equals the recording to the last bit."""

from dataclasses import fields

import numpy as np
import pytest
from recorded_trial import record_trial

from app.calibration.vocabulary import DriveParameters, standard_parameters
from app.faults import State
from app.pipeline.replay.exact_rerun import Rerun, replay_run
from app.recording.reader import read_run
from building import make_parameters, make_signals, plan_of, taught_by_others

NAMES = tuple(field.name for field in fields(Rerun))


def assert_same(run, again):
    for name in NAMES:
        np.testing.assert_array_equal(getattr(again, name), run.columns[name], err_msg=name)


@pytest.mark.parametrize("dynamics", ["unicycle", "wheelchair"])
@pytest.mark.parametrize("mode", ["acceleration", "velocity"])
def test_a_drive_comes_out_bit_for_bit(tmp_path, mode, dynamics):
    parameters = make_parameters().model_copy(update={"mode_u1": mode})
    record_trial(tmp_path / "run", parameters, seconds=8.0, dynamics=dynamics, plan=plan_of([((1.0, 0.8), (8.0, 0.8))]))
    run = read_run(tmp_path / "run")
    assert run.columns["x"].max() > 0.2
    assert np.abs(run.columns["omega"]).max() > 0.1
    assert_same(run, replay_run(run, parameters))


def test_so_do_the_dial_the_stop_lost_frames_and_turns_without_one(tmp_path):
    parameters = make_parameters()
    document = parameters.model_dump(mode="json")
    document["gestures"][1] |= {"feature": "displacement", "dead_zone": 0.1, "full": 0.5}
    parameters = DriveParameters.model_validate(document)
    record_trial(
        tmp_path / "run",
        parameters,
        dials=[(0.0, 0.7), (6.0, 0.35)],
        missing={300, 301, 570},
        without_frame={210, 400, 401, 402, 403, 404, 405, 406, 407},
        stop_at=4.0,
    )
    run = read_run(tmp_path / "run")
    assert {State.CHECKING, State.ARMED, State.FAULT} <= {State(int(state)) for state in set(run.columns["state"])}
    assert set(np.round(run.columns["dial"], 3)) == {np.float32(0.7), np.float32(0.35)}
    assert_same(run, replay_run(run, parameters))


@pytest.mark.parametrize("joints", [None, ["right_shoulder"]], ids=["all joints", "one of them"])
def test_so_do_maps_from_other_people_with_lost_frames_and_a_channel_that_fails(tmp_path, joints):
    standard = make_parameters()
    parameters = standard_parameters(taught_by_others(standard.profile, joints=joints))
    values = make_signals(parameters, 1000)
    values[300:500, standard.profile.joints[0].channels[0]] = np.nan
    record_trial(tmp_path / "run", parameters, missing={200, 201, 420}, values=values)
    run = read_run(tmp_path / "run")
    assert run.columns["activation"][:300, 0].max() > 0.0
    assert run.columns["activation"][310:490, 0].max() == 0.0
    assert_same(run, replay_run(run, parameters))


def test_other_parameters_and_another_clinic_drive_otherwise(tmp_path):
    parameters = make_parameters()
    record_trial(tmp_path / "run", parameters)
    run = read_run(tmp_path / "run")
    other = replay_run(run, make_parameters(seed=2))
    assert not np.array_equal(other.u1, run.columns["u1"])
    assert not np.array_equal(other.v, run.columns["v"])
    run.meta["clinic"] = run.meta["clinic"] | {"forward": 0.1}
    slower = replay_run(run, parameters)
    np.testing.assert_array_equal(slower.u1, run.columns["u1"])
    assert slower.v.max() <= 0.1 < run.columns["v"].max()


def test_bad_input_is_a_sentence(tmp_path):
    record_trial(tmp_path / "run", make_parameters(), seconds=2.0)
    run = read_run(tmp_path / "run")
    with pytest.raises(ValueError, match="52 channels and the profile 8"):
        replay_run(run, make_parameters(n_channels=8))
    run.meta["clinic"] = {"forward": "fast"}
    with pytest.raises(ValueError, match=r"run\.json, clinic"):
        replay_run(run, make_parameters())
    run.columns = {name: column[:0] for name, column in run.columns.items()}
    with pytest.raises(ValueError, match="holds nothing"):
        replay_run(run, make_parameters())
