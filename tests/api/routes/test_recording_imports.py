"""Recordings of other programs: shown, corrected, stored as recordings of this program; a bad one leaves nothing."""

import json
from typing import Any

import numpy as np
import openpyxl
import pyarrow.parquet as pq
import pytest
from session.same_reader import read_here

from app.api.routes import recording_imports
from app.hardware.shirt.playback import read_frames
from app.signals.foreign import conversion, xlsx
from app.signals.foreign.recording import MissingLibraryError
from app.store.keeping.keeping_tables import PatientFile

COUNT = 200
T = np.arange(COUNT) / 50
GERMAN = "Rekorder 7\nZeit (ms);Winkel [°];Kraft [N]\n" + "".join(
    f"{20 * i};{np.sin(i / 9):.4f};{'n/a' if i < 20 else i}\n".replace(".", ",") for i in range(COUNT)
)
COUNTED = "Zeit;a;b\n" + "".join(f"{i};{i % 7};{i % 5}\n" for i in range(COUNT))


def sent(*files: tuple[str, bytes | str], **options: Any) -> dict[str, Any]:
    """Return the form of an upload."""
    return {"files": [("files", file) for file in files], "data": {"options": json.dumps(options)}}


def shown(clinic: Any, *files: tuple[str, bytes | str], **options: Any) -> Any:
    return clinic.good("POST", "/equipment/files/overview", **sent(*files, **options))


def test_a_recording_is_shown_and_nothing_is_stored(in_session: Any, settings: Any) -> None:
    found = shown(in_session, ("Arm 1.csv", GERMAN))
    assert (found["name"], found["kind"], found["parts"]) == ("Arm-1.parquet", "CSV", [])
    assert (found["time"], found["unit"], found["rate"]) == ("Zeit (ms)", "ms", 50.0)
    assert (found["rows"], found["seconds"], found["problem"]) == (COUNT, pytest.approx(3.98), "")
    assert found["dialect"] == "It was read with semicolons between columns and decimal commas."
    assert "/tmp" not in json.dumps(found)
    angle, force = found["columns"][1:]
    assert (angle["name"], angle["unit"], angle["role"], angle["joint"]) == ("Winkel [°]", "°", "channel", "body")
    assert force["missing"] == pytest.approx(0.1)
    assert {"name": "left_elbow", "label": "Left elbow"} in found["joints"]
    assert found["joints"][-1] == {"name": "body", "label": "Body, as one joint"}
    assert in_session.good("GET", "/equipment")["files"] == []
    assert not settings.files.exists() or not list(settings.files.iterdir())


def test_what_is_confirmed_is_stored_and_is_a_recording_like_any_other(in_session: Any, settings: Any) -> None:
    channels = [{"column": "Kraft [N]", "joint": "left_wrist"}, {"column": "Winkel [°]", "joint": "left_elbow"}]
    stored = in_session.good("POST", "/equipment/files/import", **sent(("arm.csv", GERMAN), channels=channels))
    assert stored == {"name": "arm.parquet"}
    (file,) = in_session.good("GET", "/equipment")["files"]
    assert (file["name"], file["kind"]) == ("arm.parquet", "signals")
    frames = read_frames(settings.files / "arm.parquet")
    assert frames.layout.channel_names == ["left_wrist_1", "left_elbow_1"]
    assert frames.layout.joint_names == ["left_wrist", "left_elbow"]
    assert frames.sample_rate == 50.0
    np.testing.assert_allclose(frames.values[:, 1], np.sin(np.arange(COUNT) / 9), atol=1e-4)
    metadata = pq.read_schema(settings.files / "arm.parquet").field("left_wrist_1").metadata
    assert metadata == {b"column": b"Kraft [N]", b"unit": b"N"}
    used = in_session.good("PUT", "/equipment/shirt", json={"kind": "replay", "file": "arm.parquet", "loop": True})
    assert used["shirt"]["file"] == "arm.parquet"
    with in_session.rows() as rows:
        assert [kept.name for kept in rows.db.query(PatientFile)] == ["arm.parquet"]
    assert "file added" in [row.what for row in in_session.log()]


def test_a_question_is_shown_and_what_a_person_answers_counts(signed_in: Any) -> None:
    found = shown(signed_in, ("arm.csv", COUNTED))
    assert (found["rate"], found["time"]) == (None, None)
    assert found["problem"].startswith("arm.csv: ")
    assert found["problem"].endswith(".")
    assert [column["role"] for column in found["columns"]] == ["other-time", "channel", "channel"]
    refused = signed_in.refused(422, "POST", "/equipment/files/import", **sent(("arm.csv", COUNTED)))
    assert refused == found["problem"]
    assert signed_in.good("GET", "/equipment")["files"] == []
    answered = shown(signed_in, ("arm.csv", COUNTED), unit="ms")
    assert (answered["rate"], answered["time"], answered["problem"]) == (1000.0, "Zeit", "")
    even = shown(signed_in, ("arm.csv", COUNTED), time="", rate=50.0)
    assert (even["rate"], even["time"], even["unit"]) == (50.0, None, None)
    chosen = shown(signed_in, ("arm.csv", COUNTED), unit="ms", channels=[{"column": "b", "joint": "trunk"}])
    assert [(column["role"], column["joint"]) for column in chosen["columns"][1:]] == [
        ("unused", "body"),
        ("channel", "trunk"),
    ]


def test_a_taken_name_is_asked_about(signed_in: Any) -> None:
    form = sent(("arm.csv", GERMAN))
    signed_in.good("POST", "/equipment/files/import", **form)
    answer = signed_in("POST", "/equipment/files/import", **form)
    assert (answer.status_code, answer.json()["choice"]["proposed"]) == (409, "arm-2.parquet")
    both = signed_in.good("POST", "/equipment/files/import?same_name=keep-both", **form)
    assert both == {"name": "arm-2.parquet"}


def test_a_recording_becomes_that_of_no_patient_whose_session_began_while_it_was_read(
    in_session: Any, settings: Any, monkeypatch: Any
) -> None:
    read = recording_imports._read
    folders = []

    def meanwhile(upload: Any, *given: Any) -> Any:
        in_session.begin_session("B-12")
        folders.append(upload.folder.parent)
        return read(upload, *given)

    monkeypatch.setattr(recording_imports, "_read", meanwhile)
    said = in_session.refused(409, "POST", "/equipment/files/import", **sent(("arm.csv", GERMAN)))
    assert said.startswith("B-12 was opened")
    (folder,) = folders
    assert (folder.parent, folder.exists()) == (settings.state, False)  # where a deletion removes what was left
    assert not settings.files.exists() or not list(settings.files.iterdir())


def test_a_recording_of_bids_motion_comes_with_what_describes_it(signed_in: Any) -> None:
    stem = "sub-01_ses-first_task-reachingAndGrasping_acq-long_tracksys-inertialUnits_run-01"
    rows = "".join(f"{np.sin(i / 9):.4f}\t{i}\n" for i in range(COUNT))
    beside = [
        (f"{stem}_channels.tsv", "name\ttype\tunits\nleft_elbow_1\tMISC\tV\nleft_elbow_2\tMISC\tV\n"),
        (f"{stem}_motion.json", '{"SamplingFrequency": 50}'),
    ]
    found = shown(signed_in, (f"{stem}_motion.tsv", rows), *beside)
    assert ([column["name"] for column in found["columns"]], found["rate"]) == (["left_elbow_1", "left_elbow_2"], 50.0)


@pytest.mark.parametrize(
    ("files", "options", "words"),
    [
        ([("arm.csv", b"\x89PNG\r\n\x1a\n\x00\x00\xff\xfe")], {}, "arm.csv: this is not a CSV file but something"),
        ([("arm.csv", "Dear Sir,\nI have no signals.\n")], {}, "arm.csv: there is no table of numbers"),
        ([("arm.csv", b"")], {}, "'arm.csv' is empty"),
        ([("a.csv", GERMAN), ("b.csv", GERMAN)], {}, "One recording is imported at a time"),
        ([("a_channels.tsv", "name\n")], {}, "One recording is imported at a time"),
        ([("arm.csv", GERMAN)], {"rate": 1e9}, "The import, rate"),
        ([("arm.csv", GERMAN)], {"channels": []}, "The import, channels"),
        ([("arm.csv", GERMAN)], {"channels": [{"column": "a", "joint": "no name"}]}, "The import, channels[0].joint"),
        ([("arm.csv", GERMAN)], {"unknown": 1}, "The import, unknown"),
    ],
)
@pytest.mark.parametrize("route", ["overview", "import"])
def test_what_cannot_be_read_is_one_sentence(
    signed_in: Any, route: str, files: list[tuple[str, Any]], options: dict[str, Any], words: str
) -> None:
    said = signed_in.refused(422, "POST", f"/equipment/files/{route}", **sent(*files, **options))
    assert said.startswith(words)
    assert signed_in.good("GET", "/equipment")["files"] == []


def test_a_missing_library_is_named_with_its_extra(signed_in: Any, monkeypatch: Any, tmp_path: Any) -> None:
    def missing(_name: str) -> Any:
        raise MissingLibraryError("openpyxl")

    monkeypatch.setattr(conversion, "read_isolated", read_here)
    monkeypatch.setattr(xlsx, "library", missing)
    book = openpyxl.Workbook()
    book.save(tmp_path / "arm.xlsx")
    form = sent(("arm.xlsx", (tmp_path / "arm.xlsx").read_bytes()))
    said = signed_in.refused(422, "POST", "/equipment/files/overview", **form)
    assert said.startswith("arm.xlsx: XLSX files need the library openpyxl")
    assert "pip install 'bodydrive[files]'" in said
