"""Each export is read back by a program of its field, and its numbers are those of the recording."""

import csv
import json
import re
import subprocess
import sys
import zipfile
from functools import partial
from pathlib import Path

import numpy as np
import pyarrow.parquet as pa_parquet
import pytest
import pyxdf
from clinic_rows import rows_in
from exported_clinic import CODE, MEASURES, RUN, make_clinic, material_of
from stored_interface_test import MEASURES as TEST_MEASURES
from stored_interface_test import store_interface_test

from app import __version__
from app.clock import utc_now
from app.features.backup.contents import clinic_mark
from app.features.exports.forms import FORMS, Form
from app.features.exports.service import export_steps
from app.features.exports.xdf_form import COMMANDS, POSE
from app.features.log.service import read_log
from app.recording.reader import read_run
from app.refusals import Conflict
from app.scoring.interface_test.workload import Workload
from app.scoring.measures import TEST_MEASURES as TEST_UNITS
from app.settings import Settings
from app.store import people
from folders import ROOT


@pytest.fixture(scope="module")
def clinic(tmp_path_factory):
    return make_clinic(tmp_path_factory.mktemp("clinic"))


@pytest.fixture(scope="module")
def recorded(clinic):
    return read_run(clinic.runs / RUN)


@pytest.fixture
def export(clinic, exported):
    """Return a function that exports the patient of the clinic in a form."""
    return partial(exported, clinic)


@pytest.fixture
def exported(tmp_path):
    """Return a function that exports a clinic's patient, unpacks the zip file, and returns its folder."""

    def run(clinic: Settings, form: Form, session: int | None = None) -> Path:
        found = material_of(clinic, form, session=session)
        with rows_in(clinic) as rows:
            (newest,) = read_log(rows.db, 1)
            assert (newest.what, newest.details["form"]) == ("export", form)
        package = tmp_path / "export.zip"
        ends = [step(package) for step in export_steps(found, form)]
        assert ends == sorted(ends)
        first = package.read_bytes()
        for step in export_steps(found, form):
            step(package)
        assert package.read_bytes() == first  # the same content gives the same bytes
        with zipfile.ZipFile(package) as opened:
            assert opened.testzip() is None
            opened.extractall(tmp_path / "unpacked")
        return tmp_path / "unpacked"

    return run


STEM = "session-01_run-001_drive"


def equal(column, expected):
    np.testing.assert_array_equal(np.asarray(column, dtype=expected.dtype), expected)


def test_csv_has_the_numbers_of_the_recording(export, recorded):
    folder = export("csv", 1)
    with (folder / f"{STEM}.csv").open(newline="", encoding="utf-8-sig") as file:
        head, *rows = csv.reader(file)
    cells = dict(zip(head, zip(*rows, strict=True), strict=True))

    def numbers(name):
        return [float(cell) if cell else np.nan for cell in cells[name]]

    for name in ("run_t", "t", "t_device", "frame_seq", "u1", "omega", "x", "theta", "state", "driven_v"):
        equal(numbers(name), recorded.columns[name])
    equal(np.column_stack([numbers(f"values.c{i}") for i in range(52)]), recorded.columns["values"])
    gestures = recorded.meta["gestures"]
    equal(np.column_stack([numbers(f"activation.{name}") for name in gestures]), recorded.columns["activation"])
    assert json.loads((folder / f"{STEM}.json").read_text())["simulated"] == "yes"


def test_the_table_of_trials_has_measures_verdicts_and_sources_and_no_formula(export):
    with (export("csv") / "trials.csv").open(newline="", encoding="utf-8-sig") as file:
        (row,) = csv.DictReader(file)
    assert (float(row["e_diff [m2]"]), float(row["dist [m]"])) == (MEASURES["e_diff"], MEASURES["dist"])
    assert row["source"] == "Simulated shirt (simulated person), virtual chair: practice only"
    assert (row["shirt"], row["simulated"]) == ("simulator", "yes")
    assert (row["software"], row["exported_with"]) == ("test", __version__)
    assert row["patient"] == f"'{CODE}"
    assert float(row["sparc [1]"]) == MEASURES["sparc"]
    assert not any(cell.startswith(("=", "@", "+")) for cell in row.values())


@pytest.fixture(scope="module")
def tested(tmp_path_factory):
    """Return a clinic in which two two-minute tests followed the trial, one of them stopped."""
    settings = make_clinic(tmp_path_factory.mktemp("tested"))
    with rows_in(settings) as rows:
        done, stopped = store_interface_test(rows.db, 1), store_interface_test(rows.db, 1, end="stopped")
        done.workload = {**dict.fromkeys(Workload.model_fields), "effort": 60}
        done.run.ended = stopped.run.ended = utc_now()
    return settings


def test_two_minute_tests_are_a_table_of_their_own(exported, tested):
    folder = exported(tested, "csv")
    with (folder / "interface_tests.csv").open(newline="", encoding="utf-8-sig") as file:
        done, stopped = csv.DictReader(file)
    assert (done["test"], done["end"], stopped["end"]) == ("1", "complete", "stopped")
    assert float(done["throughput [bit/s]"]) == TEST_MEASURES["throughput"]
    assert (done["workload effort [0-100]"], done["workload mental [0-100]"]) == ("60", "")
    assert done["simulated"] == "yes"
    assert done["parameters_hash"]
    assert (done["software"], done["exported_with"]) == ("unknown", __version__)  # its recording is not there
    with (folder / "trials.csv").open(newline="", encoding="utf-8-sig") as file:
        assert len(list(csv.DictReader(file))) == 1


def test_a_complete_two_minute_test_is_observations_and_a_stopped_one_is_not(exported, tested):
    from fhir.resources.R4B.bundle import Bundle

    bundle = Bundle.model_validate_json((exported(tested, "fhir") / "bundle.json").read_bytes())
    of_tests = [one for entry in bundle.entry if "wo-minute test" in str((one := entry.resource).model_dump())]
    found = {one.code.coding[0].code: float(one.valueQuantity.value) for one in of_tests}
    assert found == {name: TEST_MEASURES[name] for name in TEST_UNITS}
    assert len(of_tests) == len(found)
    assert all("practice only" in one.note[0].text for one in of_tests)
    assert len({entry.fullUrl for entry in bundle.entry}) == len(bundle.entry)


def test_parquet_has_the_numbers_of_the_recording(export, recorded):
    table = pa_parquet.read_table(export("parquet") / f"{STEM}.parquet")
    equal(table["run_t"], recorded.columns["run_t"])
    values = [table[f"values.c{i}"].to_numpy() for i in range(52)]
    equal(np.column_stack(values), recorded.columns["values"])
    facts = json.loads(table.schema.metadata[b"bodydrive"])
    assert (facts["patient"], facts["simulated"], facts["software"]) == (CODE, "yes", "test")


def test_xdf_is_read_by_pyxdf_with_the_numbers_and_times_of_the_recording(export, recorded):
    streams, header = pyxdf.load_xdf(export("xdf") / f"{STEM}.xdf", dejitter_timestamps=False, synchronize_clocks=False)
    by_name = {stream["info"]["name"][0]: stream for stream in streams}
    frames = recorded.frames()
    equal(by_name["shirt"]["time_stamps"], frames["run_t"])
    equal(by_name["shirt"]["time_series"], frames["values"])
    for name, columns in (("commands", COMMANDS), ("pose", POSE)):
        equal(by_name[name]["time_stamps"], recorded.columns["run_t"])
        equal(by_name[name]["time_series"], np.column_stack([recorded.columns[each] for each in columns]))
    equal(by_name["gestures"]["time_series"][:, -1], recorded.columns["activation"][:, -1])
    equal(by_name["state"]["time_series"][:, 0], recorded.columns["state"].astype(np.int64))
    labels = [each["label"][0] for each in by_name["shirt"]["info"]["desc"][0]["channels"][0]["channel"]]
    assert labels == [f"c{i}" for i in range(52)]
    assert header["info"]["desc"][0]["simulated"] == ["yes"]


def validator_errors(folder):
    """Return what the BIDS validator says of a data set: its exit code and the errors."""
    command = [Path(sys.executable).parent / "bids-validator-deno", folder, "--json"]
    found = subprocess.run(command, capture_output=True, text=True, check=False, timeout=120)
    issues = json.loads(found.stdout)["issues"]["issues"]
    return found.returncode, [issue for issue in issues if issue.get("severity") == "error"]


def test_bids_passes_its_validator_also_where_a_recording_is_missing(exported, tested):
    folder = exported(tested, "bids")
    assert len(list(folder.glob("*.missing.txt"))) == 2
    assert validator_errors(folder) == (0, [])


def test_bids_passes_its_validator_with_the_numbers_of_the_recording(export, recorded):
    folder = export("bids")
    assert validator_errors(folder) == (0, [])
    (shirt,) = folder.rglob("*tracksys-shirt*_motion.tsv")
    rows = np.genfromtxt(shirt, delimiter="\t", missing_values="n/a")
    equal(rows[:, 0], recorded.frames()["run_t"])
    equal(rows[:, 1:], recorded.frames()["values"])
    (chair,) = folder.rglob("*tracksys-wheelchair*_motion.tsv")
    rows = np.genfromtxt(chair, delimiter="\t", missing_values="n/a")
    equal(rows[:, :4], np.column_stack([recorded.columns[name] for name in ("run_t", "x", "y", "theta")]))
    (channels,) = folder.rglob("*tracksys-shirt*_channels.tsv")
    assert {line.split("\t")[2] for line in channels.read_text().splitlines()[2:]} == {"MISC"}


def test_fhir_is_valid_r4b_with_ucum_units_and_the_same_numbers(export):
    from fhir.resources.R4B.bundle import Bundle

    bundle = Bundle.model_validate_json((export("fhir") / "bundle.json").read_bytes())
    patient, _device, *observations = [entry.resource for entry in bundle.entry]
    assert patient.identifier[0].value == CODE
    assert patient.name is None
    found = {one.code.coding[0].code: one for one in observations}
    assert set(found) == {"dist", "e_diff", "time", "stops", "sparc"}
    assert {name: float(one.valueQuantity.value) for name, one in found.items()} == {
        name: MEASURES[name] for name in found
    }
    assert found["e_diff"].valueQuantity.code == "m2"
    assert found["dist"].meta.security[0].code == "HTEST"
    assert "practice only" in found["dist"].note[0].text


def test_two_clinics_whose_patients_have_one_code_give_them_identifiers_of_their_own(
    clinic, export, exported, tmp_path
):
    def names(folder):
        entries = json.loads((folder / "bundle.json").read_text())["entry"]
        (identifier,) = entries[0]["resource"]["identifier"]
        return (identifier["system"], identifier["value"]), {entry["fullUrl"] for entry in entries}

    first, again = names(export("fhir")), names(export("fhir"))
    other = names(exported(make_clinic(tmp_path / "other"), "fhir"))
    assert first == again
    with rows_in(clinic) as rows:
        assert people.clinic_mark(rows.db) == clinic_mark(clinic)  # a restored clinic has the mark of its backups
    assert first[0][1] == other[0][1] == CODE
    assert first[0][0] != other[0][0]
    assert not first[1] & other[1]


def test_a_damaged_recording_is_exported_up_to_its_damage_and_says_so(clinic, export, recorded):
    file = clinic.runs / RUN / "end.json"
    whole = file.read_bytes()
    file.write_bytes(whole[:-3])
    try:
        folder = export("csv")
    finally:
        file.write_bytes(whole)
    assert "cannot be checked" in json.loads((folder / f"{STEM}.json").read_text())["damage"]
    assert len((folder / f"{STEM}.csv").read_text().splitlines()) == recorded.rows + 1


def test_without_consent_nothing_is_exported_and_nothing_is_logged(tmp_path):
    settings = make_clinic(tmp_path, consent=False)
    with pytest.raises(Conflict, match="has not consented to sharing outside"):
        material_of(settings, "csv")
    with rows_in(settings) as rows:
        assert "export" not in {row.what for row in read_log(rows.db, 100)}


def test_the_page_offers_every_form_in_its_order():
    card = (ROOT / "web_static" / "js" / "pages" / "session" / "export_card.js").read_text()
    offered = re.search(r"^const FORMS = \[(.+), ARCHIVE\];$", card, flags=re.MULTILINE)
    assert tuple(json.loads(f"[{offered[1]}]")) == FORMS
