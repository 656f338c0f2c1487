"""Write and read a tar archive in one pass, with the SHA-256 of each file."""

import io
import tarfile
from collections.abc import Iterator
from contextlib import contextmanager
from hashlib import sha256
from typing import Any, Final

from app.features.backup.manifest import DAMAGED, StoredFile, is_safe
from app.features.backup.quiet_files import PART, Reader, Writer
from app.refusals import Refusal
from app.texts import Text

NANOSECONDS: Final = 1_000_000_000


class HashedTar:
    """Writes an archive of files that only their owner can read."""

    def __init__(self, tar: tarfile.TarFile) -> None:
        self._tar = tar

    def add(self, path: str, content: Reader, size: int, changed: int = 0) -> str:
        """Add the next `size` bytes of `content` as a file, and return their SHA-256; Refusal when there are fewer.

        `changed` is when the file was changed, in ns since 1970.
        """
        header = tarfile.TarInfo(path)
        header.size, header.mode, header.mtime = size, 0o600, changed // NANOSECONDS
        hashed: Any = _Hashed(path, content)
        self._tar.addfile(header, hashed)
        return str(hashed.digest.hexdigest())

    def add_bytes(self, path: str, content: bytes) -> str:
        """Add a file with this content, and return its SHA-256."""
        return self.add(path, io.BytesIO(content), len(content))


@contextmanager
def hashed_tar(out: Writer) -> Iterator[HashedTar]:
    """Yield an archive that is written to `out`; its end is written unless an exception is raised."""
    sink: Any = out
    tar = tarfile.open(  # noqa: SIM115  (`with` would write the end after an exception too)
        fileobj=sink, mode="w|", format=tarfile.PAX_FORMAT, bufsize=PART
    )
    yield HashedTar(tar)
    tar.close()


class _Hashed:
    """Hashes what is read, and gives as many bytes as it is asked for."""

    def __init__(self, path: str, content: Reader) -> None:
        self._path, self._content = path, content
        self.digest = sha256()

    def read(self, size: int, /) -> bytes:
        content = bytearray()
        while len(content) < size:
            part = self._content.read(size - len(content))
            if not part:
                raise Refusal(Text("backups-changed-meanwhile", file=self._path))
            content += part
        self.digest.update(content)
        return bytes(content)


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
            pass  # of an encrypted archive, the last chunk proves that nothing was cut off
    except (tarfile.TarError, EOFError, ValueError) as error:
        raise Refusal(DAMAGED) from error
