"""Decoding frame by frame equals decoding at once."""

import numpy as np
import pytest

from app.calibration.vocabulary import DriveParameters
from app.faults import State
from app.geometry import Pose
from app.hardware.chair.simulator import VirtualChair
from app.messages import SensorFrame
from app.pipeline.chain import Chain
from app.pipeline.replay.batch import decode_block
from app.pipeline.safety_gate import Conditions
from building import make_parameters, make_signals

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
    document = make_parameters().model_dump(mode="json") | {"cruise_time": 4.0}
    document["gestures"][0] |= {"feature": "displacement", "dead_zone": 0.1, "full": 0.5}
    parameters = DriveParameters.model_validate(document)
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
    parameters = make_parameters()
    document = parameters.model_dump(mode="json")
    document["gestures"][0] |= {"feature": "displacement", "dead_zone": 0.1, "full": 0.5}
    parameters = DriveParameters.model_validate(document)
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
