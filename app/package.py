"""A zip file that is made step by step: its bytes depend on its content alone, and files of any size go in."""

import shutil
import zipfile
from collections.abc import Callable
from pathlib import Path

FIRST_DAY = (1980, 1, 1, 0, 0, 0)  # of the zip format; the same content gives the same bytes
COPY = 1 << 20  # bytes
PLAIN = {".parquet", ".zip"}  # compressed already
FAST = 1  # level: numbers of sensors hardly get smaller with more time

Step = Callable[[Path], int]
"""Does one part of the work on the zip file, and returns up to which byte the file is final."""


def entry(name: str) -> zipfile.ZipInfo:
    """Return an entry of a zip file that depends on its name alone."""
    info = zipfile.ZipInfo(name, FIRST_DAY)
    info.compress_type = zipfile.ZIP_STORED if Path(name).suffix in PLAIN else zipfile.ZIP_DEFLATED
    info.external_attr = 0o600 << 16
    return info


def add_file(package: zipfile.ZipFile, file: Path, name: str) -> None:
    """Add a file of any size to a zip file, in pieces."""
    package.compresslevel = FAST
    info = entry(name)
    with file.open("rb") as source, package.open(info, "w", force_zip64=True) as target:
        shutil.copyfileobj(source, target, COPY)
