"""Write and read a tar archive in one pass, each content hashed as it goes by."""

import io
import tarfile
from collections.abc import Iterator
from typing import Any, Final

from app.backup.manifest import StoredFile, is_safe
from app.backup.quiet_files import PART, Reader, Writer, copy_hashed
from app.refusals import Refusal

DAMAGED: Final = "This file is damaged or was cut off: take another one."
NANOSECONDS: Final = 1_000_000_000


class TarStream:
    """Writes an archive of files that only their owner can read."""

    def __init__(self, out: Writer) -> None:
        sink: Any = out
        self._tar: Any = tarfile.open(  # noqa: SIM115  (closed by __exit__)
            fileobj=sink, mode="w|", format=tarfile.PAX_FORMAT, bufsize=PART
        )

    def add(self, path: str, content: Reader, size: int, changed: int = 0) -> str:
        """Add a file, and return the SHA-256 of its content; Refusal when its size is not `size`."""
        header = tarfile.TarInfo(path)
        header.size, header.mode, header.mtime = size, 0o600, changed // NANOSECONDS
        self._tar.addfile(header)
        stream: Any = self._tar.fileobj
        found, digest = copy_hashed(content, stream)
        if found != size:
            raise Refusal(f"{path} was changed while it was copied: try again.")
        padding = -size % tarfile.BLOCKSIZE
        stream.write(b"\0" * padding)
        self._tar.offset += size + padding
        return digest

    def add_bytes(self, path: str, content: bytes) -> str:
        """Add a file with this content, and return its SHA-256."""
        return self.add(path, io.BytesIO(content), len(content))

    def __enter__(self) -> "TarStream":
        """Return the writer."""
        return self

    def __exit__(self, kind: object, *_error: object) -> None:
        """Write the end of the archive, unless an exception was raised."""
        if kind is None:
            self._tar.close()


class _Content:
    """The content of a file within an archive; Refusal where the archive was cut off."""

    def __init__(self, content: Reader) -> None:
        self._content = content

    def read(self, size: int, /) -> bytes:
        """Return the next bytes."""
        try:
            return self._content.read(size)
        except tarfile.TarError as error:
            raise Refusal(DAMAGED) from error


def members_of(reader: Reader) -> Iterator[tuple[StoredFile, Reader]]:
    """Yield each file of an archive, its hash left empty, with its content; read `reader` to its end.

    Raises
    ------
    Refusal
        When it is no archive, was cut off, or names a place outside.
    """
    source: Any = reader
    try:
        with tarfile.open(fileobj=source, mode="r|", bufsize=PART) as tar:
            for member in tar:
                content: Any = tar.extractfile(member) if member.isfile() else None
                if content is None or not is_safe(member.name):
                    raise Refusal(DAMAGED)
                yield (
                    StoredFile(member.name, member.size, "", int(float(member.mtime) * NANOSECONDS)),
                    _Content(content),
                )
        while reader.read(PART):
            pass  # of a sealed archive, the last chunk proves that nothing was cut off
    except (tarfile.TarError, EOFError, ValueError) as error:
        raise Refusal(DAMAGED) from error
