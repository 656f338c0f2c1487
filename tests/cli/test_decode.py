"""`bodydrive decode`, on made-up signals and on a real knit."""

import json

import numpy as np
import pyarrow.csv
import pyarrow.parquet
import pytest
from recorded_trial import record_trial

from app.calibration.clean_recording import CleanRecording
from app.calibration.fit.profile_fit import fit_profile
from app.calibration.fit.repetitions import Prompt, repetitions_of_prompts
from app.cli.decode import decode
from app.cli.errors import InputError
from app.layout import Channel, Joint, ShirtLayout
from app.pipeline.replay.batch import decode_block
from app.signals.signals import read_signals
from app.signals.smoothing import smooth
from building import make_parameters, make_profile, make_signals
from folders import SHARED

KNIT = SHARED / "data" / "knit_shirt"
# Share of the activation's integral in the rising phase, the least that each joint of the knit must give.
KNIT_RISING = {"right_elbow": 0.85, "left_elbow": 0.97, "right_shoulder": 0.86, "left_shoulder": 0.96}


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
    decode(tmp_path / "signals.csv", tmp_path / "profile.json", tmp_path / "out.parquet", None, None, True)
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
        decode(run, tmp_path / "parameters.json", tmp_path / name, None, None, True)
        assert json.loads(capsys.readouterr().out)["source"] == {**source, "description": words}
    decode(run, tmp_path / "parameters.json", tmp_path / "out.csv", None, None, False)
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
        decode(tmp_path / "signals.csv", tmp_path / "profile.json", tmp_path / f"{name}.csv", dead_zone, 5.0, False)
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
        decode(tmp_path / "signals.csv", tmp_path / "profile.json", tmp_path / out, dead_zone, None, False)
    assert "\n" not in str(refusal.value)
    assert sorted(tmp_path.iterdir()) == before


@pytest.mark.skipif(not KNIT.is_dir(), reason="the knit recordings are not beside the project")
def test_a_real_knit_drives_on_the_way_to_the_gesture_and_nowhere_else(tmp_path):
    joints = list(KNIT_RISING)
    layout = ShirtLayout(
        name="knit",
        channels=tuple(Channel(name=f"{joint}_{i}", joint=joint) for joint in joints for i in range(5)),
        joints=tuple(Joint(name=joint, label=joint) for joint in joints),
    )
    signals = read_signals(KNIT / "signals.csv", layout)
    angles = read_signals(KNIT / "joint_angles.csv")
    # The measured angle goes through the same low-pass, so that what is judged is the map and not the filter's delay.
    smoothed = smooth(angles.values.astype(float), 3.0, signals.sample_rate)
    speed = np.diff(smoothed, axis=0, prepend=smoothed[:1]) * signals.sample_rate / np.ptp(angles.values, axis=0)
    first = signals.t < 10.0
    prompts = []
    for i, joint in enumerate(joints):
        edges = np.flatnonzero(np.diff(np.concatenate(([0], (speed[first, i] > 0.1).astype(int), [0]))))
        for start, end in zip(edges[::2], edges[1::2], strict=True):
            if end - start > 20:
                prompts.append(Prompt(float(signals.t[start]), float(signals.t[end - 1]), joint))
    values = signals.values[first]
    repetitions = repetitions_of_prompts(signals.t[first], values, prompts, signals.sample_rate)
    profile = fit_profile(CleanRecording.of(layout, signals.sample_rate, values, repetitions=repetitions))
    assert all(joint.evr >= 0.98 for joint in profile.joints)
    (tmp_path / "profile.json").write_text(profile.model_dump_json())
    decode(KNIT / "signals.csv", tmp_path / "profile.json", tmp_path / "out.parquet", 0.2, 3.0, False)
    table = pyarrow.parquet.read_table(tmp_path / "out.parquet")
    for i, joint in enumerate(joints):
        drive = table[f"{joint}_drive"].to_numpy()
        assert drive[speed[:, i] > 0.1].sum() >= KNIT_RISING[joint] * drive.sum(), joint
        assert drive[np.abs(speed[:, i]) < 0.03].sum() <= 0.002 * drive.sum(), joint
