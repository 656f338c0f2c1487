"""`bodydrive export` writes one zip file, or nothing at all."""

import zipfile

from cli.answers import assert_refused
from clinic_rows import rows_in
from exported_clinic import CODE, make_clinic

from app.settings import Settings
from app.store.files import room_for_files
from app.store.files.disk_watch import DiskRoom


def test_a_patient_is_exported_and_progress_is_said(bodydrive, tmp_path):
    settings = make_clinic(tmp_path / "clinic")
    code, out, err = bodydrive("export", CODE, "--format", "xdf", "--out", "a.zip", "--state", settings.state)
    assert (code, out) == (0, "a.zip is written.\n")
    assert "Recording 1 of 1" in err
    with zipfile.ZipFile(tmp_path / "a.zip") as opened:
        assert opened.namelist() == ["export.json", "trials.csv", "session-01_run-001_drive.xdf"]


def test_bad_input_is_one_sentence_and_leaves_no_file(bodydrive, tmp_path):
    settings = make_clinic(tmp_path / "clinic")
    for words, sentence in (
        (["export", "P-9", "--out", "a.zip"], "There is no patient with the code 'P-9'"),
        (["export", CODE, "--out", "a.zip", "--format", "mat"], "give one of csv, parquet, xdf, bids, fhir"),
        (["export", CODE, "--out", "a.zip", "--session", "7"], "no session 7"),
        (["export", CODE, "--out", "clinic"], "is no ordinary file"),
    ):
        assert_refused(bodydrive(*words, "--state", settings.state), sentence)
    assert [file.name for file in tmp_path.iterdir()] == ["clinic"]


def test_a_patient_goes_to_another_clinic_by_two_commands(bodydrive, tmp_path):
    first = make_clinic(tmp_path / "clinic")
    with rows_in(Settings(state=tmp_path / "other"), "Hillside"):
        pass
    code, out, _err = bodydrive("archive", "make", CODE, "--out", "heron.zip", "--state", first.state)
    assert code == 0
    assert "Its hash is" in out
    with zipfile.ZipFile(tmp_path / "heron.zip") as opened:
        assert b"Course of 1 session" in opened.read("report.html")
    take = ("archive", "import", "heron.zip", "--state", tmp_path / "other")
    assert bodydrive(*take)[:2] == (0, f"The patient {CODE} is imported. Sessions: 1. Finished and kept trials: 1.\n")
    assert bodydrive(*take)[1].endswith("nothing was changed.\n")
    (tmp_path / "heron.zip").write_bytes(b"PK")
    assert_refused(bodydrive(*take), "this is no archive")


def test_an_archive_without_room_on_its_disk_is_refused_and_leaves_nothing(bodydrive, tmp_path, monkeypatch):
    settings = make_clinic(tmp_path / "clinic")
    looked = []
    monkeypatch.setattr(room_for_files, "disk_room", lambda place: looked.append(place) or DiskRoom(10**6, None))
    code, out, err = bodydrive("archive", "make", CODE, "--out", "stick/heron.zip", "--state", settings.state)
    assert (code, out) == (2, "")
    assert "must be free on the disk where it is made, and 1 MB are." in " ".join(err.split())
    assert looked[0].resolve() == tmp_path / "stick"  # and not the disk of the clinic
    assert list((tmp_path / "stick").iterdir()) == []
