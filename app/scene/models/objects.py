"""3D objects of obstacles: each GLB file is read once, in a process of its own, and the reading is stored beside it."""

import hashlib
import io
import json
from contextlib import suppress
from functools import lru_cache
from pathlib import Path
from typing import Final, NamedTuple
from zipfile import BadZipFile

import numpy as np

from app.files import write_atomically
from app.isolated_reader import ReadingTimeoutError, read_isolated
from app.scene.meshes.bodies import Mesh, Part, Vector
from app.scene.models.object_scale import ScaleAsked, is_probable
from app.texts import Text, from_document, text_of, to_document

MOST_BYTES: Final = 20_000_000
THINNEST: Final = 1e-6  # m
READINGS: Final = ".readings"  # folder beside the objects, with one file for each content
READER: Final = "app.scene.models.glb_import"
MOST_IN_MEMORY: Final = 4  # objects in memory, at most 10 MB each
AS_IT_SAYS: Final = 1.0  # m that one unit of a GLB file is, as glTF has it
REFUSAL_SUFFIX: Final = ".refused.json"
READING_SUFFIX: Final = ".2.npz"  # the number changes when the same file is read otherwise: it is then read again
NO_READING: Final = (OSError, ValueError, KeyError, EOFError, BadZipFile)  # the reading is missing or damaged


class Model(NamedTuple):
    """A 3D object, its middle over the origin."""

    parts: tuple[Part, ...]  # one for each colour
    size: Vector  # m: length (x), width (y), height (z)

    @property
    def faces(self) -> int:
        """The number of triangles."""
        return sum(len(part.mesh.faces) for part in self.parts)

    def scaled(self, length: float, width: float, height: float) -> list[Part]:
        """Return the parts, stretched to another size (m)."""
        factors = np.array([length, width, height]) / np.maximum(self.size, THINNEST)
        return [Part(Mesh(part.mesh.vertices * factors, part.mesh.faces), part.colour) for part in self.parts]


def stored_model(file: Path) -> Model:
    """Return a stored object; its file is read in a process of its own when there is no reading yet.

    Raises
    ------
    ValueError
        One sentence: the file, what is wrong, what to do.
    """
    try:
        changed_at = file.stat().st_mtime_ns
    except OSError as error:
        reason = error.strerror or str(error)
        raise ValueError(Text("object-file-unreadable", file=file.name, reason=reason)) from error
    return _stored(file, changed_at)


@lru_cache(maxsize=MOST_IN_MEMORY)
def _stored(file: Path, _changed_at: int) -> Model:
    reading = reading_of(file, file.parent / READINGS)
    with suppress(*NO_READING):
        return _read_reading(reading)
    refused = reading.with_suffix(REFUSAL_SUFFIX)
    if refused.exists():
        raise ValueError(from_document(json.loads(refused.read_bytes())))
    try:
        _read_apart(file, file.parent / READINGS, AS_IT_SAYS)
    except ReadingTimeoutError:
        raise
    except ValueError as error:
        remembered = json.dumps(to_document(text_of(error)))
        write_atomically(refused, remembered.encode())  # stored by an older version; remembered, not read again
        raise
    return _read_reading(reading)


def read_isolated_into(folder: Path, file: Path, metres_per_unit: float | None = None) -> None:
    """Read an object before it is stored in `folder`, and store its reading; a refused object leaves nothing there.

    The file is rewritten in metres when `metres_per_unit` is given and not 1.

    Raises
    ------
    ValueError
        One sentence: the file, what is wrong, what to do.
    ScaleAsked
        When no unit is given, and the object's size in metres is improbable.
    """
    size = _read_apart(file, folder / READINGS, metres_per_unit)
    if metres_per_unit is None and not is_probable(size):
        raise ScaleAsked(file.name, size)


def _read_apart(file: Path, readings: Path, metres_per_unit: float | None) -> Vector:
    question = {"file": str(file), "readings": str(readings), "metres_per_unit": metres_per_unit}
    length, width, height = read_isolated(READER, question)["size"]
    return length, width, height


def write_reading(model: Model, file: Path) -> None:
    """Write an object as NumPy's .npz without pickles."""
    arrays = {"size": np.array(model.size), "colours": np.array([part.colour for part in model.parts])}
    for i, part in enumerate(model.parts):
        arrays[f"vertices{i}"], arrays[f"faces{i}"] = part.mesh.vertices, part.mesh.faces
    content = io.BytesIO()
    np.savez(content, allow_pickle=False, **arrays)
    write_atomically(file, content.getvalue())


def _read_reading(file: Path) -> Model:
    with file.open("rb") as opened, np.load(opened, allow_pickle=False) as arrays:
        length, width, height = map(float, arrays["size"])
        parts = [
            Part(Mesh(arrays[f"vertices{i}"], arrays[f"faces{i}"]), (int(red), int(green), int(blue)))
            for i, (red, green, blue) in enumerate(arrays["colours"])
        ]
    return Model(tuple(parts), (length, width, height))


def reading_of(file: Path, readings: Path) -> Path:
    """Return the path of a file's reading, by the file's content: files may be replaced, renamed or restored."""
    try:
        with file.open("rb") as opened:
            content = opened.read(MOST_BYTES + 1)
    except OSError as error:
        reason = error.strerror or str(error)
        raise ValueError(Text("object-file-unreadable", file=file.name, reason=reason)) from error
    return readings / f"{hashlib.sha256(content).hexdigest()}{READING_SUFFIX}"
