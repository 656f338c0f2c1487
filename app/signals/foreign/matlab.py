"""Reads the variables of a MATLAB file: version 5 and older with scipy, version 7.3 (HDF5) with h5py.

The rows are as many as most numbers agree in. Vectors become columns by their names, matrices a column for each of
their other dimension; names of channels are taken from a list of as many texts. A sampling rate, or the time between
two samples, gives the time where no variable is one. LabChart writes all channels one behind the other.
"""

from collections import Counter
from collections.abc import Collection, Iterator, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

from app.signals.column_names import unique_names
from app.signals.file_table import listed
from app.signals.foreign.recording import OWN_TIME, ForeignRecording, SampledStream, even_times, library, of_streams
from app.signals.time_names import SECONDS, time_names, time_rank, unit_of_word
from app.texts import Text

HDF5: Final = b"\x89HDF\r\n\x1a\n"
PLACES_OF_HDF5: Final = (0, 512)  # where the mark can stand
FEWEST_ROWS: Final = 10
RATES: Final = frozenset(
    (
        *("fs", "sr", "sf", "fps", "srate", "fsample", "sfreq", "framerate", "samplingrate", "samplerate"),
        *("samplingratehz", "sampleratehz", "samplingfrequency", "samplefrequency", "samplingfreq", "samplefreq"),
    )
)
PERIODS: Final = frozenset(("dt", "isi", "interval", "samplinginterval", "sampleinterval", "samplingperiod"))
OF_LABCHART: Final = frozenset(("data", "datastart", "dataend"))
DEEPEST: Final = 6  # levels of structures


@dataclass(slots=True)
class Variables:
    """What a file holds: arrays of numbers, lists of texts, and single numbers, by their full names."""

    arrays: dict[str, NDArray[np.float64]] = field(default_factory=dict)
    texts: dict[str, list[str]] = field(default_factory=dict)
    numbers: dict[str, float] = field(default_factory=dict)
    has_objects: bool = False  # tables and others that only MATLAB reads

    def add(self, name: str, value: NDArray[Any]) -> None:
        """Add an array of numbers, squeezed; empty ones, and those of more than two dimensions, are left out."""
        squeezed = np.squeeze(value)
        if squeezed.ndim == 0:
            self.numbers[name] = float(squeezed)
        elif squeezed.ndim <= 2 and squeezed.size:
            self.arrays[name] = squeezed.astype(np.float64)


def read(file: Path, part: str | None = None) -> ForeignRecording:
    """Return the signals of a MATLAB file.

    Raises
    ------
    ValueError
        One sentence for a file that holds tables, and no arrays.
    """
    with file.open("rb") as opened:
        head = opened.read(1024)
    is_hdf5 = any(head[place:].startswith(HDF5) for place in PLACES_OF_HDF5)
    variables = _of_hdf5(file) if is_hdf5 else _of_version_5(file)
    if variables.arrays.keys() >= OF_LABCHART:
        return _of_labchart(file, variables, part)
    recording = table_of(variables)
    if variables.has_objects and not recording.columns:
        raise ValueError(Text("signals-matlab-objects", file=str(file)))
    return recording


def _of_labchart(file: Path, variables: Variables, part: str | None) -> ForeignRecording:
    """Return the channels that stand in `data` from `datastart` to `dataend`, counted from 1: those of the first block.

    Channels of several sample rates are joined.
    """
    starts, ends = variables.arrays["datastart"], variables.arrays["dataend"]
    titles = variables.texts.get("titles", [])
    count = len(titles) or len(starts)
    given = variables.arrays.get("samplerate", np.full(count, variables.numbers.get("samplerate", np.nan)))
    starts, ends, rates = (values.reshape(count, -1) for values in (starts, ends, given))
    names = unique_names(titles or [f"channel {number}" for number in range(1, count + 1)])
    streams = []
    for rate in sorted({float(rate) for rate in rates[:, 0] if rate > 0}):
        chosen = [index for index in range(count) if rates[index, 0] == rate and starts[index, 0] > 0]
        parts = [variables.arrays["data"][int(starts[index, 0]) - 1 : int(ends[index, 0])] for index in chosen]
        least = min(map(len, parts), default=0)
        if least:
            values = np.column_stack([each[:least] for each in parts])
            own = [names[index] for index in chosen]
            streams.append(SampledStream(f"{rate:g} Hz", even_times(least, rate), values, own, [""] * len(own)))
    recording = of_streams(file, streams, part)
    blocks = starts.shape[1]
    return replace(recording, note=Text("signals-blocks-left-out", count=blocks)) if blocks > 1 else recording


def table_of(variables: Variables) -> ForeignRecording:
    """Return the columns that the variables of a file make."""
    weights: Counter[int] = Counter()
    for values in variables.arrays.values():
        weights[max(values.shape)] += values.size // max(values.shape)
    count = max((length for length in weights if length >= FEWEST_ROWS), key=lambda each: weights[each], default=0)
    columns: dict[str, NDArray[np.float64]] = {}
    left_out: list[str] = []
    for name, values in variables.arrays.items():
        if count not in values.shape:
            left_out += [] if _letters_of(name) in RATES | PERIODS else [name]
            continue
        matrix = values if values.shape[0] == count else values.T
        if matrix.ndim == 1:
            columns[name] = matrix
        elif time_rank(name) is not None:
            columns[name] = matrix[:, 0]  # each channel has its own times, which are those of all
        else:
            named = _names_of(name, matrix.shape[1], variables, columns)
            columns |= dict(zip(named, matrix.T, strict=True))
    rate = _rate_of(variables)
    if rate is not None and not time_names(columns):
        columns = {OWN_TIME: even_times(count, rate), **columns}
    note = Text("signals-variables-left-out", names=listed(left_out)) if left_out and columns else None
    return ForeignRecording(columns, {}, note, rate)


def _names_of(name: str, count: int, variables: Variables, taken: Collection[str]) -> list[str]:
    """Return the names of the columns of a matrix: as many texts of the file, which no other has, or numbers."""
    for texts in variables.texts.values():
        if len(texts) == count and all(texts) and not set(taken).intersection(named := unique_names(texts)):
            return named
    return [f"{name}_{number}" for number in range(1, count + 1)]


def _rate_of(variables: Variables) -> float | None:
    """Return the sample rate (Hz) that a number states, itself or as the time between two samples."""
    equal = {name: float(values.flat[0]) for name, values in variables.arrays.items() if not np.ptp(values)}
    every = {**variables.numbers, **equal}.items()
    numbers = [(_letters_of(name), name, number) for name, number in every if number > 0]
    rates = [number for letters, _, number in numbers if letters in RATES]
    for letters, name, number in numbers:
        if letters in PERIODS:
            unit = unit_of_word("".join(variables.texts.get(f"{name}_units", ["s"]))) or "s"
            rates.append(1.0 / (number * SECONDS[unit]))
    return rates[0] if rates else None


def _letters_of(name: str) -> str:
    """Return the letters of the last part of a name."""
    return "".join(letter for letter in name.rpartition(".")[2].lower() if letter.isalpha())


def _of_version_5(file: Path) -> Variables:
    from scipy.io import loadmat

    content = loadmat(file, squeeze_me=True, struct_as_record=False, chars_as_strings=True)
    found = Variables(has_objects="__function_workspace__" in content)
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
    elif isinstance(value, str):
        found.texts[name] = [value.strip()]
    elif isinstance(value, np.ndarray) and value.dtype.kind in "biuf":
        found.add(name, value)
    elif isinstance(value, np.ndarray) and value.dtype.kind in "UO":
        found.texts.update(_texts(name, value))
        items = [item for item in value.flat if isinstance(item, np.ndarray) and item.dtype.kind in "biuf"]
        if len(items) == value.size and all(item.ndim == 1 for item in items):
            for number, item in enumerate(items, start=1):  # a cell for each channel
                found.add(f"{name}_{number}", item)


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
        found.has_objects = "#subsystem#" in opened

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
