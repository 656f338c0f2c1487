"""Decoding frame by frame equals decoding at once; a rerun of a recorded drive equals the recording to the last bit."""

from dataclasses import fields

import numpy as np
import pytest
from recorded_trial import record_trial

from app.calibration.vocabulary import standard_parameters
from app.faults import State
from app.geometry import Pose
from app.hardware.chair.simulator import VirtualChair
from app.messages import SensorFrame
from app.pipeline.chain import Chain
from app.pipeline.replay.batch import decode_block
from app.pipeline.replay.exact_rerun import Rerun, replay_run
from app.pipeline.safety_gate import Conditions
from app.recording.reader import read_run
from building import make_parameters, make_signals, plan_of, taught_by_others, with_gesture

HELD = {"feature": "displacement", "dead_zone": 0.1, "full": 0.5}
FIELDS = ("score", "rate", "drive", "activation", "u1", "u2", "v", "omega", "x", "y", "theta")


def stream(parameters, sample_rate, t, t_device, values):
    """Drive the chain frame by frame; return the same fields as the batch, and the states."""
    chain = Chain(sample_rate, parameters, VirtualChair(None, Pose(0.0, 0.0, 0.0)))
    assert chain.arm()
    rows, states = {name: [] for name in FIELDS}, []
    for i, frame in enumerate(values):
        tick = chain.step(SensorFrame(i, t_device[i], t[i], frame), t[i], Conditions())
        for name in FIELDS:
            field = getattr(tick, name)
            rows[name].append(list(field) if isinstance(field, list) else field)
        states.append(int(tick.state))
    return {name: np.array(rows[name]) for name in FIELDS}, np.array(states, dtype=np.uint8)


def assert_equal(parameters, t, t_device, values):
    sample_rate = parameters.profile.sample_rate
    streamed, states = stream(parameters, sample_rate, t, t_device, values)
    chair = VirtualChair(None, Pose(0.0, 0.0, 0.0))
    block = decode_block(parameters, sample_rate, t, values, t_device=t_device, state=states, chair=chair)
    for name in FIELDS:
        np.testing.assert_allclose(getattr(block, name), streamed[name], atol=1e-6, err_msg=name)
    return streamed, states


@pytest.mark.parametrize("changes", [{"mode_u1": "velocity"}, {}, {"mode_u2": "acceleration", "turn_cruise_time": 1.0}])
def test_a_drive_decoded_at_once_is_the_drive_frame_by_frame(changes):
    parameters = make_parameters().model_copy(update=changes)
    values = make_signals(parameters, 3000)
    t = np.arange(3000) / 100
    streamed, states = assert_equal(parameters, t + 0.003, t, values)
    assert State.ARMED in states
    assert np.abs(streamed["v"]).max() > 0.1
    assert np.abs(streamed["omega"]).max() > 0.1
    assert np.hypot(streamed["x"], streamed["y"]).max() > 0.3


def test_missing_frames_late_arrivals_and_bad_channels_change_nothing_of_that():
    parameters = make_parameters()
    values = make_signals(parameters, 3000, seed=3)
    rng = np.random.default_rng(5)
    kept = rng.random(3000) > 0.05
    values[:30, 0] = np.nan
    values[1200:1240, 7] = np.nan
    values[1500:1510, 3] = 1e6
    values[1800:1900, 2] = values[1800, 2]
    device = (np.arange(3000) / 100)[kept]
    arrival = np.maximum.accumulate(device + rng.random(len(device)) * 0.008)
    streamed, _ = assert_equal(parameters, arrival, device, values[kept])
    assert np.isfinite(streamed["score"]).all()


def test_a_held_posture_that_is_stuck_drives_until_the_time_out_and_decodes_alike():
    parameters = with_gesture(make_parameters().model_copy(update={"cruise_time": 4.0}), 0, **HELD)
    values = make_signals(parameters, 2500, seed=4)
    t = np.arange(2500) / 100
    held = int(decode_block(parameters, 100.0, t, values).activation[:, 0].argmax())
    still = make_signals(parameters, 2500, strokes=False)[held:]
    values[held:] = values[held] + still - still[0]
    streamed, _ = assert_equal(parameters, t + 0.003, t, values)
    assert streamed["activation"][-1, 0] > 0.1
    assert np.abs(streamed["v"][held : held + 390]).max() > 0.3
    assert streamed["v"][-1] == 0.0


def test_a_held_posture_decodes_alike_too():
    parameters = with_gesture(make_parameters(), 0, **HELD)
    values = make_signals(parameters, 2500, seed=4)
    t = np.arange(2500) / 100
    streamed, _ = assert_equal(parameters, t, t, values)
    assert streamed["activation"][:, 0].max() > 0.5


def test_without_a_chair_the_floor_is_endless_and_the_numbers_are_the_same():
    parameters = make_parameters()
    values = make_signals(parameters, 2000)
    t = np.arange(2000) / 100
    free = decode_block(parameters, 100.0, t, values)
    driven = decode_block(parameters, 100.0, t, values, chair=VirtualChair(None, Pose(0.0, 0.0, 0.0)))
    np.testing.assert_allclose(free.x, driven.x, atol=1e-9)
    np.testing.assert_allclose(free.y, driven.y, atol=1e-9)


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
    parameters = with_gesture(make_parameters(), 1, **HELD)
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
