"""What the reader of imports says of a recording, and writes."""

import tempfile
from pathlib import Path

import numpy as np
import pytest

from app.signals import import_reading
from app.signals.foreign import conversion
from app.signals.import_reading import answer
from app.signals.parquet_names import parquet_names
from app.texts import from_document

ROWS = 20


@pytest.fixture
def question(tmp_path):
    np.savetxt(tmp_path / "arm.csv", np.random.default_rng(1).normal(size=(ROWS, 2)), delimiter=",", header="a,b")
    return {
        "file": str(tmp_path / "arm.csv"),
        "options": {"time": "", "rate": 50.0},
        "out": str(tmp_path / "o.parquet"),
    }


def test_a_recording_that_no_list_would_show_is_refused(question, monkeypatch, tmp_path):
    monkeypatch.setattr(import_reading, "MOST_NUMBERS", 3 * ROWS)
    assert answer(question)["recording"]["problem"] == ""
    assert parquet_names(tmp_path / "o.parquet") == ["t", "body_1", "body_2"]
    monkeypatch.setattr(import_reading, "MOST_NUMBERS", 3 * ROWS - 1)
    problem = answer({**question, "out": ""})["recording"]["problem"]
    with pytest.raises(ValueError, match="holds more than 59 numbers, cut it") as refused:
        answer(question)
    assert str(from_document(problem)) == str(refused.value)


def test_what_is_converted_on_the_way_lies_beside_the_upload(tmp_path, monkeypatch):
    (tmp_path / "arm.bvh").write_text("HIERARCHY\n")
    places = []

    def ended(_module, question):
        places.append(question["folder"])
        raise ValueError("this file could not be read")

    monkeypatch.setattr(conversion, "read_isolated", ended)
    before = tempfile.gettempdir()
    with pytest.raises(ValueError, match="could not be read"):
        answer({"file": str(tmp_path / "arm.bvh"), "options": {}, "out": ""})
    assert [Path(place).parent for place in places] == [tmp_path] * len(places) != []
    assert tempfile.gettempdir() == before
