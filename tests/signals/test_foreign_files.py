"""Files of other kinds: what each gives, read in the process of the isolated reader; libraries that are missing."""

import datetime
import importlib.util

import numpy as np
import openpyxl
import pytest
from scipy.io import savemat

from app.signals.columns import named_columns, read_table
from app.signals.foreign import bvh, matlab, xdf, xlsx
from app.signals.foreign.c3d import read as read_c3d
from app.signals.foreign.edf import read as read_edf
from app.signals.foreign.kinds import KINDS, foreign_kind
from app.signals.foreign.recording import MissingLibraryError, SampledStream, joined, library
from app.signals.signals import read_signals
from needed import lacks

T = np.arange(300) / 50
SIGNALS = np.column_stack([np.sin(T), np.cos(T), T**2])


def need_library(name):
    if importlib.util.find_spec(name) is None:
        lacks(f"there is no {name} here: install the extra 'files'")
    return importlib.import_module(name)


@pytest.mark.parametrize("kind", KINDS)
def test_a_kind_has_a_module_that_reads(kind):
    assert callable(importlib.import_module(kind.module).read)
    assert all(suffix.startswith(".") for suffix in kind.suffixes)


def test_a_kind_is_known_by_its_name_or_its_beginning(tmp_path):
    (tmp_path / "a.bvh").write_text("x")
    (tmp_path / "b.csv").write_bytes(b"XDF:\0\0")
    (tmp_path / "c.csv").write_text("t,a\n0,1\n")
    names = [
        None if (kind := foreign_kind(tmp_path / name)) is None else kind.name for name in ("a.bvh", "b.csv", "c.csv")
    ]
    assert names == ["BVH", "XDF", None]


@pytest.fixture
def workbook(tmp_path):
    book = openpyxl.Workbook()
    book.active.title = "about"
    book.active.append(["Recorder", 7])
    sheet = book.create_sheet("data")
    sheet.append(["Recorded", "by", "nobody"])
    sheet.append(["Time (s)", "A [mV]", "B", "Button"])
    for t, (a, b, _) in zip(T, SIGNALS, strict=True):
        sheet.append([float(t), float(a), None if b > 0.99 else float(b), b > 0])
    book.save(tmp_path / "signals.xlsx")
    return tmp_path / "signals.xlsx"


def test_a_workbook_is_read_by_its_largest_sheet(workbook):
    signals = read_signals(workbook)
    assert (signals.channel_names, signals.sample_rate) == (["A [mV]", "B", "Button"], 50.0)
    np.testing.assert_allclose(signals.values[:, 0], SIGNALS[:, 0])
    assert np.isnan(signals.values[SIGNALS[:, 1] > 0.99, 1]).all()
    assert str(read_table(workbook).places.row(0)).endswith("line 3")
    assert named_columns(workbook).units["A [mV]"] == "mV"


def test_cells_of_a_workbook_are_texts_of_a_table():
    cells = [
        datetime.time(10, 2, 3, 40_000),
        datetime.datetime(2024, 1, 2, 3, 4, 5, tzinfo=datetime.UTC),
        0.5,
        3,
        True,
        None,
        "a\tb",
    ]
    assert xlsx.line_of(cells) == "10:02:03.040000\t2024-01-02T03:04:05+00:00\t0.5\t3\t1\t\ta b"


@pytest.mark.parametrize(
    ("variables", "names"),
    [
        ({"t": T, "data": SIGNALS, "labels": np.array(["A", "B", "C"], object)}, ["A", "B", "C"]),
        ({"time": T, "emg": SIGNALS.T}, ["emg_1", "emg_2", "emg_3"]),
        ({"rec": {"fs": 50.0, "elbow": SIGNALS[:, 0], "wrist": SIGNALS[:, 1]}}, ["rec.elbow", "rec.wrist"]),
        (
            {"EEG": {"srate": 50, "data": SIGNALS.T, "times": T * 1e3, "chanlocs": [{"labels": x} for x in "XYZ"]}},
            ["X", "Y", "Z"],
        ),
    ],
)
def test_variables_of_matlab_become_columns(tmp_path, variables, names):
    savemat(tmp_path / "signals.mat", variables)
    signals = read_signals(tmp_path / "signals.mat")
    assert (signals.channel_names, signals.sample_rate) == (names, 50.0)
    np.testing.assert_allclose(signals.values, SIGNALS[:, : len(names)])


def test_variables_of_another_length_are_left_out_and_named(tmp_path):
    savemat(tmp_path / "signals.mat", {"t": T, "data": SIGNALS, "baseline": np.zeros(12)})
    assert "left out: baseline" in str(read_signals(tmp_path / "signals.mat").damage)


def test_matlab_7_3_is_read_with_h5py(tmp_path):
    h5py = need_library("h5py")
    with h5py.File(tmp_path / "signals.mat", "w") as file:
        file["t"], file["rec/data"] = T[np.newaxis], SIGNALS.T
    recording = matlab.read(tmp_path / "signals.mat")
    np.testing.assert_allclose(recording.columns["rec.data_2"], SIGNALS[:, 1])


BVH = """HIERARCHY
ROOT Hips
{
  OFFSET 0 0 0
  CHANNELS 6 Xposition Yposition Zposition Zrotation Xrotation Yrotation
  JOINT LeftArm
  {
    OFFSET 0 10 0
    CHANNELS 3 Zrotation Xrotation Yrotation
    End Site
    {
      OFFSET 0 5 0
    }
  }
}
MOTION
Frames: 300
Frame Time: 0.02
"""


def test_a_hierarchy_of_joints_is_read(tmp_path):
    rows = "".join(
        " ".join(f"{value:.6f}" for value in [t, *[0] * 5, *row]) + "\n" for t, row in zip(T, SIGNALS, strict=True)
    )
    (tmp_path / "walk.bvh").write_text(BVH + rows + "0.1 0.2")
    signals = read_signals(tmp_path / "walk.bvh")
    assert (len(signals.t), signals.sample_rate) == (300, 50.0)
    assert signals.channel_names[-3:] == ["LeftArm Zrotation", "LeftArm Xrotation", "LeftArm Yrotation"]
    np.testing.assert_allclose(signals.values[:, -3:], SIGNALS, atol=1e-6)
    assert bvh.read(tmp_path / "walk.bvh").units["LeftArm Zrotation"] == "deg"


class XdfFile:
    """Streams as LabRecorder writes them (XDF 1.0): chunks of a length, a tag and a content."""

    def __init__(self):
        self.content = b"XDF:" + self.chunk(1, b'<?xml version="1.0"?><info><version>1.0</version></info>')

    @staticmethod
    def chunk(tag, content):
        return b"\x04" + (len(content) + 2).to_bytes(4, "little") + tag.to_bytes(2, "little") + content

    def add(self, number, name, rate, labels, t, values):
        channels = "".join(f"<channel><label>{label}</label><unit>mV</unit></channel>" for label in labels)
        info = (
            f"<?xml version='1.0'?><info><name>{name}</name><type>X</type><channel_count>{len(labels)}</channel_count>"
            f"<nominal_srate>{rate}</nominal_srate><channel_format>double64</channel_format>"
            f"<desc><channels>{channels}</channels></desc></info>"
        )
        stream = number.to_bytes(4, "little")
        samples = b"".join(
            b"\x08" + np.float64(moment).tobytes() + np.asarray(row, "<f8").tobytes()
            for moment, row in zip(t, values, strict=True)
        )
        self.content += self.chunk(2, stream + info.encode())
        self.content += self.chunk(3, stream + b"\x04" + len(t).to_bytes(4, "little") + samples)
        self.content += self.chunk(6, stream + b"<?xml version='1.0'?><info></info>")


def test_all_streams_of_xdf_stand_at_the_times_of_the_fastest(tmp_path):
    need_library("pyxdf")
    file = XdfFile()
    file.add(1, "shirt", 50, ["A", "B", "C"], 100 + T, SIGNALS)
    file.add(2, "slow", 10, ["D"], 100 + T[::5], SIGNALS[::5, :1])
    (tmp_path / "signals.xdf").write_bytes(file.content)
    signals = read_signals(tmp_path / "signals.xdf")
    assert signals.channel_names == ["shirt A", "shirt B", "shirt C", "slow D"]
    assert signals.sample_rate == pytest.approx(50.0, rel=1e-6)
    np.testing.assert_allclose(signals.values[:, :3], SIGNALS)
    np.testing.assert_allclose(signals.values[::5, 3], SIGNALS[::5, 0], atol=0.05)
    assert xdf.read(tmp_path / "signals.xdf").units["shirt A"] == "mV"


def test_a_slower_stream_has_its_newest_sample_and_none_when_it_is_old():
    fast = SampledStream("fast", T, SIGNALS[:, :1], ["A"], [""])
    slow = SampledStream("slow", np.array([0.5, 0.6, 0.7, 0.8]), np.arange(4.0)[:, np.newaxis], ["B"], ["V"])
    columns = joined([fast, slow]).columns
    assert list(columns) == ["t", "fast A", "slow B"]
    values = columns["slow B"]
    assert np.isnan(values[T < 0.5]).all()
    assert values[26] == 0.0
    assert values[37] == 2.0
    assert values[T == 1.0] == 3.0
    assert np.isnan(values[T > 1.15]).all()


def test_edf_is_read_with_edfio(tmp_path):
    edfio = need_library("edfio")
    signals = [edfio.EdfSignal(SIGNALS[:, i], sampling_frequency=50, label=name) for i, name in enumerate("AB")]
    edfio.Edf(signals).write(tmp_path / "signals.edf")
    recording = read_edf(tmp_path / "signals.edf")
    np.testing.assert_allclose(recording.columns["A"], SIGNALS[:, 0], atol=1e-3)
    np.testing.assert_allclose(recording.columns["t"], T)


def test_c3d_is_read_with_ezc3d(tmp_path):
    ezc3d = need_library("ezc3d")
    content = ezc3d.c3d()
    content["parameters"]["POINT"]["RATE"]["value"] = [50]
    content["parameters"]["POINT"]["LABELS"]["value"] = ["elbow"]
    content["data"]["points"] = np.vstack([SIGNALS.T, np.ones(300)])[:, np.newaxis]
    content.write(str(tmp_path / "signals.c3d"))
    recording = read_c3d(tmp_path / "signals.c3d")
    np.testing.assert_allclose(recording.columns["elbow y"], SIGNALS[:, 1], atol=1e-5)
    np.testing.assert_allclose(recording.columns["t"], T)


def test_a_missing_library_is_named():
    with pytest.raises(MissingLibraryError, match="no_such_library"):
        library("no_such_library.part")


@pytest.mark.parametrize(
    ("name", "content", "words"),
    [
        ("signals.mat", b"MATLAB 5.0 MAT-file" + bytes(200), "this MATLAB file is damaged"),
        ("signals.xlsx", b"PK\x03\x04 nothing", "this XLSX file is damaged"),
        ("signals.csv", b"PK\x03\x04 nothing", "this XLSX file is damaged"),
        ("signals.bvh", b"HIERARCHY\nROOT a\n", "this BVH file is damaged"),
        ("signals.xlsx", b"", "this XLSX file is damaged"),
    ],
)
def test_a_damaged_file_is_one_sentence(tmp_path, name, content, words):
    (tmp_path / name).write_bytes(content)
    with pytest.raises(ValueError, match=words) as refusal:
        read_signals(tmp_path / name)
    assert str(refusal.value).startswith(str(tmp_path / name))
    assert "\n" not in str(refusal.value)


def test_variables_without_signals_are_named(tmp_path):
    savemat(tmp_path / "signals.mat", {"words": "nothing", "number": 3.0})
    with pytest.raises(ValueError, match="this MATLAB file holds no signals"):
        read_signals(tmp_path / "signals.mat")
