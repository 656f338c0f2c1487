"""`bodydrive decode`, on made-up signals and on a real knit."""

import json

import numpy as np
import pyarrow.csv
import pyarrow.parquet
import pytest
from calibration import test_knit_shirt as knit
from recorded_trial import record_trial

from app.cli.decode import decode
from app.cli.errors import InputError
from app.pipeline.replay.batch import decode_block
from app.signals.signals import read_signals
from bench.learning.guided_map import FOLDER, LAYOUT, RISING
from building import make_parameters, make_profile, make_signals


def write_signals(file, profile, values):
    t = np.arange(len(values)) / profile.sample_rate
    columns = {"t": t} | {name: values[:, i] for i, name in enumerate(profile.layout.channel_names)}
    pyarrow.csv.write_csv(pyarrow.table(columns), file)
    return t


def test_a_file_decodes_to_the_numbers_of_the_chain(tmp_path, capsys):
    profile = make_profile()
    (tmp_path / "profile.json").write_text(profile.model_dump_json())
    values = make_signals(make_parameters(), 800)
    t = write_signals(tmp_path / "signals.csv", profile, values)
    decode(tmp_path / "signals.csv", tmp_path / "profile.json", tmp_path / "out.parquet", None, None, as_json=True)
    summary = json.loads(capsys.readouterr().out)
    assert (summary["frames"], summary["source"]["description"]) == (800, "Shirt not recorded, chair not recorded")
    table = pyarrow.parquet.read_table(tmp_path / "out.parquet")
    expected = decode_block(make_parameters(), 100.0, t, values)
    np.testing.assert_allclose(table["right_elbow_score"], expected.score[:, 0], atol=1e-6)
    np.testing.assert_allclose(table["left_shoulder_activation"], expected.activation[:, 3], atol=1e-6)
    np.testing.assert_allclose(table["x"], expected.x, atol=1e-6)
    assert table.column_names[-8:] == ["u1", "u2", "v", "omega", "x", "y", "theta", "simulated"]
    assert np.isnan(table["simulated"]).all()  # a file of signals does not tell who wore the shirt


def test_a_decoded_recording_carries_its_source_in_each_form(tmp_path, capsys):
    parameters, run = make_parameters(), tmp_path / "run"
    source = {"shirt": "simulator", "body": "person", "chair": "virtual", "simulated": True}
    record_trial(run, parameters, seconds=3.0, seed=1, source=source)
    (tmp_path / "parameters.json").write_text(parameters.model_dump_json())
    words = "Simulated shirt (simulated person), virtual chair: practice only"
    for name in ("out.parquet", "out.csv"):
        decode(run, tmp_path / "parameters.json", tmp_path / name, None, None, as_json=True)
        assert json.loads(capsys.readouterr().out)["source"] == {**source, "description": words}
    decode(run, tmp_path / "parameters.json", tmp_path / "out.csv", None, None)
    assert words in capsys.readouterr().out
    table = pyarrow.parquet.read_table(tmp_path / "out.parquet")
    assert table.schema.metadata[b"source"].decode() == words
    for read in (table, pyarrow.csv.read_csv(tmp_path / "out.csv")):
        assert set(read["simulated"].to_pylist()) == {1.0}


def test_dead_zone_and_cutoff_override_all_gestures(tmp_path):
    profile = make_profile()
    (tmp_path / "profile.json").write_text(profile.model_dump_json())
    write_signals(tmp_path / "signals.csv", profile, make_signals(make_parameters(), 800))
    for name, dead_zone in (("low", 0.1), ("high", 1.5)):
        decode(
            tmp_path / "signals.csv", tmp_path / "profile.json", tmp_path / f"{name}.csv", dead_zone, 5.0, as_json=False
        )
    low, high = (pyarrow.csv.read_csv(tmp_path / f"{name}.csv") for name in ("low", "high"))
    np.testing.assert_allclose(low["right_elbow_rate"], high["right_elbow_rate"])
    rate = low["right_elbow_rate"].to_numpy()
    np.testing.assert_allclose(low["right_elbow_drive"], np.maximum(rate - 0.1, 0), atol=1e-9)
    np.testing.assert_allclose(high["right_elbow_drive"], np.maximum(rate - 1.5, 0), atol=1e-9)


@pytest.mark.parametrize(
    ("profile", "out", "dead_zone", "sentence"),
    [
        ("{", "out.csv", None, "is not a JSON document"),
        ("{}", "out.csv", None, "--profile"),
        (None, "out.xlsx", None, "must end in .parquet or .csv"),
        (None, "out.csv", float("nan"), "--dead-zone"),
        (None, "out.csv", -1.0, "--dead-zone"),
        (None, "profile.json/out.csv", None, "cannot be written"),
    ],
)
def test_bad_input_is_one_sentence_and_writes_nothing(tmp_path, profile, out, dead_zone, sentence):
    (tmp_path / "profile.json").write_text(profile or make_profile().model_dump_json())
    write_signals(tmp_path / "signals.csv", make_profile(), make_signals(make_parameters(), 300))
    before = sorted(tmp_path.iterdir())
    with pytest.raises(InputError, match=sentence) as refusal:
        decode(tmp_path / "signals.csv", tmp_path / "profile.json", tmp_path / out, dead_zone, None)
    assert "\n" not in str(refusal.value)
    assert sorted(tmp_path.iterdir()) == before


@pytest.mark.skipif(not FOLDER.is_dir(), reason="the knit recordings are not beside the project")
def test_a_real_knit_drives_on_the_way_to_the_gesture_and_nowhere_else(tmp_path):
    signals = read_signals(FOLDER / "signals.csv", LAYOUT)
    # The measured angle goes through the same low-pass, so that what is judged is the map and not the filter's delay.
    rates = {joint: rate for joint, rate, _ in knit.measured_angles(signals.sample_rate)}
    profile = knit.calibrated(signals, knit.prompts(signals, rates))
    assert all(joint.evr >= 0.98 for joint in profile.joints)
    (tmp_path / "profile.json").write_text(profile.model_dump_json())
    decode(
        FOLDER / "signals.csv",
        tmp_path / "profile.json",
        tmp_path / "out.parquet",
        knit.DEAD_ZONE,
        knit.CUTOFF,
        as_json=False,
    )
    table = pyarrow.parquet.read_table(tmp_path / "out.parquet")
    for joint, rate in rates.items():
        drive = table[f"{joint}_drive"].to_numpy()
        assert drive[rate > RISING].sum() >= knit.RISING_SHARE[joint] * drive.sum(), joint
        assert drive[np.abs(rate) < knit.STILL].sum() <= knit.REST_SHARE * drive.sum(), joint
