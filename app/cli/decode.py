"""`bodydrive decode`: the chain of the live loop over a file of signals, written as a file of commands."""

import io
import json
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from app.cli.common_options import AsJson
from app.cli.errors import InputError
from app.cli.help_text import help_text
from app.cli.output import dialect_summary, print_dialect, warn, write_output
from app.cli.signal_options import (
    ChannelNames,
    SampleRate,
    TimeName,
    TimeUnit,
    reading_options,
    signals_refused,
)
from app.texts import Figure, Text

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    from app.calibration.vocabulary import DriveParameters
    from app.pipeline.replay.batch import DecodedRun
    from app.signals.signals import ReadingOptions, Signals
    from app.source import Source

SUFFIXES = (".parquet", ".csv")


def decode(
    signals: Annotated[Path, typer.Argument(metavar="SIGNALS", help=help_text("cli-help-signals"))],
    profile: Annotated[Path, typer.Option(help=help_text("cli-help-decode-profile"))],
    out: Annotated[Path, typer.Option(help=help_text("cli-help-decode-out"))],
    dead_zone: Annotated[float | None, typer.Option(help=help_text("cli-help-decode-dead-zone"))] = None,
    cutoff: Annotated[float | None, typer.Option(help=help_text("cli-help-decode-cutoff"))] = None,
    *,
    time: TimeName = None,
    unit: TimeUnit = None,
    rate: SampleRate = None,
    channels: ChannelNames = None,
    as_json: AsJson = False,
) -> None:
    """Decode a file of signals with the very chain of the live loop."""
    from app.source import source_description

    if out.suffix not in SUFFIXES:
        raise InputError(Text("cli-decode-suffix", file=str(out)))
    parameters = with_overrides(read_parameters(profile), dead_zone, cutoff)
    options = reading_options(time, unit, rate, channels)
    try:
        recorded, decoded = _decode_file(signals, parameters, options)
    except ValueError as error:
        raise signals_refused(error) from error
    t, source = recorded.t, _source_of(signals)
    write_output(out, _content_of(out, _columns(parameters, t, decoded), source), signals, profile)
    seconds = float(t[-1] - t[0])
    summary = {
        "frames": len(t),
        "seconds": seconds,
        "sample_rate": recorded.sample_rate,
        "out": str(out),
        "source": {**source.model_dump(mode="json"), "description": source_description(source)},
    }
    if as_json:
        typer.echo(json.dumps(summary | dialect_summary(recorded)))
    else:
        typer.echo(Text("cli-decode-done", frames=len(t), seconds=Figure(seconds, 1), out=str(out)))
        print_dialect(recorded, signals)
        typer.echo(Text("cli-source", source=source_description(source)))


def _decode_file(
    signals: Path, parameters: "DriveParameters", options: "ReadingOptions"
) -> "tuple[Signals, DecodedRun]":
    """Return the signals and the decoded run; a recording is decoded at the times of its ticks."""
    import numpy as np

    from app.pipeline.replay.batch import decode_block
    from app.pipeline.replay.rerun import decode_run
    from app.recording.reader import read_run
    from app.signals.signals import read_signals

    recorded = read_signals(signals, parameters.profile.layout, options)
    warn(recorded.damage)
    if signals.is_dir():
        run = read_run(signals)
        try:
            decoded = decode_run(run, parameters)
        except ValueError as error:
            raise InputError(Text("cli-named", name=str(signals), text=error)) from error
        recorded.t = run.frames()["t"]
        return recorded, decoded
    values = recorded.values.astype(np.float32, copy=False)
    return recorded, decode_block(parameters, recorded.sample_rate, recorded.t, values)


def _source_of(signals: Path) -> "Source":
    """Return the source of the signals, which is known for a recording only."""
    from app.recording.reader import read_run
    from app.source import UNKNOWN_SOURCE, source_of_header

    return source_of_header(read_run(signals).meta) if signals.is_dir() else UNKNOWN_SOURCE


def read_parameters(file: Path) -> "DriveParameters":
    """Return the parameter set in `file`; for a calibration profile, with the paper's vocabulary."""
    from pydantic import ValidationError

    from app.calibration.profile import CalibrationProfile
    from app.calibration.vocabulary import DriveParameters, standard_parameters
    from app.sentences import one_sentence

    try:
        document = json.loads(file.read_bytes())
    except OSError as error:
        reason = error.strerror or error
        raise InputError(Text("cli-profile-unreadable", file=str(file), reason=reason)) from error
    except (ValueError, RecursionError) as error:
        raise InputError(Text("cli-profile-no-json", file=str(file))) from error
    try:
        if isinstance(document, dict) and "gestures" in document:
            return DriveParameters.model_validate(document)
        return standard_parameters(CalibrationProfile.model_validate_json(json.dumps(document)))
    except ValidationError as error:
        raise InputError(one_sentence(error, f"--profile {file}")) from error


def with_overrides(parameters: "DriveParameters", dead_zone: float | None, cutoff: float | None) -> "DriveParameters":
    """Return `parameters` with another dead-zone for all gestures and another cutoff, where they are given.

    Where the new dead-zone would reach a gesture's `full`, `full` is moved by as much, up to LARGEST_THRESHOLD.
    """
    from pydantic import ValidationError

    from app.calibration.vocabulary import DriveParameters
    from app.quantities import HIGHEST_CUTOFF, LARGEST_THRESHOLD, LOWEST_CUTOFF
    from app.sentences import one_sentence

    for option, value, least, most in (
        ("dead-zone", dead_zone, 0.0, LARGEST_THRESHOLD - 1.0),
        ("cutoff", cutoff, LOWEST_CUTOFF, HIGHEST_CUTOFF),
    ):
        if value is not None and not least <= value <= most:
            raise InputError(Text(f"cli-range-{option}", value=f"{value:g}", least=f"{least:g}", most=f"{most:g}"))
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
        raise InputError(one_sentence(error, Text("cli-dead-zone-or-cutoff"))) from error


def _columns(
    parameters: "DriveParameters", t: "NDArray[np.float64]", decoded: "DecodedRun"
) -> "dict[str, NDArray[np.float64]]":
    """Return the columns of the output: time, four columns per gesture, controls, twist and pose."""
    columns = {"t": t}
    for i, gesture in enumerate(parameters.gestures):
        columns[f"{gesture.name}_score"] = decoded.score[:, i]
        columns[f"{gesture.name}_rate"] = decoded.rate[:, i]
        columns[f"{gesture.name}_activation"] = decoded.activation[:, i]
        columns[f"{gesture.name}_drive"] = decoded.drive[:, i]
    for name in ("u1", "u2", "v", "omega", "x", "y", "theta"):
        columns[name] = getattr(decoded, name)
    return columns


def _content_of(file: Path, columns: "dict[str, NDArray[np.float64]]", source: "Source") -> bytes:
    """Return what columns of equal length are as a .parquet or .csv file, by the name of the file.

    Both have a column `simulated`: 1 where nobody wore the shirt, 0 where somebody did, NaN where that is unknown.
    Parquet's own metadata hold the description of the source (key `source`).
    """
    import numpy as np
    import pyarrow as pa
    import pyarrow.csv
    import pyarrow.parquet

    from app.source import source_description

    simulated = np.nan if source.simulated is None else float(source.simulated)
    rows = len(next(iter(columns.values())))
    table = pa.table({**columns, "simulated": np.full(rows, simulated)})
    table = table.replace_schema_metadata({"source": source_description(source)})
    content = io.BytesIO()
    if file.suffix == ".csv":
        pyarrow.csv.write_csv(table, content)
    else:
        pyarrow.parquet.write_table(table, content, compression="zstd")
    return content.getvalue()
