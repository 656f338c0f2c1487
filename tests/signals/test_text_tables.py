"""Tables in text of any program: written in a random dialect they read back equal, and what was seen is read."""

import io
from typing import NamedTuple

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from app.signals.cells import MISSING
from app.signals.column_names import bare_name
from app.signals.columns import named_columns, read_table
from app.signals.signals import read_layout, read_signals
from folders import SHARED

CASES = SHARED / "data" / "cases"
WORDS = sorted(MISSING - {"", ".", "-", "--", "---", "?"})
NUMBERS = st.floats(-1e6, 1e6, allow_nan=False).map(lambda value: round(value, 6)) | st.just(float("nan"))
NAMES = ("A", "Strain B", "left elbow", "c_4")


class Form(NamedTuple):
    """How a program writes a table."""

    separator: str
    decimal: str
    encoding: str
    ending: str
    head: tuple[str, ...]
    units: str  # "", "row", "brackets"
    has_index: bool
    has_separators_behind: bool
    twins: int
    missing: str
    is_cut: bool
    blank: str


SIGNS = ((",", "."), (";", "."), (";", ","), ("\t", "."), ("\t", ","), ("|", "."), (" ", "."), (" ", ","))
HEADS = ((), ("# logger 1.2, 50 Hz",), ("% Sample Rate = 50 Hz", "%Board = 3"), ("Recorder 7", "", "serial: A-17"))
FORMS = st.builds(
    lambda signs, *rest: Form(*signs, *rest),
    st.sampled_from(SIGNS),
    st.sampled_from(["utf-8", "utf-8-sig", "utf-16", "utf-16-le", "cp1252"]),
    st.sampled_from(["\n", "\r\n"]),
    st.sampled_from(HEADS),
    st.sampled_from(["", "row", "brackets"]),
    st.booleans(),
    st.booleans(),
    st.sampled_from([0, 2, 3]),
    st.sampled_from(WORDS),
    st.booleans(),
    st.sampled_from(["", " "]),
)


def written(form, table):
    """Return the content of a file, and how many rows stand in it as a whole."""
    blanks = form.separator == " "
    units = form.units if not blanks or form.units == "row" else ""
    names = [name.replace(" ", "_") if blanks else name for name in NAMES[: len(table[0])]]
    header = ["t", *names]
    if units == "brackets":
        header = ["Time (s)", *(f"{name} [µV]" for name in names)]
    rows = [
        [f"{number / 50:.2f}", *(form.missing if np.isnan(cell) else repr(cell) for cell in row)]
        for number, row in enumerate(table)
    ]
    rows = [[cell.replace(".", form.decimal) if cell != form.missing else cell for cell in row] for row in rows]
    lines = [header, *([["s", *["mV"] * len(names)]] if units == "row" else []), *rows]
    lines = [[*line, *(["Other"] * form.twins if line is header else ["0"] * form.twins)] for line in lines]
    if units == "row":
        lines[1][1 + len(names) :] = ["V"] * form.twins
    if form.has_index and not blanks:
        above = len(lines) - len(rows)
        lines = [["" if at < above else str(at - above), *line] for at, line in enumerate(lines)]
    if form.has_separators_behind and not blanks:
        lines = [[*line, ""] for line in lines]
    text = io.StringIO()
    for line in form.head:
        text.write(f"{line}{form.ending}")
    glue = form.separator if blanks else f"{form.separator}{form.blank}"
    for line in lines:
        text.write(glue.join(line) + form.ending)
    content = text.getvalue()
    if form.is_cut and len(rows) > 3:
        content = content[: content.rstrip("\r\n").rfind(glue.strip(" ") or " ")]
        if form.has_separators_behind and not blanks:
            content = content[: content.rfind(form.separator)]
        return content.encode(form.encoding, "strict"), len(rows) - 1
    return content.encode(form.encoding), len(rows)


@settings(suppress_health_check=[HealthCheck.function_scoped_fixture], max_examples=300)
@given(
    st.integers(1, 4).flatmap(lambda width: st.lists(st.lists(NUMBERS, min_size=width, max_size=width), min_size=12)),
    FORMS,
)
def test_a_table_of_any_program_reads_equal(tmp_path, table, form):
    file = tmp_path / "table.csv"
    content, rows = written(form, table)
    file.write_bytes(content)
    found = read_table(file).columns
    truth = np.array(table)[:rows]
    time, *channels = (name for name in found if not name.startswith("Other"))
    np.testing.assert_allclose(found[time], np.round(np.arange(rows) / 50, 2))
    assert len(channels) == truth.shape[1]
    np.testing.assert_array_equal(np.column_stack([found[name] for name in channels]), truth)


COUNT = 20
ROWS = [(number / 50, 500 + number, -number / 4) for number in range(COUNT)]


def rows_of(form, ending="\n"):
    return "".join(form.format(*row, number=number) + ending for number, row in enumerate(ROWS))


PLAIN = rows_of("{:.2f},{},{}")
PROGRAMS = {
    "pandas": ",t,A,B\n" + rows_of("{number},{:.2f},{},{}"),
    "write.table of R": '"t" "A" "B"\n' + rows_of('"{number}" {:.2f} {} {}'),
    "savetxt of numpy": "# t A B\n" + rows_of("{:.18e} {:.18e} {:.18e}"),
    "SmartWheel": "t,A,B,\n" + rows_of("{:.2f},{},{},"),
    "separators behind rows only": "t,A,B\n" + rows_of("{:.2f},{},{},"),
    "a separator behind the header only": "t,A,B,\n" + PLAIN,
    "OpenBCI": "%OpenBCI Raw EXG Data\n%Sample Rate = 50 Hz\nSample Index, A, B, Other, Other, t, Time (Formatted)\n"
    + "".join(
        f"{number % 256}, {a}, {b}, 0.0, 0.0, {t:.2f}, 2024-01-26 15:21:10.{number:03}\n"
        for number, (t, a, b) in enumerate(ROWS)
    ),
    "markers over columns": "Trajectories\n50\n,,left,left\nFrame,t,A,B\n,s,mm,mm\n" + rows_of("{number},{:.2f},{},{}"),
    "TRC": "PathFileType\t4\t(X/Y/Z)\twalk.trc\nDataRate\tCameraRate\tNumFrames\n50\t50\t20\n"
    + "Frame#\tTime\tarm\t\t\n\t\tA\tB\n\n"
    + rows_of("{number}\t{:.2f}\t{}\t{}"),
    "MOT of OpenSim": "Coordinates\nversion=1\nnRows=20\nnColumns=3\ninDegrees=yes\n\nendheader\ntime\tA\tB\n"
    + rows_of("{:14.8f}\t{:14.8f}\t{:14.8f}"),
    "NGIMU": "Time (s),A (deg/s),B (g)\n" + rows_of("{:.2f},{},{}"),
    "MT Manager": "// General information:\n//  Device: MTw\nPacketCounter\tTime\tA\tB\n"
    + rows_of("{number:05}\t{:.2f}\t{}\t{}"),
    "Movella DOT": "sep=,\nDeviceTag:,7\nFirmwareVersion:,2.0.0\n\nPacketCounter,SampleTimeFine,A,B\n"
    + "".join(f"{number + 1},{1e6 * t:.0f},{a},{b}\n" for number, (t, a, b) in enumerate(ROWS)),
    "units in brackets": "t [s];A [mV];B [mV]\n" + rows_of("{:.2f};{};{}"),
    "quotation marks": '"t","A","B"\n' + rows_of('"{:.2f}","{}","{}"'),
    "German spreadsheet": "t;A;B\n" + rows_of("{:.2f};{};{}").replace(".", ",") + ";;\n;;\n",
    "blanks in columns": "   t      A      B\n" + rows_of("{:8.2f} {:6d} {:8.2f}"),
    "comments between rows": "t,A,B\n" + PLAIN.replace("\n0.10", "\n# button pressed\n0.10"),
    "a header again": "t,A,B\n" + PLAIN.replace("\n0.10", "\nt,A,B\n0.10"),
    "words": "t,event,A,B\n" + rows_of("{:.2f},start,{},{}"),
    "zeros of a card": "t,A,B\n" + PLAIN + "\0" * 300,
    "blank lines": "\n\nt,A,B\n\n" + PLAIN.replace("\n", "\n\n"),
    "a cut line": "t,A,B\n" + PLAIN + "0.40,5",
    "a cut number": "t,A,B\n" + rows_of("{:.2f},{},{:.2f}") + "0.40,520,-5.",
    "no end of the last line": "t,A,B\n" + rows_of("{:.2f},{},{:.2f}").rstrip("\n"),
    "pandas, read and written again": ",Unnamed: 0,t,A,B\n" + rows_of("{number},{number},{:.2f},{},{}"),
    "units that nobody knows": "t,A,B\nticks,kOhm/m,foo\n" + rows_of("{:.2f},{},{}"),
    "lines that sum up below the names": "t,A,B\nmin,500,-4.75\nmax,519,0\n" + PLAIN,
    "a line of hyphens below the names": "# t A B\n# -------\n" + rows_of("{:.2f} {} {}"),
    "errors of LibreOffice": "t,A,B,c\n" + rows_of("{:.2f},{},{},Err:502"),
}


@pytest.mark.parametrize("program", PROGRAMS)
def test_what_programs_write_is_read(tmp_path, program):
    file = tmp_path / "table.csv"
    file.write_text(PROGRAMS[program])
    signals = read_signals(file)
    names = [bare_name(name)[0].split()[-1] for name in signals.channel_names if name != "c"]
    assert names == ["A", "B"]
    np.testing.assert_allclose(signals.t, [t for t, _, _ in ROWS], atol=1e-9)
    np.testing.assert_allclose(signals.values[:, :2], [row[1:] for row in ROWS])
    assert signals.sample_rate == 50.0


@pytest.mark.parametrize(
    ("content", "words"),
    [
        ("t,A\n0,1\n0.1,2\n# x\n0.2,one\n", "line 5, column 'A': 'one' is not a number"),
        ("# a\n# b\nt,A\ns,mV\n0,1\n0.1,x\n", "line 6, column 'A': 'x' is not a number"),
        ("t,A,B\n0,1\n0.1,2\n", "line 2: 2 cells where the header has 3"),
        ("t,A\n0,1\n0.1,2,3\n0.2,1\n", "line 3: 3 cells where the header has 2"),
        ("t,A,,B\n0,1,2,3\n0.1,1,2,3\n", "line 1: column 3 has no name"),
        ("t,A,A\n0,1,2\n0.1,1,3\n", "line 1: there are two columns 'A'"),
        ("t,A\n0,ERR\n0.1,1\n0.2,1\n", "line 2, column 'A': 'ERR' is not a number"),
        ("t,A,B\ns,V,V\n0,ERR,1\n0.1,x,1\n0.2,1,1\n0.3,1,1\n", "line 3, column 'A': 'ERR' is not a number"),
        ("some words\nand more\n", "no table of numbers"),
    ],
)
def test_what_cannot_be_read_is_named_with_its_line(tmp_path, content, words):
    file = tmp_path / "table.csv"
    file.write_text(content)
    with pytest.raises(ValueError, match="table") as refusal:
        read_table(file)
    assert words in str(refusal.value)


def test_names_may_be_numbers(tmp_path):
    file = tmp_path / "table.csv"
    file.write_text("t,1,2\n" + PLAIN)
    assert read_signals(file).channel_names == ["1", "2"]


def test_a_table_without_a_header_has_numbered_columns(tmp_path):
    file = tmp_path / "table.tsv"
    file.write_text(rows_of("{:.2f}\t{}\t{}"))
    assert named_columns(file).names == ("column_1", "column_2", "column_3")
    assert read_signals(file).channel_names == ["column_2", "column_3"]


def test_a_table_of_brainflow_has_its_clock_from_1970(tmp_path):
    file = tmp_path / "brainflow.csv"
    rows = [[i % 256, a, np.sin(i), 0.0, 1_706_282_470 + t] for i, (t, a, _) in enumerate(ROWS)]
    file.write_text("".join("\t".join(f"{cell:.6f}" for cell in row) + "\n" for row in rows))
    signals = read_signals(file)
    assert "column_5" not in signals.channel_names
    assert signals.sample_rate == pytest.approx(50.0, rel=1e-3)


@pytest.mark.parametrize("has_latency", [True, False])
def test_a_table_of_bids_motion_has_its_names_and_rate_beside_it(tmp_path, has_latency):
    stem = "sub-1_task-walk_tracksys-imu"
    named = [("latency", "LATENCY", "s"), ("A", "ACCEL", "g"), ("B", "GYRO", "n/a")]
    named = named if has_latency else named[1:]
    lines = ["name\ttype\tunits", *("\t".join(channel) for channel in named)]
    (tmp_path / f"{stem}_channels.tsv").write_text("\n".join(lines) + "\n")
    (tmp_path / f"{stem}_motion.json").write_text('{"SamplingFrequency": 50}')
    form = "{:.2f}\t{}\t{}" if has_latency else "{1}\t{2}"
    (tmp_path / f"{stem}_motion.tsv").write_text(rows_of(form).replace("\t503\t", "\tn/a\t"))
    signals = read_signals(tmp_path / f"{stem}_motion.tsv")
    assert (signals.channel_names, signals.sample_rate) == (["A", "B"], 50.0)
    assert signals.t[-1] == pytest.approx(19 / 50)


def test_a_place_counts_the_lines_of_the_file(tmp_path):
    file = tmp_path / "table.csv"
    file.write_text("# logger\n\nt,A\ns,mV\n0,1\n0.1,1\n,\n# pause\n0.3,\n")
    places = read_table(file).places
    assert [str(places.row(row)).rpartition(" ")[2] for row in range(3)] == ["5", "6", "9"]


@pytest.mark.skipif(not CASES.is_dir(), reason="the files of other laboratories are not here")
@pytest.mark.parametrize(
    "name",
    [
        *("index-column", "trailing-comma", "unused-twins", "units-row", "device-header", "cut-last-line"),
        "missing-words",
    ],
)
def test_the_tables_that_were_seen(name):
    truth = read_signals(CASES / "signals-control.csv").values[:600]
    layout = read_layout(CASES / "signals.layout.json")
    signals = read_signals(CASES / f"signals-{name}.csv", layout)
    assert signals.channel_names == ["A", "B", "C"]
    assert signals.sample_rate == 50.0
    assert len(signals.t) == (599 if name == "cut-last-line" else 600)
    there = ~np.isnan(signals.values)
    np.testing.assert_array_equal(signals.values[there], truth[: len(there)][there])
    assert there.all() == (name != "missing-words")
    assert there.mean() > 0.95
