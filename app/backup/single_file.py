"""A backup in one file: a tar archive with the manifest at its end, sealed when there is a passphrase.

It is written and read in one pass, so that it may come from a pipe. Without a passphrase, `tar` reads it as well.
"""

import tarfile
from collections.abc import Callable
from pathlib import Path
from typing import Any, Final

from app.backup.contents import Contents
from app.backup.manifest import MOST_BYTES, NAME, Manifest, StoredFile, is_safe, read_manifest
from app.backup.quiet_files import (
    PART,
    Nowhere,
    QuietReader,
    QuietWriter,
    Reader,
    copy_hashed,
)
from app.backup.sealing import MAGIC, SALT, OpeningReader, SealingWriter, Secret, salt_of
from app.clock import utc_now
from app.refusals import Refusal

Progress = Callable[[int, int], None]
"""Called with the bytes that are done and the bytes of all."""

Store = Callable[[StoredFile, Reader], tuple[int, str]]
"""Reads all of a file's content, and returns its size and its SHA-256."""

CHANGED: Final = "was changed while it was copied: try again"
DAMAGED: Final = "This backup is damaged or was cut off: take another one."


def write_backup(
    target: Path, contents: Contents, version: str, secret: Secret | None, *, with_keys: bool, progress: Progress
) -> Manifest:
    """Write the backup and return its manifest; `target` is there only when all of it is on the disk."""
    total, done = sum(source.size for source in contents.sources), 0
    files: list[StoredFile] = []
    with QuietWriter(target) as quiet:
        sealing = None if secret is None else SealingWriter(quiet, secret)
        out: Any = quiet if sealing is None else sealing
        with tarfile.open(fileobj=out, mode="w|", format=tarfile.PAX_FORMAT, bufsize=PART) as tar:
            for source in contents.sources:
                try:
                    opened = QuietReader(source.file)
                except FileNotFoundError:
                    continue  # erased, or made part of another file, meanwhile
                with opened:
                    tar.addfile(_header(source.path, source.size, source.changed))
                    size, digest = copy_hashed(opened, tar.fileobj)  # type: ignore[arg-type]
                    if size != source.size:
                        raise Refusal(f"{source.file} {CHANGED}.")
                    tar.fileobj.write(b"\0" * (-size % tarfile.BLOCKSIZE))  # type: ignore[union-attr]
                    tar.offset += size + (-size % tarfile.BLOCKSIZE)
                files.append(StoredFile(source.path, size, digest, source.changed))
                done += size
                progress(done, total)
            manifest = Manifest(
                utc_now().isoformat(), version, contents.rows, with_keys, contents.left_out, tuple(files)
            )
            encoded = manifest.encoded()
            tar.addfile(_header(NAME, len(encoded), 0))
            tar.fileobj.write(encoded + b"\0" * (-len(encoded) % tarfile.BLOCKSIZE))  # type: ignore[union-attr]
            tar.offset += len(encoded) + (-len(encoded) % tarfile.BLOCKSIZE)
        if sealing is not None:
            sealing.end()
        quiet.keep()
    return manifest


def check_only(_file: StoredFile, content: Reader) -> tuple[int, str]:
    """Keep nothing of a file."""
    return copy_hashed(content, Nowhere())


def read_backup(file: Path, secret: Secret | None, store: Store = check_only) -> Manifest:
    """Read a whole backup, check every hash, and return its manifest; `store` receives each file.

    Raises
    ------
    Refusal
        In one sentence, when it is damaged, of a newer program, or sealed with another passphrase.
    OSError
        When it cannot be read.
    """
    found: dict[str, StoredFile] = {}
    with QuietReader(file) as quiet:
        reader: Reader = quiet if secret is None else OpeningReader(quiet, secret)
        try:
            with tarfile.open(fileobj=reader, mode="r|", bufsize=PART) as tar:  # type: ignore[call-overload]
                for member in tar:
                    content = tar.extractfile(member)
                    if content is None or not is_safe(member.name) or NAME in found:
                        raise Refusal(DAMAGED)
                    if member.name == NAME:
                        manifest = read_manifest(content.read(MOST_BYTES))
                        found[NAME] = StoredFile(NAME, member.size, "", 0)
                        continue
                    known = StoredFile(member.name, member.size, "", int(float(member.mtime) * 1e9))
                    size, digest = store(known, content)
                    found[member.name] = StoredFile(member.name, size, digest, known.changed)
            while reader.read(PART):
                pass  # of a sealed backup, the last chunk proves that nothing was cut off
        except (tarfile.TarError, EOFError, ValueError) as error:
            raise Refusal(DAMAGED) from error
    if NAME not in found:
        raise Refusal(DAMAGED)
    del found[NAME]
    if {one.path: (one.size, one.sha256) for one in manifest.files} != {
        one.path: (one.size, one.sha256) for one in found.values()
    }:
        raise Refusal(DAMAGED)
    return manifest


def salt_of_file(file: Path) -> bytes | None:
    """Return the passphrase's salt of a sealed backup, None when it is not sealed."""
    with file.open("rb") as opened:
        return salt_of(opened.read(len(MAGIC) + SALT))


def _header(path: str, size: int, changed: int) -> tarfile.TarInfo:
    header = tarfile.TarInfo(path)
    header.size, header.mode, header.mtime = size, 0o600, changed // 1_000_000_000
    return header
