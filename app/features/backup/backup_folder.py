"""A folder of backups, in which a recording is copied once.

`bodydrive-DATE.backup` are the backups. Their files lie in `parts/`: the database of each backup, the uploads and each
recording, one tar archive for each. A part is named after what it holds and a hash of the names, sizes and times of its
files, so that the next backup uses it again unless one of them was changed. `bodydrive-backups.json` says which clinic
the folder belongs to, and with which key it is encrypted; `erased-patients.json` holds the tombstones.
"""

import json
from collections.abc import Callable, Iterable
from dataclasses import dataclass
from datetime import UTC, datetime
from functools import partial
from hashlib import sha256
from pathlib import Path
from typing import Final

from app.clock import utc_now
from app.features.backup.age_files import Secret
from app.features.backup.backup_file import (
    PARTS,
    add_sources,
    manifest_of,
    only_hash,
    part_file,
    read_part,
    write_backup,
    write_part,
)
from app.features.backup.contents import BackupFile, Contents
from app.features.backup.kept_backups import kept_backups
from app.features.backup.manifest import Manifest, StoredFile
from app.file_modes import OWNER_FILE
from app.files import write_atomically
from app.refusals import Refusal
from app.texts import Text

HEADER: Final = "bodydrive-backups.json"
RECORDINGS: Final = "runs"  # the folder of the recordings within the state folder
STAMP: Final = "bodydrive-%Y-%m-%dT%H-%M-%S-%fZ.backup"
PATTERN: Final = "bodydrive-*.backup"

Progress = Callable[[str, int, int], None]
"""Called with what is being done ("store", "verify"), the bytes that are done, and the bytes of all."""


@dataclass(frozen=True, slots=True)
class BackupFolder:
    """A folder of backups, which can be opened with its secret."""

    folder: Path
    secret: Secret | None

    def open(self, clinic: str) -> None:
        """Make the folder one of this clinic's backups, or check that it is, with this secret; Refusal otherwise.

        `clinic` is the mark of the clinic.
        """
        if not self.folder.is_dir():
            raise Refusal(Text("backups-folder-gone-choose", folder=str(self.folder)))
        file = self.folder / HEADER
        sealed = None if self.secret is None else self.secret.sealed
        if not file.exists():
            if any(self.folder.glob(PATTERN)) or (self.folder / PARTS).exists():
                raise Refusal(Text("backups-header-missing", folder=str(self.folder), file=HEADER))
            header = json.dumps({"format": 2, "clinic": clinic, "identity": sealed})
            write_atomically(file, header.encode() + b"\n", OWNER_FILE)
        folder_header = _header(self.folder)
        if folder_header["clinic"] != clinic:
            raise Refusal(Text("backups-of-other-clinic", folder=str(self.folder)))
        if folder_header["identity"] != sealed:
            raise Refusal(Text("backups-of-other-passphrase", folder=str(self.folder)))

    def names(self) -> list[str]:
        """Return the file names of all backups, the newest last."""
        return sorted(file.name for file in self.folder.glob(PATTERN))

    def manifest(self, name: str) -> Manifest:
        """Return the manifest of a backup."""
        return manifest_of(self.folder / name, self.secret)

    def add(self, contents: Contents, version: str, *, with_keys: bool, progress: Progress) -> tuple[str, Manifest]:
        """Store a backup, read all of it back, and return its name and manifest; the oldest ones go.

        Parts that are stored already are not written again. What reads back wrongly is stored again, once.
        """
        stored_parts = self._known_parts()
        for _ in range(2):
            files = self._stored(contents.sources, stored_parts, progress)
            now = utc_now()
            manifest = Manifest(now.isoformat(), version, contents.rows, with_keys, contents.left_out, tuple(files))
            wrong = self._wrong_parts(manifest, progress)
            if not wrong:
                break
            stored_parts = {part: stored for part, stored in stored_parts.items() if part not in wrong}
        else:
            raise Refusal(Text("backups-parts-unequal", files=len(wrong), folder=str(self.folder)))
        name = now.strftime(STAMP)
        write_backup(self.folder / name, self.secret, lambda _: manifest)
        if self.manifest(name) != manifest:
            raise Refusal(Text("backups-unequal-in-folder", folder=str(self.folder)))
        self._remove_old(contents.passed)
        return name, manifest

    def _stored(
        self, sources: Iterable[BackupFile], stored_parts: dict[str, list[StoredFile]], progress: Progress
    ) -> list[StoredFile]:
        parts = _parts_of(sources)
        total = sum(source.size for part_files in parts.values() for source in part_files)
        done, files = 0, []

        def count(size: int) -> None:
            nonlocal done
            done += size
            progress("store", done, total)

        for part, part_files in parts.items():
            if part in stored_parts and self._part(part).exists():
                files += stored_parts[part]
                count(sum(source.size for source in part_files))
            else:
                fill = partial(add_sources, sources=part_files, progress=count, part=part)
                files += write_part(self._part(part), self.secret, fill)
        return files

    def _wrong_parts(self, manifest: Manifest, progress: Progress) -> set[str]:
        """Read every part of a backup back; return those that are missing or whose content is another."""
        done, wrong = 0, set()

        def count(size: int) -> None:
            nonlocal done
            done += size
            progress("verify", done, manifest.size)

        for part in manifest.parts:
            try:
                read_part(self.folder / PARTS, part, manifest, self.secret, only_hash, count)
            except Refusal:
                wrong.add(part)
        return wrong

    def _part(self, part: str) -> Path:
        return self.folder / PARTS / part_file(part, self.secret is not None)

    def _known_parts(self) -> dict[str, list[StoredFile]]:
        """Return the files of each part of the newest backup."""
        parts: dict[str, list[StoredFile]] = {}
        for name in self.names()[-1:]:
            for file in self.manifest(name).files:
                parts.setdefault(file.part, []).append(file)
        return parts

    def _remove_old(self, passed: datetime) -> None:
        """Remove backups that are not to be kept, parts that none names any more, and what a kill has left.

        `passed` is up to when time has really passed: a clock that was set forward makes no backup old.
        """
        moments = {datetime.strptime(name, STAMP).replace(tzinfo=UTC): name for name in self.names()}
        kept_moments = kept_backups(moments, passed)
        for moment, name in moments.items():
            if moment not in kept_moments:
                (self.folder / name).unlink()
        needed = {self._part(part) for name in self.names() for part in self.manifest(name).parts}
        for stored in (self.folder / PARTS).glob("*"):
            if stored not in needed:
                stored.unlink()
        for left in self.folder.glob(".*.part"):
            left.unlink()


def sealed_key_of_folder(folder: Path) -> str | None:
    """Return the encrypted key of a folder of backups, None when it is not encrypted; Refusal when it is none."""
    return _header(folder)["identity"]


def _parts_of(sources: Iterable[BackupFile]) -> dict[str, list[BackupFile]]:
    """Return the files of each part, by the name of the part."""
    groups: dict[str, list[BackupFile]] = {}
    for source in sources:
        folder, _, rest = source.path.partition("/")
        if not rest:
            group = "database"
        elif folder == RECORDINGS:
            group = f"recording-{rest.partition('/')[0]}"
        else:
            group = "uploads"
        groups.setdefault(group, []).append(source)
    return {f"{group}-{_listing_hash(files)}": files for group, files in groups.items()}


def _listing_hash(sources: list[BackupFile]) -> str:
    listing = [(source.path, source.size, source.changed) for source in sources]
    return sha256(json.dumps(listing).encode()).hexdigest()[:16]


def _header(folder: Path) -> dict[str, str | None]:
    try:
        header = json.loads((folder / HEADER).read_bytes())
        clinic, identity = header["clinic"], header["identity"]
        if not isinstance(clinic, str) or not isinstance(identity, str | None):
            raise TypeError
    except (OSError, ValueError, KeyError, TypeError) as error:
        raise Refusal(Text("backups-header-unreadable", folder=str(folder), file=HEADER)) from error
    return {"clinic": clinic, "identity": identity}
