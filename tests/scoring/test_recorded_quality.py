"""The quality of control from a recording on disk, as the control process writes it."""

import json

import pytest
from recorded_trial import record_trial
from session.known_strokes import RATE, along, frames, parameters, strokes, turned

from app.recording.format import META_FILE
from app.session.recordings import quality_of_recording


def test_the_quality_of_a_recorded_trial_uses_its_own_parameters(tmp_path):
    values = frames(along(turned(20), strokes(seconds=30.0)))
    record_trial(tmp_path / "run", parameters(), values=values)
    quality = quality_of_recording(tmp_path / "run")
    joint = quality.joints[0]
    assert joint.map_angle_deg == pytest.approx(20.0, abs=0.1)
    assert joint.activations == len(values) / RATE / 2 - 1  # one stroke every two seconds; at the first it is not armed
    assert quality.activations == joint.activations
    assert quality.cross_talk == 0.0
    assert quality.bad_channels == ()


def test_a_recording_without_parameters_is_refused(tmp_path):
    run = tmp_path / "run"
    run.mkdir()
    (run / META_FILE).write_text(json.dumps({"sample_rate": RATE}))
    with pytest.raises(ValueError, match="with what parameters"):
        quality_of_recording(run)
    with pytest.raises(ValueError, match="no recording"):
        quality_of_recording(tmp_path / "nowhere")
