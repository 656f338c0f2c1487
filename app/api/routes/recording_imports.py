"""Recordings of other programs: what an uploaded one holds, corrected by a person, then stored as one of this program.

Nothing is kept between two requests: the page sends the file again with what a person has corrected.
"""

from collections.abc import Sequence
from pathlib import Path
from typing import Annotated, Any, Final, NamedTuple

from fastapi import APIRouter, Form, HTTPException, UploadFile
from pydantic import ValidationError

from app.api.deps import Clinician, Db, LivePart, ReadingsPart, ReplacedFilesPart, SettingsPart
from app.api.foreign_files import read_or_refuse, whole_sentence
from app.api.page_session import LOOKS, ClinicianInSession, any_session
from app.api.routes.signal_uploads import MOST_SIGNAL_BYTES, harmless_name, put_file
from app.layout import USUAL_JOINTS, Joint, joint_title
from app.news import News
from app.quantities import Document
from app.sentences import one_sentence
from app.session.page_session import require_page_session
from app.signals.bids_motion import CHANNELS, SIDECAR
from app.signals.import_options import ImportOptions, TimeUnit
from app.signals.joint_names import WHOLE_BODY, joint_label
from app.signals.overview import Role
from app.store.database import Database
from app.store.files.name_conflicts import SameName, log_details
from app.store.files.temporary_folders import temporary_folder
from app.store.keeping.patient_files import add_patient_file
from app.store.log import write_log
from app.texts import Text, from_document

READER: Final = "app.signals.import_reading"
WHERE: Final = Text("api-the-import")
WHOLE: Final = Text("api-joint-body")
BESIDE: Final = (CHANNELS, SIDECAR)  # ends of the names of files that lie beside a recording
LONGEST_NAME: Final = 200  # letters: the files beside a recording have the beginning of its name
ENDING: Final = ".parquet"

router = APIRouter(prefix="/equipment/files", tags=["equipment"])


class RecordingColumn(Document):
    """A column of an uploaded recording."""

    name: str
    unit: str  # empty where the file says none
    role: Role
    least: float | None  # of its numbers, null without one
    most: float | None
    missing: float | None  # share of its rows without a number; null where it was not read
    joint: str | None  # chosen or proposed; null for a column that can be no channel


class RecordingPart(Document):
    """A part of an uploaded recording that can be read alone: a stream, or a sheet."""

    name: str
    channels: int
    samples: int


class JointChoice(Document):
    """A joint to choose for a channel."""

    name: str
    label: str


class RecordingOverview(Document):
    """What an uploaded recording holds, and how it is read."""

    name: str  # under which it would be stored
    kind: str  # a format, "CSV" for all tables in text
    dialect: str  # the separator and the decimal sign in a sentence, empty for the usual ones
    parts: list[RecordingPart]  # empty where there is one table
    rows: int | None
    columns: list[RecordingColumn]
    time: str | None  # the column of times; null where there is none, or where it is a question
    unit: TimeUnit | None  # of the times
    rate: float | None  # Hz; null where a person must correct something first
    seconds: float | None
    message: str  # how the times were read, what was mended and what was left out
    problem: str  # what a person must correct first, empty for nothing
    joints: list[JointChoice]


class StoredRecording(Document):
    """The name under which an imported recording is stored."""

    name: str


class Upload(NamedTuple):
    """An uploaded recording in a folder, beside it what describes it."""

    folder: Path
    file: Path

    @property
    def stored_name(self) -> str:
        """Return the name under which it is stored."""
        return harmless_name(f"{self.file.stem}{ENDING}")


@router.post("/overview")
@any_session(LOOKS)
async def view_recording(
    files: list[UploadFile],
    _person: Clinician,
    settings: SettingsPart,
    readings: ReadingsPart,
    options: Annotated[str, Form(max_length=200_000)] = "{}",
) -> RecordingOverview:
    """Return what an uploaded recording holds, and store nothing.

    The multipart field `files`: the recording, at most 64 MB, for BIDS-motion with the files that describe it.
    `options`: a JSON object, `ImportOptions` of `app/signals/import_options.py`.
    """
    corrected = _parsed(options)

    def look() -> RecordingOverview:
        with temporary_folder(settings.state, "import") as folder:
            upload = _written(folder, files)
            return _overview(upload, _read(upload, corrected, ""))

    return await readings.run(look)


@router.post("/import", status_code=201)
async def import_recording(
    files: list[UploadFile],
    person: ClinicianInSession,
    *,
    settings: SettingsPart,
    database: Db,
    replaced: ReplacedFilesPart,
    readings: ReadingsPart,
    live: LivePart,
    options: Annotated[str, Form(max_length=200_000)] = "{}",
    same_name: SameName = "ask",
) -> StoredRecording:
    """Store an uploaded recording in the form of this program; fields as of `POST /equipment/files/overview`.

    `same_name`: what to do when its name is taken. It belongs to the patient whose session is open.
    """
    corrected = _parsed(options)

    def keep() -> str:
        with temporary_folder(settings.state, "import") as folder:
            upload = _written(folder, files)
            replaced.check_name("file", upload.stored_name, same_name)
            out = folder / upload.stored_name
            _read(upload, corrected, str(out))
            content = out.read_bytes()
        with database.reading() as db:
            require_page_session(db)  # another session may have begun while it was read
        name = put_file(replaced, upload.stored_name, content, same_name)
        _note(database, person.name, name, len(content), same_name)
        return name

    name = await readings.run(keep)
    live.notify(News(what="equipment"))
    return StoredRecording(name=name)


def _parsed(options: str) -> ImportOptions:
    """Return what a person has corrected; 422 with the field that is wrong."""
    try:
        return ImportOptions.model_validate_json(options)
    except ValidationError as error:
        raise HTTPException(422, Text("api-problem", problem=one_sentence(error, WHERE))) from error


def _written(folder: Path, files: Sequence[UploadFile]) -> Upload:
    """Write the uploaded files under harmless names into a folder below `folder`."""
    given = folder / "given"
    given.mkdir()
    recordings = []
    left = MOST_SIGNAL_BYTES
    for file in files:
        name = harmless_name(file.filename or "", LONGEST_NAME)
        content = file.file.read(left + 1)
        left -= len(content)
        if left < 0:
            raise HTTPException(413, Text("api-upload-too-large", name=name, megabytes=MOST_SIGNAL_BYTES // 1_000_000))
        if not content:
            raise HTTPException(422, Text("api-upload-empty", name=name))
        (given / name).write_bytes(content)
        if not name.endswith(BESIDE):
            recordings.append(given / name)
    if len(recordings) != 1:
        raise HTTPException(422, Text("api-one-recording"))
    return Upload(given, recordings[0])


def _read(upload: Upload, options: ImportOptions, out: str) -> dict[str, Any]:
    """Return what the reader of foreign files says of a recording; it writes the signals to `out`, unless empty."""
    question = {"file": str(upload.file), "options": options.model_dump(mode="json"), "out": out}
    recording: dict[str, Any] = read_or_refuse(READER, question, [f"{upload.folder}/"])["recording"]
    return recording


def _overview(upload: Upload, read: dict[str, Any]) -> RecordingOverview:
    """Return what the reader says, in the reader's language and without the folder of the file."""

    def said(document: Any) -> str:
        return str(from_document(document)).replace(f"{upload.folder}/", "")

    problem = said(read["problem"])
    texts = {
        "dialect": said(read["dialect"]),
        "message": said(read["message"]),
        "problem": whole_sentence(problem) if problem else "",
    }
    joints = [*USUAL_JOINTS, *(column["joint"] for column in read["columns"] if column["joint"])]
    choices = [JointChoice(name=name, label=str(_title_of(name))) for name in dict.fromkeys(joints)]
    return RecordingOverview.model_validate({**read, **texts, "name": upload.stored_name, "joints": choices})


def _title_of(joint: str) -> Text | str:
    """Return what people call a joint that a channel can be of."""
    return WHOLE if joint == WHOLE_BODY else joint_title(Joint(name=joint, label=joint_label(joint)))


def _note(database: Database, person: str, name: str, size: int, same_name: SameName) -> None:
    """Log who has stored a recording, and assign it to the patient whose session is open."""
    with database.transaction() as db:
        add_patient_file(db, name)
        write_log(db, person, "file added", kind="signals", size=size, **log_details(same_name))
