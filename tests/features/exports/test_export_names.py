"""What leaves the clinic says who the patient is by the code only."""

import zipfile
from pathlib import Path
from typing import get_args

import pyarrow.parquet as pa_parquet
import pytest
from clinic_rows import rows_in
from exported_clinic import CODE, make_clinic, material_of

from app.features.exports.bids_form import label
from app.features.exports.forms import Form
from app.features.exports.service import export_steps
from app.settings import Settings
from app.store.tables import Patient

PSEUDONYM, NOTE = "Bartailed", "likes the window"


@pytest.fixture(scope="module")
def clinic(tmp_path_factory: pytest.TempPathFactory) -> Settings:
    settings = make_clinic(tmp_path_factory.mktemp("clinic"))
    with rows_in(settings) as rows:
        patient = rows.db.get_one(Patient, 1)
        patient.pseudonym, patient.note = PSEUDONYM, NOTE
    return settings


@pytest.mark.parametrize("form", get_args(Form))
def test_no_export_holds_the_pseudonym_or_the_note_and_only_bids_names_files_by_the_code(
    clinic: Settings, tmp_path: Path, form: Form
) -> None:
    package = tmp_path / "export.zip"
    for step in export_steps(material_of(clinic, form), form):
        step(package)
    with zipfile.ZipFile(package) as opened:
        opened.extractall(tmp_path / "unpacked")
        names = opened.namelist()
    said = "\n".join(names).encode()
    for name in names:
        file = tmp_path / "unpacked" / name
        said += file.read_bytes()
        if file.suffix == ".parquet":
            said += b"".join((pa_parquet.read_schema(file).metadata or {}).values())
    assert PSEUDONYM.encode() not in said
    assert NOTE.encode() not in said
    assert CODE.encode() in said  # whoever gets it knows the patient by the code
    code = label(CODE)
    named = {name for name in names if code in name or CODE in name}
    by_participant = {name for name in names if name.startswith(f"sub-{code}/")}
    assert named == by_participant
    assert bool(named) == (form == "bids")
