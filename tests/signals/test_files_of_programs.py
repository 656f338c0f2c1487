"""Files as programs of laboratories and telephones write them, by their public descriptions: what each is read as.

A line of the table: how the file begins, how its rows are written, and the time, the sample rate and the channels that
are right.
"""

import json
from typing import NamedTuple

import numpy as np
import pyarrow as pa
import pyarrow.parquet as pq
import pytest

from app.signals.columns import named_columns, read_table
from app.signals.overview import overview
from app.signals.signals import ReadingOptions, read_signals

COUNT = 240
ROWS = np.arange(COUNT)
T = ROWS / 50
A, B = np.sin(ROWS / 9).round(4), (100 * np.cos(ROWS / 7)).round(3)
EPOCH = 1_706_282_470.0  # 2024-01-26 15:21:10 UTC


def clock(t, mark="."):
    seconds = 10 + t
    return f"15:{21 + int(seconds // 60):02}:{int(seconds % 60):02}{mark}{round(1000 * (seconds % 1)):03}"


def rows(form, t=T, ending="\n", **more):
    """Return a line for each sample: `form` names t, a, b, i, clock, and what is in `more`."""
    return "".join(
        form.format(t=t[i], a=A[i], b=B[i], i=i, clock=clock(T[i]), **{name: cells[i] for name, cells in more.items()})
        + ending
        for i in range(COUNT)
    )


class File(NamedTuple):
    """A file of a program, and what is right."""

    text: str
    time: str | None  # the column of times; None: the file states a sample rate
    channels: tuple[str, ...]
    unit: str | None = "s"
    rate: float = 50.0
    name: str = "recording.csv"


MARKERS = ["", *["n/a"] * (COUNT - 40), *["Start"] * 39]
BURSTS = EPOCH + np.sort(np.floor((ROWS + 5 * np.sin(ROWS)) / 8) * 0.16 + 1e-4 * (ROWS % 3))  # as a radio delivers
OPENSIGNALS = json.dumps({"00:07": {"device": "bitalino_rev", "column": ["nSeq", "I1", "A1"], "sampling rate": 50}})
DELSYS = "".join(
    f"{i / 50:.4f},{A[i]},{i / 10:.4f},{B[5 * i]},{-B[5 * i]}\n" if 5 * i < COUNT else f"{i / 50:.4f},{A[i]},,,\n"
    for i in range(COUNT)
)
DOT = (4_294_967_296 - 2_000_000 + 20_000 * ROWS) % 4_294_967_296  # µs of 32 bits that begin again at 0
FILES = {
    "LabChart": File(
        "Interval=\t0.02 s\nExcelDateTime=\t4.5317e+04\t26/01/2024 15:21:10.0\nTimeFormat=\tStartOfBlock\n"
        "ChannelTitle=\tForce\tEMG\nRange=\t10.000 V\t10.000 V\nUnitName=\tN\tmV\n" + rows("{t:.2f}\t{a}\t{b}"),
        "Time",
        ("Force", "EMG"),
        name="recording.txt",
    ),
    "LabChart, with a comment": File(
        "Interval=\t0.02 s\nChannelTitle=\tForce\tEMG\nRange=\t10.000 V\t10.000 V\n"
        + rows("{t:.2f}\t{a}\t{b}").replace("\n0.40\t", "\t#* begin\n0.40\t"),
        "Time",
        ("Force", "EMG"),
    ),
    "AcqKnowledge in minutes": File(
        f"rest.acq\n20 msec/sample\n2 channels\nForce\nN\nEMG\nmV\nmin,CH1,CH2,\n,{COUNT},{COUNT},\n"
        + rows("{t:.8f},{a},{b},", T / 60),
        "min",
        ("CH1", "CH2"),
        "min",
    ),
    "AcqKnowledge in milliseconds": File(
        f"rest.acq\n20 msec/sample\n1 channels\nForce\nN\nms\tCH1\t\n\t{COUNT}\t\n" + rows("{t}\t{a}\t", 1e3 * T),
        "ms",
        ("CH1",),
        "ms",
    ),
    "Noraxon": File(
        'Name,Rest\n\n"time,s","Marker","LT BICEPS,uV","RT BICEPS,uV"\n' + rows("{t:.6f},{mark},{a},{b}", mark=MARKERS),
        "time,s",
        ("LT BICEPS,uV", "RT BICEPS,uV"),
    ),
    "EMGworks": File(
        "X [s],L BIC: EMG 1 [V],X [s],L BIC: ACC X [g],L BIC: ACC Y [g]\n" + DELSYS,
        "t",
        ("L BIC: EMG 1 [V]", "L BIC: ACC X [g]", "L BIC: ACC Y [g]"),
    ),
    "Trigno Discover": File(
        "Application:,Trigno Discover\nCollection Length (seconds):,4.78\nSensor 1 (81728),,,,\n"
        "EMG 1 Time Series (s),EMG 1 (mV),ACC X Time Series (s),ACC X (G),ACC Y (G)\n" + DELSYS,
        "t",
        ("EMG 1 (mV)", "ACC X (G)", "ACC Y (G)"),
    ),
    "OpenSignals": File(
        f"# OpenSignals Text File Format. Version 1\n# {OPENSIGNALS}\n# EndOfHeader\n"
        + rows("{seq}\t{i}\t{b}\t", seq=ROWS % 16),
        None,
        ("I1", "A1"),
        name="opensignals.txt",
    ),
    "Shimmer Consensys": File(
        '"sep=,"\nShimmer_5E3F_Timestamp_Unix_CAL,Shimmer_5E3F_Accel_LN_X_CAL,Shimmer_5E3F_Mag_X_CAL\n'
        "ms,m/(s^2),local_flux\n" + rows("{t:.3f},{a},{b}", 1e3 * (EPOCH + T)),
        "Shimmer_5E3F_Timestamp_Unix_CAL",
        ("Shimmer_5E3F_Accel_LN_X_CAL", "Shimmer_5E3F_Mag_X_CAL"),
        "ms",
    ),
    "Motive": File(
        "Format Version,1.23,Take Name,T,Capture Frame Rate,50.000000\n\n"
        ",,Rigid Body,Rigid Body,Rigid Body,Rigid Body\n"
        ',,hand,hand,head,head\n,,"8C4F01AA","8C4F01AA","91D2B7E0","91D2B7E0"\n'
        ",,Rotation,Position,Rotation,Position\nFrame,Time (Seconds),X,X,X,X\n" + rows("{i},{t:.6f},{a},{b},{a},{b}"),
        "Time (Seconds)",
        ("hand Rotation X", "hand Position X", "head Rotation X", "head Position X"),
    ),
    "Nexus, trajectories": File(
        "Trajectories\n50\n,,P1:LSHO,,,P1:LELB,,\nFrame,Sub Frame,X,Y,Z,X,Y,Z\n,,mm,mm,mm,mm,mm,mm\n"
        + rows("{i},0,{a},{b},{a},{b},{a},{b}"),
        None,
        tuple(f"P1:{marker} {axis}" for marker in ("LSHO", "LELB") for axis in "XYZ"),
    ),
    "Nexus, devices in front of trajectories": File(
        "Devices\n50\n,,Plate - Force,,Plate - Moment\nFrame,Sub Frame,Fx,Fy,Mx\n,,N,N,N.mm\n"
        + rows("{i},0,{a},{b},{a}")
        + "\nTrajectories\n50\n,,P1:LSHO,,\nFrame,Sub Frame,X\n,,mm\n"
        + "1,0,2\n" * 3,
        None,
        ("Fx", "Fy", "Mx"),
    ),
    "QTM": File(
        "NO_OF_FRAMES\t240\nNO_OF_MARKERS\t2\nFREQUENCY\t50\nANALOG_FREQUENCY\t1000\nDATA_INCLUDED\t3D\n"
        "MARKER_NAMES\tL_SHO\tL_ELB\n" + rows("{a}\t{b}\t{a}\t{b}\t{a}\t{b}\t"),
        None,
        tuple(f"{marker} {axis}" for marker in ("L_SHO", "L_ELB") for axis in "XYZ"),
        name="walk.tsv",
    ),
    "STO of OpenSim": File(
        "Results\nversion=1\nnRows=240\nnColumns=3\ninDegrees=no\nendheader\n"
        "time\t/joint/elbow/value\t/joint/wrist/value\n" + rows("{t:.6f}\t{a}\t{b}"),
        "time",
        ("/joint/elbow/value", "/joint/wrist/value"),
        name="walk.sto",
    ),
    "OpenBCI, stamped by a radio": File(
        "%OpenBCI Raw EXG Data\n%Number of channels = 2\n%Sample Rate = 50 Hz\n"
        "Sample Index, EXG Channel 0, EXG Channel 1, Other, Other, Timestamp\n"
        + rows("{seq}, {a}, {b}, 0.0, 0.0, {t:.6f}", BURSTS, seq=ROWS % 256),
        "Timestamp",
        ("EXG Channel 0", "EXG Channel 1"),
    ),
    "Empatica": File(
        f"{EPOCH:.2f}, {EPOCH:.2f}\n50.000000, 50.000000\n" + rows("{a}, {b}"), None, ("column_1", "column_2")
    ),
    "Polar Sensor Logger": File(
        "Phone timestamp;sensor timestamp [ns];X [mg];Y [mg]\n"
        + rows("2024-01-26T{at};{t:.0f};{a};{b}", 1e9 * (T + 1000), at=[clock(T[i - i % 36]) for i in ROWS]),
        "sensor timestamp [ns]",
        ("X [mg]", "Y [mg]"),
        "ns",
    ),
    "phyphox, German": File(
        '"Time (s)"\t"Acceleration x (m/s^2)"\t"Acceleration y (m/s^2)"\n'
        + rows("{t:.9e}\t{a}\t{b}").replace(".", ","),
        "Time (s)",
        ("Acceleration x (m/s^2)", "Acceleration y (m/s^2)"),
    ),
    "Sensor Logger": File(
        "time,seconds_elapsed,z,y\n" + rows("{t:.0f},{s:.3f},{a},{b}", 1e9 * (EPOCH + T), s=T),
        "time",
        ("z", "y"),
        "ns",
    ),
    "SensorLog": File(
        "loggingTime(txt),loggingSample(N),accelerometerTimestamp_sinceReboot(s),accelerationX(G),accelerationY(G)\n"
        + rows("2024-01-26 {clock} +0100,{i},{t:.6f},{a},{b}", 5000 + T),
        "loggingTime(txt)",
        ("accelerationX(G)", "accelerationY(G)"),
    ),
    "MetaBase": File(
        "epoch (ms),time (-06:00),elapsed (s),x-axis (g),y-axis (g)\n"
        + rows("{t:.0f},2024-01-26T{clock},{s:.3f},{a},{b}", 1e3 * (EPOCH + T), s=T),
        "time (-06:00)",
        ("x-axis (g)", "y-axis (g)"),
    ),
    "Mind Monitor": File(
        "TimeStamp,RAW_TP9,RAW_AF7,Elements\n" + rows("2024-01-26 {clock},{a},{b},{mark}", mark=MARKERS),
        "TimeStamp",
        ("RAW_TP9", "RAW_AF7"),
    ),
    "Movella DOT": File(
        "sep=,\nDeviceTag:,left hand\nOutputRate:,50Hz\n\nPacketCounter,SampleTimeFine,Euler_X,Euler_Y\n"
        + rows("{i},{dot},{a},{b}", dot=DOT),
        "SampleTimeFine",
        ("Euler_X", "Euler_Y"),
        "us",
    ),
    "LP-Research": File(
        "SensorId, TimeStamp (s), FrameNumber, AccX (g), GyroX (deg/s)\n" + rows("1, {t:.4f}, {i}, {a}, {b}"),
        "TimeStamp (s)",
        ("AccX (g)", "GyroX (deg/s)"),
    ),
    "Arduino, monitor": File(
        "15:21:09.980 -> A0,A1\n" + rows("{clock} -> {a},{b}"), "Time", ("A0", "A1"), name="log.txt"
    ),
    "Arduino, plotter": File(rows("{clock} -> roll:{a}\tpitch:{b}"), "Time", ("roll", "pitch"), name="log.txt"),
    "ActiGraph": File(
        "---- Data File Created By ActiGraph GT9X date format M/d/yyyy at 50 Hz  Filter Normal ----\n"
        "Serial Number: X1\n--------------------\nAccelerometer X,Accelerometer Y\n" + rows("{a},{b}"),
        None,
        ("Accelerometer X", "Accelerometer Y"),
    ),
    "LabVIEW": File(
        "LabVIEW Measurement\t\nSeparator\tTab\n***End_of_Header***\t\n\t\nChannels\t2\t\nSamples\t240\t240\n"
        "Y_Unit_Label\tVolts\tVolts\nDelta_X\t0.020000\t0.020000\n***End_of_Header***\t\t\n"
        "X_Value\tVoltage_0\tVoltage_1\tComment\n" + rows("{t:.6f}\t{a}\t{b}"),
        "X_Value",
        ("Voltage_0", "Voltage_1"),
        name="recording.lvm",
    ),
    "pandas, times as index": File(",A,B\n" + rows("2024-01-26 {clock},{a},{b}"), "Time", ("A", "B")),
    "pandas, seconds as index": File(",A,B\n" + rows("{t:.2f},{a},{b}"), "Time", ("A", "B")),
    "pandas, no names": File(",0,1,2\n" + rows("{i},{t:.2f},{a},{b}"), "0", ("1", "2")),
    "units in words": File("t,A,B\nseconds,volts,volts\n" + rows("{t:.2f},{a},{b}"), "t", ("A", "B")),
    "Excel, German": File(
        "Datum;Uhrzeit;Kanal A [mV];Kanal B\n" + rows("26#01#2024;{clock};{a};{b}").replace(".", ",").replace("#", "."),
        "Uhrzeit",
        ("Kanal A [mV]", "Kanal B"),
    ),
    "PlotJuggler": File("__time,/imu/x,/imu/y\n" + rows("{t:.6f},{a},{b}", EPOCH + T), "__time", ("/imu/x", "/imu/y")),
    "a logger of 1 kHz that counts milliseconds": File(
        "Sampling rate [Hz]: 1000\ntime;A;B\n" + rows("{i};{a};{b}"), "time", ("A", "B"), "ms", 1000.0
    ),
    "a temperature called T": File("Time (s),T (°C),A\n" + rows("{t:.2f},{i},{a}"), "Time (s)", ("T (°C)", "A")),
}


@pytest.mark.parametrize("program", FILES)
def test_a_file_of_a_program_is_read(tmp_path, program):
    file = FILES[program]
    path = tmp_path / file.name
    path.write_text(file.text, encoding="utf-8")
    found = overview(path)
    assert found.problem is None
    assert (found.time, found.unit if file.time else None) == (file.time, file.unit if file.time else None)
    assert found.signals is not None
    assert found.signals.channel_names == list(file.channels)
    assert found.signals.sample_rate == pytest.approx(file.rate, rel=1e-3)
    assert len(found.signals.t) == COUNT
    assert np.diff(found.signals.t) == pytest.approx(1 / file.rate, rel=0.05)
    first = found.signals.values[:, 0]
    assert any(np.allclose(first, truth, equal_nan=True) for truth in (A, B, ROWS))


def test_a_signal_of_another_rate_stands_at_the_times_of_the_fastest(tmp_path):
    path = tmp_path / "emg.csv"
    path.write_text(FILES["EMGworks"].text)
    assert named_columns(path).names == ("t", "L BIC: EMG 1 [V]", "L BIC: ACC X [g]", "L BIC: ACC Y [g]")
    table = read_table(path, only=("t", "L BIC: ACC X [g]"))
    assert list(table.columns) == ["t", "L BIC: ACC X [g]"]
    np.testing.assert_allclose(table.columns["L BIC: ACC X [g]"], np.repeat(B[::5], 5)[:COUNT])


@pytest.mark.parametrize(
    ("program", "words"),
    [
        ("Noraxon", "left out: Marker"),
        ("Nexus, devices in front of trajectories", "Another table begins at"),
        ("OpenBCI, stamped by a radio", "count as even, at 50 Hz"),
        ("Movella DOT", "began again at 0, 1 time,"),
        ("ActiGraph", "count as even, at 50 Hz"),
    ],
)
def test_what_was_done_is_said(tmp_path, program, words):
    path = tmp_path / "recording.csv"
    path.write_text(FILES[program].text)
    assert words in str(read_signals(path).damage)


@pytest.mark.parametrize(
    ("head", "words"),
    [
        ("EMG bandwidth 20-450 Hz, notch 50 Hz\n", "no column 't'"),
        ("Heart rate: 72\nBaud rate: 4800\n", "no column 't'"),
    ],
)
def test_another_rate_than_that_of_the_samples_is_none(tmp_path, head, words):
    path = tmp_path / "recording.csv"
    path.write_text(f"{head}A;B\n" + rows("{a};{b}"))
    with pytest.raises(ValueError, match=words):
        read_signals(path)


def test_without_a_right_time_a_person_gives_the_sample_rate(tmp_path):
    path = tmp_path / "recording.csv"
    path.write_text("time;A\n" + rows("{t:.2f};{a}", T / 3))
    with pytest.raises(ValueError, match="without a column of times its sample rate is unknown"):
        read_signals(path, options=ReadingOptions(time=""))
    signals = read_signals(path, options=ReadingOptions(time="", rate=50.0))
    assert (signals.channel_names, signals.sample_rate, signals.t[1]) == (["A"], 50.0, 0.02)


def test_words_in_parquet_are_left_out_and_named(tmp_path):
    path = tmp_path / "recording.parquet"
    pq.write_table(pa.table({"t": T, "A": A, "note": ["x"] * COUNT, "button": ROWS % 2 == 0}), path)
    signals = read_signals(path)
    assert signals.channel_names == ["A", "button"]
    assert "left out: note" in str(signals.damage)
