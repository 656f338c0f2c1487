"""Reads the variables of a MATLAB file: version 5 and older with scipy, version 7.3 (HDF5) with h5py.

The rows are as many as most numbers agree in. Vectors become columns by their names, matrices a column for each of
their other dimension; names of channels are taken from a list of as many texts. A sampling rate gives the time where
no variable is one.
"""

from collections import Counter
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

from app.signals.file_table import listed
from app.signals.foreign.recording import OWN_TIME, ForeignRecording, even_times, library, unique_names
from app.signals.time_names import time_names
from app.texts import Text

HDF5: Final = b"\x89HDF\r\n\x1a\n"
PLACES_OF_HDF5: Final = (0, 512)  # where the mark can stand
FEWEST_ROWS: Final = 10
RATES: Final = (
    "fs",
    "srate",
    "samplingrate",
    "samplerate",
    "samplingfrequency",
    "samplefrequency",
    "sfreq",
    "framerate",
)
DEEPEST: Final = 6  # levels of structures


@dataclass(slots=True)
class Variables:
    """What a file holds: arrays of numbers, lists of texts, and single numbers, by their full names."""

    arrays: dict[str, NDArray[np.float64]] = field(default_factory=dict)
    texts: dict[str, list[str]] = field(default_factory=dict)
    numbers: dict[str, float] = field(default_factory=dict)

    def add(self, name: str, value: NDArray[Any]) -> None:
        """Add an array of numbers, squeezed; arrays of more than two dimensions are left out."""
        squeezed = np.squeeze(value)
        if squeezed.ndim == 0:
            self.numbers[name] = float(squeezed)
        elif squeezed.ndim <= 2:
            self.arrays[name] = squeezed.astype(np.float64)


def read(file: Path) -> ForeignRecording:
    """Return the signals of a MATLAB file."""
    with file.open("rb") as opened:
        head = opened.read(1024)
    is_hdf5 = any(head[place:].startswith(HDF5) for place in PLACES_OF_HDF5)
    return table_of(_of_hdf5(file) if is_hdf5 else _of_version_5(file))


def table_of(variables: Variables) -> ForeignRecording:
    """Return the columns that the variables of a file make."""
    weights: Counter[int] = Counter()
    for values in variables.arrays.values():
        weights[max(values.shape)] += values.size // max(values.shape)
    count = max((length for length in weights if length >= FEWEST_ROWS), key=lambda each: weights[each], default=0)
    columns: dict[str, NDArray[np.float64]] = {}
    left_out = []
    for name, values in variables.arrays.items():
        if count not in values.shape:
            left_out.append(name)
            continue
        matrix = values if values.shape[0] == count else values.T
        if matrix.ndim == 1:
            columns[name] = matrix
        else:
            columns |= dict(zip(_names_of(name, matrix.shape[1], variables), matrix.T, strict=True))
    rate = next((rate for name, rate in variables.numbers.items() if _is_rate(name) and rate > 0), None)
    if rate is not None and not time_names(columns):
        columns = {OWN_TIME: even_times(count, rate), **columns}
    note = Text("signals-variables-left-out", names=listed(left_out)) if left_out and columns else None
    return ForeignRecording(columns, {}, note)


def _names_of(name: str, count: int, variables: Variables) -> list[str]:
    """Return the names of the columns of a matrix: texts of the file, of which there are as many, or numbers."""
    texts = next((texts for texts in variables.texts.values() if len(texts) == count and all(texts)), None)
    return unique_names(texts) if texts is not None else [f"{name}_{number}" for number in range(1, count + 1)]


def _is_rate(name: str) -> bool:
    return "".join(letter for letter in name.rpartition(".")[2].lower() if letter.isalpha()) in RATES


def _of_version_5(file: Path) -> Variables:
    from scipy.io import loadmat

    found = Variables()
    content = loadmat(file, squeeze_me=True, struct_as_record=False, chars_as_strings=True)
    for name, value in content.items():
        if not name.startswith("__"):
            _add_value(found, name, value, 0)
    return found


def _add_value(found: Variables, name: str, value: Any, depth: int) -> None:
    """Add a value of scipy: an array, a structure with fields, or a list of texts or of structures."""
    fields: Sequence[str] | None = getattr(value, "_fieldnames", None)
    if fields is not None and depth < DEEPEST:
        for each in fields:
            _add_value(found, f"{name}.{each}", getattr(value, each), depth + 1)
    elif isinstance(value, int | float):
        found.numbers[name] = float(value)
    elif isinstance(value, np.ndarray) and value.dtype.kind in "biuf":
        found.add(name, value)
    elif isinstance(value, np.ndarray) and value.dtype.kind in "UO":
        found.texts.update(_texts(name, value))


def _texts(name: str, value: NDArray[Any]) -> Iterator[tuple[str, list[str]]]:
    """Yield lists of texts: of a cell array, or of each field of a list of structures (labels of channels)."""
    items = list(value.ravel())
    if all(isinstance(item, str) for item in items):
        yield name, [str(item).strip() for item in items]
    for field_name in getattr(items[0], "_fieldnames", ()) if items else ():
        words = [getattr(item, field_name, None) for item in items]
        if all(isinstance(word, str) for word in words):
            yield f"{name}.{field_name}", [str(word).strip() for word in words]


def _of_hdf5(file: Path) -> Variables:
    h5py = library("h5py")
    found = Variables()
    with h5py.File(file, "r") as opened:

        def visit(name: str, item: Any) -> None:
            if name.startswith("#") or not isinstance(item, h5py.Dataset):
                return
            own = name.replace("/", ".")
            kind = bytes(item.attrs.get("MATLAB_class", b"double"))
            if item.dtype.kind in "biuf" and kind not in {b"char", b"cell"}:
                found.add(own, np.asarray(item).T)
            elif kind == b"cell":
                texts = ["".join(map(chr, np.asarray(opened[place]).ravel())) for place in np.asarray(item).ravel()]
                found.texts[own] = [text.strip() for text in texts]

        opened.visititems(visit)
    return found
