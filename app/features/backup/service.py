"""Make a backup of a clinic, in one file or in a folder of backups, and read it back; also while the clinic is open."""

import fcntl
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path

from app import __version__
from app.clock import utc_now
from app.features.backup.age_files import Secret
from app.features.backup.backup_file import add_sources, read_backup, write_backup
from app.features.backup.backup_folder import BackupFolder
from app.features.backup.contents import clinic_mark, contents_of
from app.features.backup.hashed_tar import HashedTar
from app.features.backup.manifest import Manifest, left_out_text
from app.file_modes import OWNER_FOLDER
from app.refusals import Conflict, Refusal
from app.settings import Settings
from app.store.keeping.tombstones import add_tombstones, read_tombstones
from app.texts import Text

Progress = Callable[[str, int, int], None]
"""Called with what is being done ("store", "verify"), the bytes that are done, and the bytes of all."""


@dataclass(frozen=True, slots=True)
class MadeReport:
    """A good backup, in words and figures."""

    name: str  # of the file
    message: Text | None  # what was left out; None when nothing was
    files: int
    bytes: int
    hash: str  # of all
    encrypted: bool
    with_keys: bool


def make_backup(
    settings: Settings, target: Path, secret: Secret | None, *, with_keys: bool, progress: Progress
) -> MadeReport:
    """Make a backup and read all of it back; `target` is a file that is not there yet, or a folder of backups.

    Raises
    ------
    Refusal
        In one sentence; no backup is left behind.
    OSError
        When something cannot be read or written, likewise.
    """
    with _one_at_a_time(settings):
        if target.is_dir():
            folder = BackupFolder(target, secret)
            folder.open(clinic_mark(settings))
            add_tombstones(target / settings.erased.name, read_tombstones(settings.erased))
            with contents_of(settings, with_keys=with_keys) as contents:
                name, manifest = folder.add(contents, __version__, with_keys=with_keys, progress=progress)
        else:
            name, manifest = target.name, _in_one_file(settings, target, secret, with_keys, progress)
    return _report(name, manifest, secret)


def _in_one_file(
    settings: Settings, target: Path, secret: Secret | None, with_keys: bool, progress: Progress
) -> Manifest:
    if target.exists():
        raise Refusal(Text("backups-file-there", file=str(target)))
    if not target.absolute().parent.is_dir():
        raise Refusal(Text("backups-no-folder-for-file", folder=str(target.absolute().parent)))
    with contents_of(settings, with_keys=with_keys) as contents:
        total, done = sum(source.size for source in contents.sources), 0

        def count(size: int) -> None:
            nonlocal done
            done += size
            progress("store", done, total)

        def fill(tar: HashedTar) -> Manifest:
            files = tuple(add_sources(tar, contents.sources, count))
            return Manifest(utc_now().isoformat(), __version__, contents.rows, with_keys, contents.left_out, files)

        written = write_backup(target, secret, fill)
    progress("verify", 0, written.size)
    unequal = Text("backups-unequal", file=str(target))
    try:
        if read_backup(target, secret) != written:
            raise Refusal(unequal)
    except (Refusal, OSError) as error:
        target.unlink(missing_ok=True)
        raise Refusal(unequal) from error
    return written


@contextmanager
def _one_at_a_time(settings: Settings) -> Iterator[None]:
    settings.backup.mkdir(mode=OWNER_FOLDER, parents=True, exist_ok=True)
    with (settings.backup / "lock").open("a") as file:
        try:
            fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except OSError as error:
            raise Conflict(Text("backups-other-under-way")) from error
        yield


def _report(name: str, manifest: Manifest, secret: Secret | None) -> MadeReport:
    return MadeReport(
        name=name,
        message=left_out_text(manifest.left_out),
        files=len(manifest.files),
        bytes=manifest.size,
        hash=manifest.hash,
        encrypted=secret is not None,
        with_keys=manifest.with_keys,
    )
