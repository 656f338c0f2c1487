"""`bodydrive decode`: the chain of the live loop over a file."""

import json
from pathlib import Path
from typing import Annotated

import typer

from app.cli.errors import InputError
from app.cli.output import dialect_summary, print_dialect, write_output

SUFFIXES = (".parquet", ".csv")


def decode(
    signals: Annotated[Path, typer.Argument(metavar="SIGNALS", help="CSV or Parquet, or the folder of a recording.")],
    profile: Annotated[Path, typer.Option(help="What `bodydrive calibrate` wrote, or a saved parameter set.")],
    out: Annotated[Path, typer.Option(help="Where the commands go: .parquet or .csv.")],
    dead_zone: Annotated[
        float | None, typer.Option(help="From where every gesture counts, full movements per second.")
    ] = None,
    cutoff: Annotated[float | None, typer.Option(help="Tremor damping, Hz: lower damps more.")] = None,
    as_json: Annotated[bool, typer.Option("--json", help="Print one JSON object and nothing else.")] = False,
) -> None:
    """Decode a file of signals with the very chain of the live loop."""
    from app.cli.decoded_file import columns, content_of, decode_file, overridden, read_parameters, source_of
    from app.source import source_words

    if out.suffix not in SUFFIXES:
        raise InputError(f"--out {out}: its name must end in {' or '.join(SUFFIXES)}")
    parameters = overridden(read_parameters(profile), dead_zone, cutoff)
    try:
        recorded, decoded = decode_file(signals, parameters)
    except ValueError as error:
        raise InputError(str(error)) from error
    t, source = recorded.t, source_of(signals)
    write_output(out, content_of(out, columns(parameters, t, decoded), source), signals, profile)
    summary = {
        "frames": len(t),
        "seconds": float(t[-1] - t[0]),
        "sample_rate": recorded.sample_rate,
        "out": str(out),
        "source": {**source.model_dump(mode="json"), "words": source_words(source)},
    }
    if as_json:
        typer.echo(json.dumps(summary | dialect_summary(recorded)))
    else:
        typer.echo(f"{summary['frames']} frames, {summary['seconds']:.1f} s, decoded into {out}")
        print_dialect(recorded, signals)
        typer.echo(f"Source: {source_words(source)}")
