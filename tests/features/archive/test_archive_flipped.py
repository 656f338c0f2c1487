"""Any flipped bit of an archive's file is refused in one sentence, or changes nothing of what is read."""

import random
from contextlib import suppress
from pathlib import Path

from app.features.archive.archive_file import open_archive
from app.features.archive.archive_import import checked_rows

FLIPS = 400


def read(file: Path, folder: Path) -> tuple[object, list[bytes]]:
    folder.mkdir()
    with open_archive(file) as archive:
        rows = checked_rows(archive)
        archive.unpack_recordings(folder, frozenset())
    return rows, [each.read_bytes() for each in sorted(folder.rglob("*")) if each.is_file()]


def test_each_flipped_bit_is_one_sentence_or_changes_nothing(package: Path, tmp_path: Path) -> None:
    whole, content = read(package, tmp_path / "whole"), package.read_bytes()
    recording = content.index(b"PAR1")  # before it stand the documents, behind it the directory of the file
    behind = content.rindex(b"PAR1")
    places = [*range(recording), *range(behind, len(content))]
    dice = random.Random(7)
    for number in range(FLIPS):
        changed = bytearray(content)
        changed[dice.choice(places)] ^= 1 << dice.randrange(8)
        file = tmp_path / "flipped.zip"
        file.write_bytes(changed)
        with suppress(ValueError):
            assert read(file, tmp_path / str(number)) == whole
