"""Checks the rows and texts of an archive: nothing is imported that this program would not have stored."""

from typing import Any

from pydantic import ValidationError

from app.calibration.profile import CalibrationProfile
from app.calibration.vocabulary import DriveParameters
from app.exports.archive.archive_list import RUN_ID
from app.exports.archive.open_archive import OpenArchive
from app.scoring.interface_test.interface_measures import check_documents
from app.store.records.patient_rows import Rows, WrongRows, check_rows
from app.visible_text import visible_line, visible_lines

WRONG = "{file}: this archive cannot be read, because {why}; nothing was imported."


def checked_rows(archive: OpenArchive) -> Rows:
    """Return the rows of an archive; ValueError with one sentence when one of them is wrong."""
    document = archive.patient()
    try:
        rows = check_rows(document.get("tables") if isinstance(document, dict) else None)
        _check_contents(rows, archive)
    except (WrongRows, ValidationError, TypeError, KeyError) as error:
        why = str(error) if isinstance(error, WrongRows) else "one of its documents has another form"
        raise ValueError(WRONG.format(file=archive.file, why=why)) from error
    except ValueError as error:
        raise ValueError(WRONG.format(file=archive.file, why=f"a text in it is refused: {error}")) from error
    return rows


def _check_contents(rows: Rows, archive: OpenArchive) -> None:
    """Raise WrongRows or ValueError for documents and texts that this program would not have stored."""
    patient = rows["patient"][0]
    for name in ("code", "pseudonym"):
        visible_line(patient[name])
    visible_lines(patient["note"])
    visible_line(archive.listed.clinic)
    runs = [row["id"] for row in rows["run"]]
    if len(runs) != len(set(runs)) or not all(RUN_ID.fullmatch(run) for run in runs):
        raise WrongRows("its recordings have wrong names")
    if not {name.split("/")[1] for name in archive.listed.files if "/" in name} <= set(runs):
        raise WrongRows("it has a recording that no row names")
    for row in rows["moment_comment"]:
        if not row["author"]:
            raise WrongRows("a comment in it has no author")
        visible_line(row["author"])
    for row in rows["comment_revision"]:
        visible_lines(row["text"])
    for row in rows["interface_test"]:
        check_documents(row["plan"], row["measures"], row["workload"])
    profiles: dict[Any, Any] = {}
    for row in rows["profile"]:
        profiles[row["id"]] = CalibrationProfile.model_validate(row["document"]).model_dump(mode="json")
    for row in rows["parameters"]:
        DriveParameters.model_validate({**row["settings"], "profile": profiles[row["profile_id"]]})
