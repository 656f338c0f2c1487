"""The rates and durations that a BIDS data set and an XDF file say, of a shirt that is slower than the loop."""

import json
from typing import Any

import numpy as np
import pytest
import pyxdf
from exported_clinic import RUN, make_clinic

from app.features.exports.bids_form import write_bids
from app.features.exports.xdf_form import write_xdf
from app.recording.groups import RunGroups
from app.recording.reader import read_run

LOOP, SHIRT = 60.0, 20.0  # Hz
PLACE = {"patient": "P-1", "session": 1, "task": "drive", "run": 1}


@pytest.fixture
def slow(tmp_path: Any) -> Any:
    """Return a run of 100 ticks, every third of them with a frame; in two groups, so that the span goes over both."""
    run = read_run(make_clinic(tmp_path / "clinic").runs / RUN)
    columns = {name: values[:100] for name, values in run.columns.items()}
    columns |= {"run_t": np.arange(100) / LOOP - 0.5, "has_frame": np.arange(100) % 3 == 0}
    groups = [{name: values[rows] for name, values in columns.items()} for rows in (slice(0, 40), slice(40, None))]
    return RunGroups(run.meta | {"sample_rate": SHIRT}, None, iter(groups))


def test_bids_says_the_measured_rate_of_the_chair_and_the_real_durations(slow: Any, tmp_path: Any) -> None:
    facts = {"software": "0.2.0"}
    files = write_bids(slow, facts, tmp_path / "bids", PLACE)
    said = {file.name: json.loads(file.read_text()) for file in files if file.suffix == ".json"}
    for name, one in said.items():
        rate, end = (LOOP, 99 / LOOP) if "wheelchair" in name else (SHIRT, 99 / LOOP)
        assert one["SamplingFrequency"] == pytest.approx(rate), name
        assert one["SamplingFrequencyEffective"] == pytest.approx(rate), name
        assert one["RecordingDuration"] == pytest.approx(end, abs=1e-3), name
    assert len(said) == 2


def test_xdf_says_no_even_rate_for_what_the_loop_makes(slow: Any, tmp_path: Any) -> None:
    (file,) = write_xdf(slow, {"software": "0.2.0"}, tmp_path, "slow")
    streams, _ = pyxdf.load_xdf(file)
    rates = {stream["info"]["name"][0]: float(stream["info"]["nominal_srate"][0]) for stream in streams}
    assert rates.pop("shirt") == SHIRT
    assert set(rates.values()) == {0.0}
    pose = next(stream for stream in streams if stream["info"]["name"][0] == "pose")
    assert np.diff(pose["time_stamps"]) == pytest.approx(1 / LOOP)
