"""A file of signals, decoded with a parameter set, and the file of commands that it becomes."""

import io
import json
from pathlib import Path

import numpy as np
from numpy.typing import NDArray
from pydantic import ValidationError

from app.calibration.profile import CalibrationProfile
from app.calibration.vocabulary import DriveParameters, standard_parameters
from app.cli.errors import InputError
from app.cli.output import warn
from app.pipeline.replay.batch import DecodedRun, decode_block
from app.pipeline.replay.rerun import decode_run
from app.quantities import HIGHEST_CUTOFF, LARGEST_THRESHOLD, LOWEST_CUTOFF
from app.recording.reader import read_run
from app.sentences import one_sentence
from app.signals.signals import Signals, read_signals
from app.source import UNKNOWN_SOURCE, Source, source_of_header, source_words


def decode_file(signals: Path, parameters: DriveParameters) -> tuple[Signals, DecodedRun]:
    """Return the signals and the decoded run; a recording is decoded at the times of its ticks."""
    recorded = read_signals(signals, parameters.profile.layout)
    warn(recorded.damage)
    if signals.is_dir():
        run = read_run(signals)
        try:
            decoded = decode_run(run, parameters)
        except ValueError as error:
            raise InputError(f"{signals}: {error}") from error
        recorded.t = run.frames()["t"]
        return recorded, decoded
    values = recorded.values.astype(np.float32, copy=False)
    return recorded, decode_block(parameters, recorded.sample_rate, recorded.t, values)


def source_of(signals: Path) -> Source:
    """Return the source of the signals, which is known for a recording only."""
    return source_of_header(read_run(signals).meta) if signals.is_dir() else UNKNOWN_SOURCE


def read_parameters(file: Path) -> DriveParameters:
    """Return the parameter set in `file`; for a calibration profile, with the paper's vocabulary."""
    try:
        document = json.loads(file.read_bytes())
    except OSError as error:
        raise InputError(
            f"--profile {file} cannot be read ({error.strerror}): give the file that calibrate wrote"
        ) from error
    except (ValueError, RecursionError) as error:
        raise InputError(f"--profile {file} is not a JSON document: give the file that calibrate wrote") from error
    try:
        if isinstance(document, dict) and "gestures" in document:
            return DriveParameters.model_validate(document)
        return standard_parameters(CalibrationProfile.model_validate_json(json.dumps(document)))
    except ValidationError as error:
        raise InputError(one_sentence(error, f"--profile {file}")) from error


def overridden(parameters: DriveParameters, dead_zone: float | None, cutoff: float | None) -> DriveParameters:
    """Return `parameters` with another dead-zone for all gestures and another cutoff, where they are given.

    Where the new dead-zone would reach a gesture's `full`, `full` is moved by as much, up to LARGEST_THRESHOLD.
    """
    for word, unit, given, least, most in (
        ("--dead-zone", "full movements per second", dead_zone, 0.0, LARGEST_THRESHOLD - 1.0),
        ("--cutoff", "Hz", cutoff, LOWEST_CUTOFF, HIGHEST_CUTOFF),
    ):
        if given is not None and not least <= given <= most:
            raise InputError(f"{word} {given:g}: give {unit} from {least:g} to {most:g}")
    document = parameters.model_dump(mode="json")
    if cutoff is not None:
        document["cutoff"] = cutoff
    if dead_zone is not None:
        for gesture in document["gestures"]:
            if gesture["full"] <= dead_zone:
                gesture["full"] = min(dead_zone + gesture["full"] - gesture["dead_zone"], LARGEST_THRESHOLD)
            gesture["dead_zone"] = dead_zone
    try:
        return DriveParameters.model_validate_json(json.dumps(document))
    except ValidationError as error:
        raise InputError(one_sentence(error, "--dead-zone or --cutoff")) from error


def columns(parameters: DriveParameters, t: NDArray[np.float64], decoded: DecodedRun) -> dict[str, NDArray[np.float64]]:
    """Return the columns of the output: time, four columns per gesture, controls, twist and pose."""
    named = {"t": t}
    for i, gesture in enumerate(parameters.gestures):
        named[f"{gesture.name}_score"] = decoded.score[:, i]
        named[f"{gesture.name}_rate"] = decoded.rate[:, i]
        named[f"{gesture.name}_activation"] = decoded.activation[:, i]
        named[f"{gesture.name}_drive"] = decoded.drive[:, i]
    for name in ("u1", "u2", "v", "omega", "x", "y", "theta"):
        named[name] = getattr(decoded, name)
    return named


def content_of(file: Path, named: dict[str, NDArray[np.float64]], source: Source) -> bytes:
    """Return what columns of equal length are as a .parquet or .csv file, by the name of the file.

    Both have a column `simulated`: 1 where nobody wore the shirt, 0 where somebody did, NaN where that is unknown.
    Parquet's own metadata carry the whole source in words (key `source`).
    """
    import pyarrow as pa
    import pyarrow.csv
    import pyarrow.parquet

    simulated = np.nan if source.simulated is None else float(source.simulated)
    rows = len(next(iter(named.values())))
    table = pa.table({**named, "simulated": np.full(rows, simulated)})
    table = table.replace_schema_metadata({"source": source_words(source)})
    content = io.BytesIO()
    if file.suffix == ".csv":
        pyarrow.csv.write_csv(table, content)
    else:
        pyarrow.parquet.write_table(table, content, compression="zstd")
    return content.getvalue()
