"""A folder of backups: each file's content is stored once, under its hash, and each backup is a manifest.

`objects/` holds the contents, `bodydrive-DATE.backup` are the manifests, `bodydrive-backups.json` says whether they are
sealed with a passphrase and which clinic they belong to, and `erased-patients.json` holds the tombstones. In a sealed
folder an object's name is not the hash of its content but a keyed hash (HMAC-SHA256) of that.
"""

import hmac
import io
import json
from collections.abc import Callable, Iterable
from dataclasses import dataclass
from datetime import UTC, datetime
from pathlib import Path
from typing import Final

from app.backup.contents import Contents, Source
from app.backup.kept_backups import kept_backups
from app.backup.manifest import MOST_BYTES, Manifest, StoredFile, read_manifest
from app.backup.quiet_files import Nowhere, QuietReader, QuietWriter, Reader, Writer, copy_hashed, parts_of
from app.backup.sealing import OpeningReader, SealingWriter, Secret, WrongPassphrase
from app.clock import utc_now
from app.file_modes import OWNER_FILE
from app.files import write_atomically
from app.refusals import Refusal

HEADER: Final = "bodydrive-backups.json"
STAMP: Final = "bodydrive-%Y-%m-%dT%H-%M-%S-%fZ.backup"
PATTERN: Final = "bodydrive-*.backup"
OTHER_CLINIC: Final = "holds the backups of another clinic: choose a folder of its own for this one"
OTHER_KEY: Final = "holds backups with another passphrase, or without one: give that, or choose an empty folder"

Progress = Callable[[str, int, int], None]
"""Called with what is being done ("store", "verify"), the bytes that are done, and the bytes of all."""


@dataclass(frozen=True, slots=True)
class BackupFolder:
    """A folder of backups, which can be opened with its secret."""

    folder: Path
    secret: Secret | None

    def open(self, clinic: str) -> None:
        """Make the folder one of this clinic's backups, or check that it is, with this secret; Refusal otherwise.

        `clinic` is the mark of the clinic. A folder that an earlier version made has none: it becomes this clinic's.
        """
        if not self.folder.is_dir():
            raise Refusal(f"The folder {self.folder} is not there: connect the disk it lies on, or choose another.")
        file = self.folder / HEADER
        if not file.exists():
            if any(self.folder.glob(PATTERN)) or (self.folder / "objects").exists():
                raise Refusal(f"{self.folder} holds backups, but its file {HEADER} is missing: choose another folder.")
            self._write_header(clinic)
        if folder_clinic(self.folder) not in {clinic, None}:
            raise Refusal(f"{self.folder} {OTHER_CLINIC}.")
        if folder_salt(self.folder) != (None if self.secret is None else self.secret.salt):
            raise Refusal(f"{self.folder} {OTHER_KEY}.")
        for name in self.names()[-1:]:  # one that another key has sealed cannot be read
            self.manifest(name)
        if folder_clinic(self.folder) is None:
            self._write_header(clinic)

    def names(self) -> list[str]:
        """Return the file names of all backups, the newest last."""
        return sorted(file.name for file in self.folder.glob(PATTERN))

    def manifest(self, name: str) -> Manifest:
        """Return the manifest of a backup."""
        with QuietReader(self.folder / name) as raw:
            content = b"".join(parts_of(self._opened(raw)))
        return read_manifest(content[:MOST_BYTES])

    def add(self, contents: Contents, version: str, *, with_keys: bool, progress: Progress) -> tuple[str, Manifest]:
        """Store a backup, read all of it back, and return its name and manifest; the oldest ones go.

        Contents that are stored already are not written again. What reads back wrongly is stored again, once.
        """
        hashes = self._known_hashes()
        for _ in range(2):
            files = self._stored(contents.sources, hashes, progress)
            wrong = self._wrong_objects(files, progress)
            if not wrong:
                break
            for one in wrong:
                self._object(one.sha256).unlink(missing_ok=True)
            hashes = {}
        else:
            raise Refusal(f"{len(wrong)} files in {self.folder} read back wrongly: this disk is damaged, take another.")
        now = utc_now()
        manifest = Manifest(now.isoformat(), version, contents.rows, with_keys, contents.left_out, tuple(files))
        name = now.strftime(STAMP)
        with QuietWriter(self.folder / name) as out:
            self._write(out, io.BytesIO(manifest.encoded()))
            out.keep()
        if self.manifest(name) != manifest:
            raise Refusal(f"The backup in {self.folder} reads back wrongly: this disk is damaged, take another.")
        self._remove_old(contents.passed)
        return name, manifest

    def check(self, manifest: Manifest, progress: Progress) -> None:
        """Read every file of a backup and check its hash; Refusal when one is wrong."""
        wrong = self._wrong_objects(manifest.files, progress)
        if wrong:
            raise Refusal(f"This backup is damaged: {wrong[0].path} is missing or was changed. Take another one.")

    def read(self, file: StoredFile, out: Writer) -> tuple[int, str]:
        """Write the content of a file to `out`; return its size and SHA-256."""
        with QuietReader(self._object(file.sha256)) as raw:
            return copy_hashed(self._opened(raw), out)

    def _write_header(self, clinic: str) -> None:
        salt = None if self.secret is None else self.secret.salt.hex()
        known = json.dumps({"format": 1, "salt": salt, "clinic": clinic})
        write_atomically(self.folder / HEADER, known.encode() + b"\n", OWNER_FILE)

    def _stored(
        self, sources: Iterable[Source], hashes: dict[tuple[str, int, int], str], progress: Progress
    ) -> list[StoredFile]:
        sources = list(sources)
        total, done, files = sum(source.size for source in sources), 0, []
        for source in sources:
            digest = hashes.get((source.path, source.size, source.changed))
            try:
                if digest is None:
                    with QuietReader(source.file) as opened:
                        _, digest = copy_hashed(opened, Nowhere())
                if not self._object(digest).exists():
                    self._store(source, digest)
            except FileNotFoundError:
                continue  # erased, or made part of another file, meanwhile
            files.append(StoredFile(source.path, source.size, digest, source.changed))
            done += source.size
            progress("store", done, total)
        return files

    def _store(self, source: Source, digest: str) -> None:
        with QuietReader(source.file) as opened, QuietWriter(self._object(digest)) as out:
            if self._write(out, opened) != (source.size, digest):
                raise Refusal(f"{source.file} was changed while it was copied: try again.")
            out.keep()

    def _write(self, out: QuietWriter, content: Reader) -> tuple[int, str]:
        if self.secret is None:
            return copy_hashed(content, out)
        sealing = SealingWriter(out, self.secret)
        found = copy_hashed(content, sealing)
        sealing.end()
        return found

    def _wrong_objects(self, files: Iterable[StoredFile], progress: Progress) -> list[StoredFile]:
        """Read every object of these files back; return those that are missing or whose content is another."""
        each = {file.sha256: file for file in files}
        total, done, wrong = sum(file.size for file in each.values()), 0, []
        for file in each.values():
            try:
                is_right = self.read(file, Nowhere()) == (file.size, file.sha256)
            except (WrongPassphrase, FileNotFoundError):
                is_right = False
            if not is_right:
                wrong.append(file)
            done += file.size
            progress("verify", done, total)
        return wrong

    def _opened(self, raw: Reader) -> Reader:
        return raw if self.secret is None else OpeningReader(raw, self.secret)

    def _object(self, digest: str) -> Path:
        name = digest if self.secret is None else hmac.digest(self.secret.key, digest.encode(), "sha256").hex()
        return self.folder / "objects" / name[:2] / name

    def _known_hashes(self) -> dict[tuple[str, int, int], str]:
        """Return the hashes of the newest backup by path, size and time of the last change."""
        for name in reversed(self.names()):
            return {(file.path, file.size, file.changed): file.sha256 for file in self.manifest(name).files}
        return {}

    def _remove_old(self, passed: datetime) -> None:
        """Remove backups that are not to be kept, objects that none names any more, and what a kill has left.

        `passed` is up to when time has really passed: a clock that was set forward makes no backup old.
        """
        moments = {datetime.strptime(name, STAMP).replace(tzinfo=UTC): name for name in self.names()}
        kept = kept_backups(moments, passed)
        for moment, name in moments.items():
            if moment not in kept:
                (self.folder / name).unlink()
        needed = {self._object(file.sha256) for name in self.names() for file in self.manifest(name).files}
        for stored in (self.folder / "objects").glob("*/*"):
            if stored not in needed:
                stored.unlink()
        for left in self.folder.glob(".*.part"):
            left.unlink()


def folder_salt(folder: Path) -> bytes | None:
    """Return the passphrase's salt of a folder of backups, None when it is not sealed; Refusal when it is none."""
    salt = _header(folder)["salt"]
    return None if salt is None else bytes.fromhex(salt)


def folder_clinic(folder: Path) -> str | None:
    """Return the mark of the clinic whose backups lie in a folder, None when an earlier version made the folder."""
    return _header(folder).get("clinic")


def _header(folder: Path) -> dict[str, str | None]:
    try:
        known = json.loads((folder / HEADER).read_bytes())
        bytes.fromhex(known["salt"] or "")
        if not isinstance(known.get("clinic"), str | None):
            raise TypeError
    except (OSError, ValueError, KeyError, TypeError, AttributeError) as error:
        raise Refusal(f"{folder} is no folder of backups: its file {HEADER} cannot be read.") from error
    else:
        return dict(known)
