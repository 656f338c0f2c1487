"""A backup in one file: a tar archive with the manifest at its end, sealed when there is a passphrase.

It is written and read in one pass, so that it may come from a pipe. Without a passphrase, `tar` reads it as well.
"""

from collections.abc import Callable
from pathlib import Path

from app.backup.contents import Contents
from app.backup.manifest import MOST_BYTES, NAME, Manifest, StoredFile, read_manifest
from app.backup.quiet_files import Nowhere, QuietReader, QuietWriter, Reader, copy_hashed
from app.backup.sealing import MAGIC, SALT, OpeningReader, SealingWriter, Secret, salt_of
from app.backup.tar_stream import DAMAGED, TarStream, members_of
from app.clock import utc_now
from app.refusals import Refusal

Progress = Callable[[int, int], None]
"""Called with the bytes that are done and the bytes of all."""

Store = Callable[[StoredFile, Reader], tuple[int, str]]
"""Reads all of a file's content, and returns its size and its SHA-256."""


def write_backup(
    target: Path, contents: Contents, version: str, secret: Secret | None, *, with_keys: bool, progress: Progress
) -> Manifest:
    """Write the backup and return its manifest; `target` is there only when all of it is on the disk."""
    total, done = sum(source.size for source in contents.sources), 0
    files: list[StoredFile] = []
    with QuietWriter(target) as quiet:
        sealing = None if secret is None else SealingWriter(quiet, secret)
        with TarStream(quiet if sealing is None else sealing) as tar:
            for source in contents.sources:
                try:
                    opened = QuietReader(source.file)
                except FileNotFoundError:
                    continue  # erased, or made part of another file, meanwhile
                with opened:
                    digest = tar.add(source.path, opened, source.size, source.changed)
                files.append(StoredFile(source.path, source.size, digest, source.changed))
                done += source.size
                progress(done, total)
            manifest = Manifest(
                utc_now().isoformat(), version, contents.rows, with_keys, contents.left_out, tuple(files)
            )
            tar.add_bytes(NAME, manifest.encoded())
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
        for member, content in members_of(reader):
            if NAME in found:
                raise Refusal(DAMAGED)
            if member.path == NAME:
                manifest = read_manifest(content.read(MOST_BYTES))
                found[NAME] = member
                continue
            size, digest = store(member, content)
            found[member.path] = StoredFile(member.path, size, digest, member.changed)
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
