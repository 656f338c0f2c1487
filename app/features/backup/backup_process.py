"""The process that makes a backup for the web process, at the lowest priority.

It is asked for one `BackupJob`, and answers with a `BackupMessage` as it goes on and at the end.
"""

from dataclasses import asdict
from pathlib import Path
from typing import Any, Final, TypedDict, cast

from app.child_process import prepare_child, questions, respond
from app.clock import monotonic
from app.features.backup.age_files import Secret
from app.features.backup.service import make_backup
from app.file_modes import keep_new_files_private
from app.refusals import Refusal
from app.settings import Settings
from app.texts import Text, text_of, to_document

REPORT_EVERY: Final = 0.5  # s


class BackupJob(TypedDict):
    """The question to this process: which clinic to back up, where to, and how."""

    state: str  # folder of the clinic
    target: str
    with_keys: bool
    secret: dict[str, str] | None  # fields of `Secret`; None: not encrypted


class BackupMessage(TypedDict, total=False):
    """How far the backup is; or at the end what was made, or why nothing was."""

    step: str  # store or verify
    done: int  # bytes
    total: int  # bytes
    made: dict[str, Any]  # fields of `MadeReport`; its message is the document of a text, or None
    refused: Any  # the document of a text


def main() -> None:
    """Make one backup, and say how it goes."""
    prepare_child(lowest_priority=True)
    keep_new_files_private()
    job = cast(BackupJob, next(questions()))
    secret = None if job["secret"] is None else Secret(**job["secret"])
    last = [monotonic()]

    def progress(step: str, done: int, total: int) -> None:
        if monotonic() - last[0] >= REPORT_EVERY:
            last[0] = monotonic()
            respond({"step": step, "done": done, "total": total})

    try:
        report = make_backup(
            Settings(state=Path(job["state"])),
            Path(job["target"]),
            secret,
            with_keys=job["with_keys"],
            progress=progress,
        )
    except Refusal as refusal:
        respond({"refused": to_document(text_of(refusal))})
    except Exception as error:
        respond({"refused": to_document(description(error))})
    else:
        respond({"made": asdict(report) | {"message": report.message and to_document(report.message)}})


def description(error: Exception) -> Text:
    """Return in one sentence why a backup failed."""
    why = getattr(error, "strerror", None) or str(error).partition("\n")[0] or type(error).__name__
    place = getattr(error, "filename", None)
    if place:
        return Text("backups-failed-at", problem=why, place=str(place))
    return Text("backups-failed", problem=why)


if __name__ == "__main__":
    main()
