"""Checks the rows and texts of an archive: nothing is imported that this program would not have stored."""

from app.exports.archive.archive_list import RUN_ID
from app.exports.archive.open_archive import OpenArchive
from app.store.records.patient_rows import Rows, WrongRows, check_rows
from app.visible_text import visible_line

WRONG = "{file}: this archive cannot be read, because {why}; nothing was imported."


def checked_rows(archive: OpenArchive) -> Rows:
    """Return the rows of an archive; ValueError with one sentence when one of them is wrong."""
    document = archive.patient()
    try:
        rows = check_rows(document.get("tables") if isinstance(document, dict) else None)
        _check_contents(rows, archive)
    except WrongRows as error:
        raise ValueError(WRONG.format(file=archive.file, why=error)) from error
    except ValueError as error:
        raise ValueError(WRONG.format(file=archive.file, why=f"a text in it is refused: {error}")) from error
    return rows


def _check_contents(rows: Rows, archive: OpenArchive) -> None:
    """Raise WrongRows or ValueError for documents and texts that this program would not have stored."""
    visible_line(archive.listed.clinic)
    runs = [row["id"] for row in rows["run"]]
    if len(runs) != len(set(runs)) or not all(RUN_ID.fullmatch(run) for run in runs):
        raise WrongRows("its recordings have wrong names")
    if not {name.split("/")[1] for name in archive.listed.files if "/" in name} <= set(runs):
        raise WrongRows("it has a recording that no row names")
    if not all(row["author"] for row in rows.get("moment_comment", ())):
        raise WrongRows("a comment in it has no author")
