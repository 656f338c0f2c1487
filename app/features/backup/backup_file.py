"""The file of a backup: a tar archive with the manifest at its end, and the parts that lie beside it in a folder.

Without a passphrase it is that archive. With one, it is an outer tar archive of three files, which the commands `tar`
and `age` open by themselves: how to do that, the private key (encrypted with the passphrase), and the archive
(encrypted for that key). A part is an archive of files without a manifest, encrypted for the same key.
"""

import tarfile
from collections.abc import Callable, Iterable, Iterator
from contextlib import AbstractContextManager, contextmanager, nullcontext
from io import BytesIO
from pathlib import Path
from typing import Any, Final

from app.features.backup.age_files import Secret, decrypted, encrypted
from app.features.backup.contents import BackupFile
from app.features.backup.hashed_tar import HashedTar, hashed_tar, members_of
from app.features.backup.manifest import DAMAGED, MOST_BYTES, NAME, Manifest, StoredFile, read_manifest
from app.features.backup.quiet_files import PART, QuietReader, QuietWriter, Reader, hash_of
from app.refusals import Refusal
from app.texts import Text

Progress = Callable[[int], None]
"""Called with the number of bytes that were written or read since the last call."""

Store = Callable[[StoredFile, Reader], tuple[int, str]]
"""Reads all of a file's content, and returns its size and its SHA-256."""

PARTS: Final = "parts"  # the folder of the parts
PART_LIST: Final = "parts.txt"  # the names of the parts' files, for who opens a backup without this program
HOW_TO: Final = "HOW-TO-OPEN.txt"
IDENTITY: Final = "identity.age"
CONTENT: Final = "clinic.tar.age"
HOW_TO_WORDS: Final = f"""This backup of bodydrive is opened by the commands tar and age (age-encryption.org):

tar xf FILE {IDENTITY} && age -d {IDENTITY} > key.txt    # asks for the passphrase
tar xOf FILE {CONTENT} | age -d -i key.txt | tar x
for part in $(cat {PART_LIST}); do age -d -i key.txt "FOLDER/{PARTS}/$part" | tar x; done    # in a folder of backups
"""


def only_hash(_file: StoredFile, content: Reader) -> tuple[int, str]:
    """Keep nothing of a file."""
    return hash_of(content)


def write_backup(target: Path, secret: Secret | None, fill: Callable[[HashedTar], Manifest]) -> Manifest:
    """Write the file of a backup, which `fill` fills, and return its manifest.

    `target` is there only when all of it is on the disk.
    """
    with QuietWriter(target) as out:
        with nullcontext() if secret is None else _envelope(out, secret), _archive(out, secret) as tar:
            manifest = fill(tar)
            if manifest.parts:
                tar.add_bytes(PART_LIST, _part_list(manifest, secret))
            tar.add_bytes(NAME, manifest.encoded())
        out.keep()
    return manifest


def write_part(target: Path, secret: Secret | None, fill: Callable[[HashedTar], list[StoredFile]]) -> list[StoredFile]:
    """Write a part, and return its files; without any, there is no part."""
    with QuietWriter(target) as out:
        with _archive(out, secret) as tar:
            files = fill(tar)
        if files:
            out.keep()
    return files


def add_sources(tar: HashedTar, sources: Iterable[BackupFile], progress: Progress, part: str = "") -> list[StoredFile]:
    """Add files to an archive, but for those that were erased, or made part of another file, meanwhile."""
    files = []
    for source in sources:
        try:
            opened = QuietReader(source.file)
        except FileNotFoundError:
            continue
        with opened:
            digest = tar.add(source.path, opened, source.size, source.changed)
        files.append(StoredFile(source.path, source.size, digest, source.changed, part))
        progress(source.size)
    return files


def part_file(part: str, is_encrypted: bool) -> str:
    """Return the file name of a part."""
    return f"{part}.tar.age" if is_encrypted else f"{part}.tar"


def read_backup(
    file: Path, secret: Secret | None, store: Store = only_hash, progress: Progress = lambda _: None
) -> Manifest:
    """Read a whole backup, check every hash, and return its manifest; `store` receives each file.

    Raises
    ------
    Refusal
        In one sentence, when it is damaged, of another version, or encrypted for another passphrase.
    OSError
        When it cannot be read.
    """
    manifest, stored = _read(file, secret, store, progress)
    require_equal([listed for listed in manifest.files if not listed.part], stored)
    for part in manifest.parts:
        read_part(file.parent / PARTS, part, manifest, secret, store, progress)
    return manifest


def read_part(
    folder: Path,
    part: str,
    manifest: Manifest,
    secret: Secret | None,
    store: Store,
    progress: Progress,
) -> None:
    """Read a part of a backup from the folder of parts; Refusal when it is missing, or not as the manifest says."""
    files: list[StoredFile] = []
    name = part_file(part, secret is not None)
    try:
        with QuietReader(folder / name) as quiet, _plain(quiet, secret) as reader:
            for member, content in members_of(reader):
                files.append(_stored(member, content, store))
                progress(member.size)
        require_equal([file for file in manifest.files if file.part == part], files)
    except (Refusal, FileNotFoundError) as error:
        raise Refusal(Text("backups-part-damaged", file=name)) from error


def manifest_of(file: Path, secret: Secret | None) -> Manifest:
    """Return the manifest of a backup."""
    return _read(file, secret, only_hash, lambda _: None)[0]


def require_equal(listed: Iterable[StoredFile], stored: Iterable[StoredFile]) -> None:
    """Raise Refusal unless the files that were found are those that the manifest lists."""
    both = ({file.path: (file.size, file.sha256) for file in files} for files in (listed, stored))
    if next(both) != next(both):
        raise Refusal(DAMAGED)


def sealed_key_of(file: Path) -> str | None:
    """Return the encrypted key of a backup, None when it has none."""
    try:
        with file.open("rb") as opened, tarfile.open(fileobj=opened, mode="r|") as tar:
            for name in (HOW_TO, IDENTITY):
                member = tar.next()
                if member is None or member.name != name or member.size > PART:
                    return None
                content: Any = tar.extractfile(member)
                text: bytes = content.read()
            return text.decode("ascii")
    except (tarfile.TarError, UnicodeDecodeError, AttributeError):
        return None


def _read(file: Path, secret: Secret | None, store: Store, progress: Progress) -> tuple[Manifest, list[StoredFile]]:
    """Return the manifest of a backup's file, and the files that are in it."""
    stored: list[StoredFile] = []
    manifest, listed = None, b""
    with QuietReader(file) as quiet, _content(quiet, secret) as reader:
        for member, content in members_of(reader):
            if manifest is not None:
                raise Refusal(DAMAGED)
            if member.path == NAME:
                manifest = read_manifest(content.read(MOST_BYTES))
            elif member.path == PART_LIST:
                listed = content.read(MOST_BYTES)
            else:
                stored.append(_stored(member, content, store))
                progress(member.size)
    if manifest is None or listed != _part_list(manifest, secret):
        raise Refusal(DAMAGED)
    return manifest, stored


def _part_list(manifest: Manifest, secret: Secret | None) -> bytes:
    return "".join(f"{part_file(part, secret is not None)}\n" for part in manifest.parts).encode()


def _stored(member: StoredFile, content: Reader, store: Store) -> StoredFile:
    size, digest = store(member, content)
    return StoredFile(member.path, size, digest, member.changed)


@contextmanager
def _archive(out: QuietWriter, secret: Secret | None) -> Iterator[HashedTar]:
    with nullcontext(out) if secret is None else encrypted(out, secret) as sink, hashed_tar(sink) as tar:
        yield tar


@contextmanager
def _envelope(out: QuietWriter, secret: Secret) -> Iterator[None]:
    """Write the outer archive around what is written meanwhile; its size is put into its header at the end."""
    head = BytesIO()
    with tarfile.open(fileobj=head, mode="w", format=tarfile.GNU_FORMAT) as tar:
        for name, text in ((HOW_TO, HOW_TO_WORDS), (IDENTITY, secret.sealed)):
            member = tarfile.TarInfo(name)
            member.size, member.mode = len(text), 0o600
            tar.addfile(member, BytesIO(text.encode()))
        begin = tar.offset
    member = tarfile.TarInfo(CONTENT)
    member.mode = 0o600
    out.write(head.getvalue()[:begin] + member.tobuf(tarfile.GNU_FORMAT))
    start = out.written
    yield
    member.size = out.written - start
    out.write(b"\0" * (-member.size % tarfile.BLOCKSIZE + 2 * tarfile.BLOCKSIZE))
    out.overwrite(begin, member.tobuf(tarfile.GNU_FORMAT))


@contextmanager
def _content(quiet: QuietReader, secret: Secret | None) -> Iterator[Reader]:
    """Yield a reader of the archive within the file of a backup."""
    if secret is None:
        yield quiet
        return
    for member, content in members_of(quiet):
        if member.path == CONTENT:
            with decrypted(content, secret) as reader:
                yield reader
            return
    raise Refusal(DAMAGED)


def _plain(quiet: QuietReader, secret: Secret | None) -> AbstractContextManager[Reader]:
    return nullcontext(quiet) if secret is None else decrypted(quiet, secret)
