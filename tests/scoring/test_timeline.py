"""The time line of a recorded trial; columns made short lose no peak."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from recorded_trial import record_trial

from app.recording.reader import read_run
from app.scoring.decimation import Decimation
from app.scoring.timeline import CHANNELS_SHOWN, MOST_POINTS, events_of, poses_of, timeline_of
from building import make_parameters, plan_of

PATH = [[0.0, 0.0], [6.0, 0.0]]


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    made = tmp_path_factory.mktemp("trial") / "run"
    wall = plan_of([((1.0, 0.8), (8.0, 0.8))])
    record_trial(made, make_parameters(), seconds=40.0, plan=wall, stop_at=20.0)
    return made


def test_all_columns_share_one_time_base_and_say_what_was_recorded(folder):
    run, line = read_run(folder), timeline_of(folder, PATH, "goal")
    rows = run.columns
    lengths = {len(column) for column in (line.t, line.x, line.theta, line.u1, line.state, line.contact, line.along)}
    lengths |= {len(values) for one in line.gestures for values in (one.score, one.rate, one.activation)}
    lengths |= {len(channel.values) for joint in line.joints for channel in joint.channels}
    assert len(lengths) == 1
    assert MOST_POINTS / 2 < lengths.pop() <= MOST_POINTS
    armed = int(np.flatnonzero(rows["state"] == 2)[0])
    own_t = rows["t"] - rows["t"][armed]
    for i in (0, 700, len(line.t) - 1):
        row = int(np.argmin(np.abs(own_t - line.t[i])))
        assert line.x[i] == pytest.approx(rows["x"][row], abs=1e-4)
        assert line.theta[i] == pytest.approx(rows["theta"][row], abs=1e-4)
    assert max(line.u1) == pytest.approx(rows["u1"].max(), abs=1e-4)
    assert [one.name for one in line.gestures] == run.meta["gestures"]
    assert line.gestures[0].controls == ["u1+", "stop"]
    for i, gesture in enumerate(line.gestures):
        assert max(gesture.rate) == pytest.approx(rows["rate"][:, i].max(), abs=1e-4)
        assert min(gesture.score) == pytest.approx(rows["score"][:, i].min(), abs=1e-4)
    assert line.across[-1] == pytest.approx(line.y[-1], abs=0.001)


def test_a_joint_shows_the_channels_that_weigh_most(folder):
    line, profile = timeline_of(folder, PATH, None), make_parameters().profile
    joint, shown = profile.joints[0], line.joints[0]
    assert (shown.name, shown.of, len(shown.channels)) == (joint.name, len(joint.channels), CHANNELS_SHOWN)
    least = min(abs(joint.direction[[f"c{i}" for i in joint.channels].index(one.name)]) for one in shown.channels)
    assert sum(abs(weight) > least for weight in joint.direction) == CHANNELS_SHOWN - 1


def test_the_events_are_on_the_time_line(folder):
    events = timeline_of(folder, PATH, "goal").events
    kinds = [event.kind for event in events]
    assert kinds[:2] == ["checking", "armed"]
    assert events[1].t == 0.0
    stop = next(event for event in events if event.kind == "stop")
    assert str(stop.message) == "Stop was pressed on the screen."
    assert kinds.count("armed") == 2
    assert "goal" in kinds
    assert "goal" not in {event.kind for event in timeline_of(folder, PATH, "by hand").events}


def test_every_contact_that_the_chair_counts_is_an_event():
    t = np.arange(100) / 10
    contacts = np.zeros(100, dtype=np.uint32)
    contacts[20:] += 1
    contacts[23:] += 1
    columns = {"state": np.zeros(100, dtype=np.uint8), "fault": np.zeros(100, dtype=np.uint8), "contacts": contacts}
    assert [(event.t, event.kind) for event in events_of(columns, t, "goal")] == [(2.0, "contact"), (2.3, "contact")]


def test_a_turn_on_the_spot_has_no_place_along_a_path(folder):
    line = timeline_of(folder, [[1.0, 1.0], [1.0, 1.0]], None)
    assert (line.along, line.across) == ([], [])


def test_poses_come_at_an_even_rate(folder):
    run = read_run(folder)
    poses = poses_of(run, 20.0)
    assert len(poses.t) == pytest.approx(40 * 20, abs=3)
    assert np.diff(poses.t).max() < 0.07
    assert poses.x[-1] == pytest.approx(run.columns["x"][-1], abs=0.05)
    assert poses.head.shape == (len(poses.t), 3)


def test_a_folder_without_a_recording_is_refused(tmp_path):
    with pytest.raises(ValueError, match="no recording"):
        timeline_of(tmp_path, PATH, None)


lengths = st.integers(min_value=1, max_value=700)
limits = st.integers(min_value=1, max_value=50).map(lambda half: 2 * half)


@given(lengths, limits, st.integers(0, 1000))
def test_columns_are_short_and_keep_peaks_and_order(n, most, seed):
    rng = np.random.default_rng(seed)
    column = rng.normal(size=n)
    column[rng.random(n) < 0.2] = np.nan
    short = Decimation(n, most)
    peaks, sampled, touched = short.peaks(column), short.sampled(np.arange(n)), short.any(column > 1)
    assert len(peaks) == len(sampled) == len(touched) == len(short.rows) <= max(most, 2)
    assert (np.diff(short.rows) >= 0).all()
    assert ((short.rows >= 0) & (short.rows < n)).all()
    if np.isfinite(column).any():
        assert np.nanmin(peaks) == np.nanmin(column)
        assert np.nanmax(peaks) == np.nanmax(column)
    known = column[np.isfinite(column)]
    assert np.isin(peaks[np.isfinite(peaks)], known).all()
    assert touched.any() == (column > 1).any()


def test_a_short_column_stays_and_a_peak_stands_where_it_was():
    short = Decimation(5, 10)
    assert short.peaks(np.arange(5.0)).tolist() == [0, 1, 2, 3, 4]
    column = np.zeros(1000)
    column[437], column[431] = 3.0, -2.0
    peaks = Decimation(1000, 100).peaks(column)
    assert np.flatnonzero(peaks).tolist() == [42, 43]
    assert peaks[42:44].tolist() == [-2.0, 0.0] or peaks[42:44].tolist() == [-2.0, 3.0]


def test_unknown_values_stay_unknown():
    assert np.isnan(Decimation(100, 10).peaks(np.full(100, np.nan))).all()
