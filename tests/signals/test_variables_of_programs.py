"""Variables of MATLAB as programs of laboratories write them, and the sheets of a suit's workbook."""

import numpy as np
import openpyxl
import pytest
from scipy.io import savemat

from app.signals.overview import overview
from app.signals.signals import ReadingOptions, read_signals

COUNT = 240
ROWS = np.arange(COUNT)
T = ROWS / 50
A, B = np.sin(ROWS / 9).round(4), (100 * np.cos(ROWS / 7)).round(3)


def cells(*items):
    array = np.empty(len(items), object)
    array[:] = items
    return array


VARIABLES = {
    "LabChart": (
        {
            "data": np.concatenate([A, B]),
            "datastart": np.array([[1.0], [1.0 + COUNT]]),
            "dataend": np.array([[1.0 * COUNT], [2.0 * COUNT]]),
            "titles": np.array(["Force", "EMG  "]),
            "samplerate": np.array([[50.0], [50.0]]),
        },
        ["Force", "EMG"],
    ),
    "Spike2": (
        {
            "Ch1": {"title": "Force", "interval": 0.02, "units": "N", "values": A},
            "Ch2": {"title": "EMG", "interval": 0.02, "units": "mV", "values": B},
        },
        ["Ch1.values", "Ch2.values"],
    ),
    "AcqKnowledge": (
        {"data": np.column_stack([A, B]), "isi": 20.0, "isi_units": "ms", "labels": cells("Force", "EMG")},
        ["Force", "EMG"],
    ),
    "Delsys": (
        {
            "Channels": cells("EMG 1", "EMG 2"),
            "Data": np.vstack([A, B]),
            "Time": np.vstack([T, T]),
            "Fs": np.array([[50.0], [50.0]]),
        },
        ["EMG 1", "EMG 2"],
    ),
    "EEGLAB": (
        {
            "EEG": {
                "srate": 50.0,
                "data": np.vstack([A, B]),
                "times": 1e3 * T,
                "event": np.zeros((0, 0)),
                "chanlocs": [{"labels": "Cz"}, {"labels": "Pz"}],
            }
        },
        ["Cz", "Pz"],
    ),
    "a cell for each channel": ({"fs": 50.0, "emg": cells(A, B)}, ["emg_1", "emg_2"]),
}


@pytest.mark.parametrize("program", VARIABLES)
def test_variables_of_a_program_are_read(tmp_path, program):
    variables, names = VARIABLES[program]
    savemat(tmp_path / "signals.mat", variables)
    signals = read_signals(tmp_path / "signals.mat")
    assert (signals.channel_names, signals.sample_rate) == (names, 50.0)
    np.testing.assert_allclose(signals.values, np.column_stack([A, B]))


@pytest.fixture
def workbook(tmp_path):
    """The workbook of a suit with sensors: a sheet about the recording, and one for each kind of result."""
    book = openpyxl.Workbook()
    book.active.title = "General Information"
    book.active.append(["Frame Rate", 50])
    for title, count in (("Segment Position", 2), ("Joint Angles", 1)):
        sheet = book.create_sheet(title)
        sheet.append(["Frame", *["Right Elbow x", "Right Elbow y"][:count]])
        for i in range(COUNT):
            sheet.append([i, *[float(A[i]), float(B[i])][:count]])
    book.save(tmp_path / "suit.xlsx")
    return tmp_path / "suit.xlsx"


def test_the_sheets_of_a_workbook_are_its_parts(workbook):
    found = overview(workbook)
    assert (found.kind, [part.name for part in found.parts]) == (
        "XLSX",
        ["General Information", "Segment Position", "Joint Angles"],
    )
    assert found.signals is not None
    assert (found.signals.channel_names, found.signals.sample_rate) == (["Right Elbow x", "Right Elbow y"], 50.0)
    assert "The sheet Segment Position was read; these others were left out: Joint Angles." in str(found.signals.damage)
    alone = read_signals(workbook, options=ReadingOptions(part="Joint Angles"))
    assert (alone.channel_names, alone.sample_rate) == (["Right Elbow x"], 50.0)
    with pytest.raises(ValueError, match="there is no part 'Ankles'"):
        read_signals(workbook, options=ReadingOptions(part="Ankles"))
