"""CSV files of an export, opened as a spreadsheet program opens them by a double click.

No spreadsheet program is installed here. `opened` follows the rules of Excel for a CSV file: UTF-8 only behind a byte
order mark, otherwise the code page of Windows; cells as in the dialect "excel" of Python's csv (commas, doubled
quotes); a cell that begins like a formula, also with a full-width sign, is one unless it is a number.
"""

import csv
import re
from codecs import BOM_UTF8
from contextlib import closing

import pytest
from exported_clinic import RUN, make_clinic

from app.csv_cells import SPREADSHEET_BEGIN, csv_line
from app.features.exports.csv_tables import trial_csv, write_csv
from app.features.exports.export_material import exported_material
from app.features.log.service import exported_lines
from app.recording.groups import read_in_groups
from app.store.database import Database
from app.store.patients import find_patient
from app.store.runs import keep_trial

REASON = 'müde – Ελένη 東京; 50 % «links», "Pause"\nbis 10:30'
CODE = "=Zoë-1"
FORMULA = re.compile(r"[=+\-@\t\r\n＝＋－＠]")
NUMBER = re.compile(r"-?\d+(\.\d+)?(e[+-]?\d+)?", re.IGNORECASE)


def opened(content: bytes) -> list[list[str]]:
    """Return the cells of a CSV file as a spreadsheet program shows them."""
    text = content.decode("utf-8-sig" if content.startswith(BOM_UTF8) else "cp1252", "replace")
    rows = list(csv.reader(text.splitlines(keepends=True), dialect="excel", strict=True))
    assert {len(row) for row in rows} == {len(rows[0])}
    assert [cell for row in rows for cell in row if FORMULA.match(cell) and not NUMBER.fullmatch(cell)] == []
    return rows


@pytest.fixture(scope="module")
def clinic(tmp_path_factory):
    """Return a clinic whose patient's code and reason have letters beyond ASCII; its database is open."""
    settings = make_clinic(tmp_path_factory.mktemp("clinic"))
    with closing(Database(settings.database)) as database:
        with database.transaction() as db:
            find_patient(db, 1).code = CODE
            keep_trial(db, 1, REASON)
        yield settings, database


def test_tables_of_an_export_show_every_letter_of_every_script(clinic):
    settings, database = clinic
    material = exported_material(database, 1, None, "csv", "Zoë", settings.runs, lambda *_: {}, place=settings.state)
    head, row = opened(trial_csv(material, {}).encode())
    shown = dict(zip(head, row, strict=True))
    assert (shown["patient"], shown["reason_left_out"]) == (f"'{CODE}", REASON)


def test_the_log_shows_every_letter_of_every_script(clinic):
    _, database = clinic
    head, *rows = opened("".join(exported_lines(database, as_csv=True)).encode())
    assert "Zoë" in {row[head.index("person")] for row in rows}


def test_a_recording_has_its_names_and_its_numbers(clinic, tmp_path):
    settings, _ = clinic
    (file,) = write_csv(read_in_groups(settings.runs / RUN), tmp_path, "run")
    assert file.read_bytes().startswith(BOM_UTF8)
    head, *rows = opened(file.read_bytes())
    assert head[0] == "t"
    assert all(float(row[0]) > 0 for row in rows)
    shown = [dict(zip(head, row, strict=True)) for row in rows]
    assert all(NUMBER.fullmatch(cell) for row in shown for cell in row.values() if cell)  # empty: not measured
    assert any(row["u1"].startswith("-") or row["u2"].startswith("-") for row in shown)  # a number, not a formula


@pytest.mark.parametrize(
    ("text", "shown"),
    [
        *((f"{sign}1+1", f"'{sign}1+1") for sign in "=+-@\t\r\n＝＋－＠"),
        *((text, text) for text in ("müde, aber gut", 'say "Ah"', "a;b", "1,5", "two\nlines", "", "1-2")),
    ],
)
def test_a_text_is_shown_as_it_is_and_never_computed(text, shown):
    (row,) = opened((SPREADSHEET_BEGIN + csv_line([text, -1.5, 1e-7, None, 3])).encode())
    assert row == [shown, "-1.5", "1e-07", "", "3"]
