"""Writes the file of an archive, recording by recording.

`archive.json` has the hash of every file. A zip file's directory stands at its end, and names its files in any order:
so `archive.json` is written last and named first. Each recording is read once, and a browser or a proxy that waits for
the archive gets the first bytes before any recording was read.
"""

import json
import zipfile
from collections.abc import Callable
from functools import partial
from hashlib import sha256
from pathlib import Path
from typing import Any

from app.exports.archive.archive_list import (
    CHUNK,
    LIST,
    PATIENT,
    REPORT,
    RUN_FILE,
    ArchiveList,
    FileEntry,
    entry_of,
    hash_of,
)
from app.package import Step, entry

MakeReport = Callable[[], bytes]


def archive_steps(clinic: str, tables: Any, folders: list[Path], make_report: MakeReport | None) -> list[Step]:
    """Return the steps that write an archive of a patient's rows and of the recordings in `folders`.

    They are called one after the other with the file to be made: the first writes the documents, one for each folder
    its recording, the last the list. `make_report` returns the content of `report.html`; None: there is no report.
    """
    begin = partial(_begin, tables, make_report)
    recordings = (partial(_add_recording, folder) for folder in sorted(folders))
    return [begin, *recordings, partial(_add_list, clinic)]


def recorded_files(folder: Path) -> list[tuple[str, Path]]:
    """Return the files of a recording that belong to an archive, with their names in it."""
    named = [(f"runs/{folder.name}/{file.name}", file) for file in sorted(folder.glob("*"))]
    return [(name, file) for name, file in named if RUN_FILE.fullmatch(name)]


def _begin(tables: Any, make_report: MakeReport | None, package: Path) -> int:
    contents = {PATIENT: json.dumps({"tables": tables}, indent=1, sort_keys=True, ensure_ascii=False).encode()}
    if make_report is not None:
        contents[REPORT] = make_report()
    package.unlink(missing_ok=True)
    with zipfile.ZipFile(package, "x") as opened:
        for name, content in contents.items():
            info = entry(name)
            info.comment = entry_of(content).sha256.encode()
            opened.writestr(info, content)
        return opened.start_dir


def _add_recording(folder: Path, package: Path) -> int:
    with zipfile.ZipFile(package, "a") as opened:
        for name, file in recorded_files(folder):
            _add(opened, file, name)
        return opened.start_dir


def _add(package: zipfile.ZipFile, file: Path, name: str) -> None:
    """Add a file as it is; its hash stands in the comment of its entry until the list is written."""
    info = entry(name)
    info.compress_type = zipfile.ZIP_STORED
    digest = sha256()
    with file.open("rb") as source, package.open(info, "w", force_zip64=True) as target:
        while chunk := source.read(CHUNK):
            digest.update(chunk)
            target.write(chunk)
    info.comment = digest.hexdigest().encode()


def _add_list(clinic: str, package: Path) -> int:
    with zipfile.ZipFile(package, "a") as opened:
        files = {}
        for info in opened.filelist:
            files[info.filename] = FileEntry(bytes=info.file_size, sha256=info.comment.decode())
            info.comment = b""
        report = files.pop(REPORT, None)
        listed = ArchiveList(clinic=clinic, hash=hash_of(files), files=files, report=report)
        opened.writestr(entry(LIST), listed.model_dump_json(indent=1))
        opened.filelist.insert(0, opened.filelist.pop())  # the directory names the list first
        return opened.start_dir
